"""Devices are opened in a thread of their own: the control loop never waits for a cable, a file or a name."""

import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple, Protocol, TypeVar

from app.clock import Clock
from app.hardware.base import HardwareError

OPENING_LIMIT = 8.0  # s; the web process waits 10 s for an answer
MOST_STUCK = 8  # threads that never came back: each holds memory for as long as the process lives
LONGEST_REASON = 200  # letters of what a driver raised


class Openable(Protocol):
    """What shirts, head trackers and real chairs have in common."""

    def open(self) -> None:
        """Open the device."""
        ...


Device = TypeVar("Device", bound=Openable)


class Change(NamedTuple):
    """A device to be opened, and what puts it to use."""

    what: str  # as sentences name it: shirt, chair ...
    open: Callable[[], Any]  # off the loop: it may wait, and raise anything
    take: Callable[[Any], None]  # on the loop: it neither waits nor fails


Finish = Callable[[str], None]
"""Called on the loop when a change has ended: with an empty string, or with why the device is not there."""


class Openings:
    """Opens one device at a time in a thread, and gives it up after `OPENING_LIMIT`."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._attempt: _Attempt | None = None
        self._change: Change | None = None
        self._finish: Finish = lambda _why: None
        self._until = 0.0
        self._stuck: list[_Attempt] = []

    @property
    def busy(self) -> bool:
        """Whether a device is being opened."""
        return self._attempt is not None

    def begin(self, change: Change, finish: Finish) -> None:
        """Open the device of `change`; `poll` puts it to use and calls `finish`. Not while busy."""
        self._stuck = [attempt for attempt in self._stuck if attempt.is_alive()]
        if len(self._stuck) >= MOST_STUCK:
            finish(f"The {change.what} is not opened, for {MOST_STUCK} others still hang: start bodydrive again.")
            return
        self._change, self._finish = change, finish
        self._until = self._clock.now() + OPENING_LIMIT
        self._attempt = _Attempt(change)
        self._attempt.start()

    def poll(self) -> None:
        """Go on with what is being opened; to be called on the loop."""
        attempt, change = self._attempt, self._change
        if attempt is None or change is None:
            return
        if attempt.ended.is_set():
            why = attempt.why or _take(change, attempt.device)
        elif self._clock.now() > self._until:
            attempt.give_up()
            self._stuck.append(attempt)
            why = f"The {change.what} did not open within {OPENING_LIMIT:g} seconds: check its settings."
        else:
            return
        self._attempt = self._change = None
        self._finish(why)


def _take(change: Change, device: Any) -> str:
    """Put a device to use; return why that failed, which is a defect, or an empty string."""
    try:
        change.take(device)
    except Exception as error:
        return defect(change.what, error)
    return ""


class _Attempt(threading.Thread):
    """Opens one device; one that comes after it was given up is closed again."""

    def __init__(self, change: Change) -> None:
        super().__init__(name=f"opens the {change.what}", daemon=True)  # one that hangs must not keep the process
        self.device: Any = None
        self.why = ""
        self.ended = threading.Event()
        self._change = change
        self._lock = threading.Lock()
        self._given_up = False

    def run(self) -> None:
        """Open the device."""
        try:
            device = self._change.open()
        except Exception as error:  # whatever a driver does, the loop turns on
            device, self.why = None, reason(error, self._change.what)
        with self._lock:
            if not self._given_up:
                self.device = device
                self.ended.set()
                return
        close_quietly(device)

    def give_up(self) -> None:
        """Give the device up: it is closed when it opens after all."""
        with self._lock:
            self._given_up = not self.ended.is_set()
        if not self._given_up:  # the device opened just before
            close_quietly(self.device)


def open_device(device: Device) -> Device:
    """Open a device and return it; one that fails is closed, and what it raised goes on."""
    try:
        device.open()
    except Exception:
        close_quietly(device)
        raise
    return device


def reason(error: Exception, what: str) -> str:
    """Return why a device cannot be had, in one sentence, whatever its driver raised."""
    if isinstance(error, HardwareError):
        return one_line(str(error))
    words = one_line(str(error))[:LONGEST_REASON]
    why = f"{type(error).__name__}: {words}" if words else type(error).__name__
    return f"The {what} cannot be opened ({why}): check its settings."


def defect(what: str, error: Exception) -> str:
    """Return the sentence for an exception that nobody foresaw."""
    words = one_line(str(error))[:LONGEST_REASON]
    return f"The program has a fault, and '{what}' was not done ({type(error).__name__}: {words}): please report it."


def one_line(text: str) -> str:
    """Return a text with nothing in it but what can be printed on one line."""
    return " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())


def close_quietly(device: Any) -> None:
    """Close a device that is not wanted, if it can be closed; whatever it raises, it is let go."""
    close = getattr(device, "close", None)
    if close is not None:
        with suppress(Exception):
            close()
