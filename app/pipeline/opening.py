"""Opens devices in a thread, so that the control loop never waits for a cable, a file or a name server."""

import threading
from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple, Protocol, TypeVar

from app.clock import Clock
from app.hardware.base import HardwareError
from app.texts import Text, text_of
from app.visible_text import one_line

OPENING_LIMIT = 8.0  # s; the web process waits 10 s for an answer
MOST_STUCK = 8  # threads that never ended: each holds memory until the process ends
LONGEST_REASON = 200  # characters of a driver's error message


class Openable(Protocol):
    """A device that can be opened: shirt, head tracker or real chair."""

    def open(self) -> None:
        """Open the device."""
        ...


Device = TypeVar("Device", bound=Openable)


class DeviceChange(NamedTuple):
    """The change to another device: how to open it, and how to put it to use."""

    what: str  # the device: shirt, body, chair or head tracker
    open: Callable[[], object]  # runs in a thread: may wait, and may raise anything
    use: Callable[[Any], None]  # is given what `open` returned; runs on the loop: neither waits nor fails


Finish = Callable[[Text | str | None], None]
"""Called on the loop at the end of a change: with None, or with the reason why it failed."""


class Openings:
    """Opens one device at a time in a thread; abandons it after `OPENING_LIMIT`."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._attempt: _Attempt | None = None
        self._change: DeviceChange | None = None
        self._finish: Finish = lambda _failure: None
        self._until = 0.0
        self._stuck: list[_Attempt] = []

    @property
    def busy(self) -> bool:
        """Whether a device is being opened."""
        return self._attempt is not None

    def begin(self, change: DeviceChange, finish: Finish) -> None:
        """Begin to open the device of `change`, when not busy; `poll` puts it to use and calls `finish`."""
        self._stuck = [attempt for attempt in self._stuck if attempt.is_alive()]
        if len(self._stuck) >= MOST_STUCK:
            finish(Text("drives-others-hang", device=change.what, count=MOST_STUCK))
            return
        self._change, self._finish = change, finish
        self._until = self._clock.now() + OPENING_LIMIT
        self._attempt = _Attempt(change)
        self._attempt.start()

    def poll(self) -> None:
        """Finish the opening when the device is there or the time is over; to be called on the loop."""
        attempt, change = self._attempt, self._change
        if attempt is None or change is None:
            return
        if attempt.ended.is_set():
            failure = attempt.failure or _use(change, attempt.device)
        elif self._clock.now() > self._until:
            attempt.give_up()
            self._stuck.append(attempt)
            failure = Text("drives-opening-slow", device=change.what, seconds=OPENING_LIMIT)
        else:
            return
        self._attempt = self._change = None
        self._finish(failure)


def _use(change: DeviceChange, device: object) -> Text | None:
    """Put a device to use; return the sentence of a defect when that failed."""
    try:
        change.use(device)
    except Exception as error:
        return defect(change.what, error)
    return None


class _Attempt(threading.Thread):
    """Opens one device; a device that opens after it was abandoned is closed again."""

    def __init__(self, change: DeviceChange) -> None:
        super().__init__(name=f"opens the {change.what}", daemon=True)  # must not keep the process alive
        self.device: object = None
        self.failure: Text | str | None = None
        self.ended = threading.Event()
        self._change = change
        self._lock = threading.Lock()
        self._given_up = False

    def run(self) -> None:
        """Open the device."""
        try:
            device = self._change.open()
        except Exception as error:  # whatever a driver raises, the loop turns on
            device, self.failure = None, reason(error, self._change.what)
        with self._lock:
            if not self._given_up:
                self.device = device
                self.ended.set()
                return
        close_quietly(device)

    def give_up(self) -> None:
        """Abandon the device: it is closed if it opens later."""
        with self._lock:
            self._given_up = not self.ended.is_set()
        if not self._given_up:  # the device opened just before this call
            close_meanwhile(self.device)


def open_device(device: Device) -> Device:
    """Open a device and return it; when that fails, close the device and raise the error again."""
    try:
        device.open()
    except Exception:
        close_quietly(device)
        raise
    return device


def reason(error: Exception, what: str) -> Text | str:
    """Return in one sentence why a device cannot be opened, whatever its driver raised."""
    if isinstance(error, HardwareError):
        return message_of(error)
    if isinstance(error, ModuleNotFoundError) and error.name:
        return Text("drives-library-missing", device=what, library=error.name)
    kind, message = type(error).__name__, message_of(error, LONGEST_REASON)
    if not message:
        return Text("drives-cannot-open", device=what, error=kind)
    return Text("drives-cannot-open-message", device=what, error=kind, message=message)


def defect(what: str, error: Exception) -> Text:
    """Return the sentence for an unforeseen exception."""
    message = message_of(error, LONGEST_REASON)
    return Text("drives-defect", action=what, error=type(error).__name__, message=message)


def message_of(error: Exception, longest: int | None = None) -> Text | str:
    """Return an exception's text; a plain string reduced to printable characters on one line, `longest` at most."""
    message = text_of(error)
    return message if isinstance(message, Text) else one_line(message, longest)


def close_meanwhile(device: object) -> None:
    """Close a device in a thread: some wait for seconds, and the loop must not."""
    threading.Thread(target=close_quietly, args=(device,), name="closes a device", daemon=True).start()


def close_quietly(device: object) -> None:
    """Close a device, if it has `close`, and ignore whatever that raises."""
    close = getattr(device, "close", None)
    if close is not None:
        with suppress(Exception):
            close()
