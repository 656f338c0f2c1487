"""Measures one driver against its far end: losses, ages, processor, cuts, junk, a second sender."""

import math
import socket
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sensors.far_ends import run
from sensors.subjects import Subject, opened

from app.clock import MonotonicClock
from app.messages import ALIVE
from app.pipeline.command_fields import Sample
from app.pipeline.loop import LONGEST_WAIT, WAIT_PERIODS
from app.pipeline.process import POLL_EVERY
from app.process.command_channel import CommandServer

PATIENCE = 30.0  # s in which everything has to happen that is waited for
SETTLING = 0.2  # s from the order to move to the first frame that shows it
QUIET = 0.2  # s without a frame, after which none is on its way
ANSWER = 20.0  # s for the answer of a far end


@dataclass
class Measured:
    """What was measured of one driver; times in s."""

    title: str
    what: str
    rate: float  # Hz
    seconds: float
    sent: int = 0  # samples of the far end
    frames: int = 0
    lost: int = 0
    ages: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    processor: float = 0.0  # s of processor in a second
    cuts: int | None = None  # how often it was cut off; None: there is no far end
    found: int = 0  # cuts that were silence, and after which frames came again
    back: float = 0.0  # the longest time from the end of a cut to a frame
    junk: int | None = None  # frames that came of junk; None: no junk reaches the driver
    second: str | None = None  # what became of a second sender; None: there is none
    failure: str = ""  # what ended the measurement; empty: it came to its end


class ReadShirt:
    """A shirt that is read as the control loop reads it, with the commands of pages between two frames."""

    def __init__(self, shirt: Any, link: socket.socket) -> None:
        self.shirt = shirt
        self.frames = 0
        self._clock = MonotonicClock()
        self._commands = CommandServer(link)
        self._wait = min(LONGEST_WAIT, WAIT_PERIODS / shirt.sample_rate)
        self._next_poll = self._clock.now()

    def read(self) -> Any:
        """Return the next frame, None when none came for a short time."""
        frame = self.shirt.read(self._wait)
        self.frames += frame is not None
        now = self._clock.now()
        if now >= self._next_poll:
            self._next_poll = now + POLL_EVERY
            for command in self._commands.poll():
                sample = Sample(page=command["page"], message=command["message"], received=command["received"])
                self.shirt.add_sample(sample.page, bytes.fromhex(sample.message), sample.received)
        return frame

    def reads_until(self, is_enough: Callable[[Any], bool]) -> bool:
        """Read until `is_enough` returns true of a frame or None; return False when that takes too long."""
        until = self._clock.now() + PATIENCE
        while not is_enough(self.read()):
            if self._clock.now() >= until:
                return False
        return True

    def read_until(self, is_enough: Callable[[Any], bool], what: str) -> None:
        """Read until `is_enough` returns true of a frame or None; AssertionError when that takes too long."""
        assert self.reads_until(is_enough), f"{what}: {self.shirt.description()}"

    def read_for(self, seconds: float) -> None:
        """Read for so long (s)."""
        until = self._clock.now() + seconds
        while self._clock.now() < until:
            self.read()

    def quiet_for(self, seconds: float) -> Callable[[Any], bool]:
        """Return a function that says of each frame, or None, whether no frame has come for so long (s)."""
        newest = self._clock.now()

        def is_quiet(frame: Any) -> bool:
            nonlocal newest
            newest = newest if frame is None else self._clock.now()
            return self._clock.now() - newest >= seconds

        return is_quiet


def measure(
    subject: Subject, seconds: float, cuts: int, junk: int, folder: Path, *, least: int = 1, apart: bool = True
) -> Measured:
    """Measure one driver.

    Parameters
    ----------
    subject : Subject
        The driver.
    seconds : float
        For how long it runs at its full rate, s.
    cuts, junk : int
        How often it is cut off, and how many pieces of junk are sent.
    folder : Path
        An empty folder for what the driver and its far end share.
    least : int
        How many frames have to show their time, also when that takes longer than `seconds`.
    apart : bool
        Whether the far end runs in a process of its own, so that its work is not counted; otherwise in a thread.
    """
    measured = Measured(subject.title, subject.what, subject.rate, seconds)
    clock = MonotonicClock()
    ours, theirs = socket.socketpair()
    with ours, theirs, far_end_of(subject, theirs, folder, apart=apart) as told, opened(subject.shirt(folder)) as shirt:
        reading = ReadShirt(shirt, ours)
        ask = partial(told, reading.read)
        ask("go", getattr(shirt, "address", None))
        reading.read_until(shows_time(subject), "no frame shows its time")
        ask("move")
        reading.read_for(SETTLING)
        ages = list[float]()
        sent, first = ask("count"), reading.frames
        began, worked, shown_count = clock.now(), time.process_time(), 0
        while clock.now() - began < seconds or shown_count < least:
            assert clock.now() - began < seconds + PATIENCE, f"too few frames: {shirt.description()}"
            frame = reading.read()
            if frame is not None:
                ages.append(subject.age(frame, clock.now()))
                shown_count += not math.isnan(ages[-1])
        passed, worked = clock.now() - began, time.process_time() - worked
        measured.sent, measured.frames = ask("count") - sent, reading.frames - first
        measured.processor = worked / passed
        shown = np.array(ages)
        measured.lost = int(np.isnan(shown).sum())  # frames without the sensor that shows the time
        measured.ages = shown[~np.isnan(shown)] - (0.0 if subject.far_end else shown.min())
        if subject.far_end and subject.is_counted:
            every = ask("pause")
            reading.read_until(lambda _: reading.frames >= every, f"fewer frames than {every} samples")
            ask("resume")
        measured.lost += shirt.lost
        if subject.far_end:
            measured.cuts = cuts
            came_back = [back for _ in range(cuts) if (back := cut_off(reading, ask, subject)) is not None]
            measured.found, measured.back = len(came_back), max(came_back, default=0.0)
            ask("pause")
            reading.read_until(reading.quiet_for(QUIET), "frames go on")
    measured.junk = subject.junk(folder, junk)
    measured.second = subject.second(folder)
    return measured


def measurement(subject: Subject, seconds: float, cuts: int, junk: int) -> Measured:
    """Measure one driver; what ends the measurement stands in the answer, so that the others are measured."""
    try:
        with tempfile.TemporaryDirectory() as folder:
            return measure(subject, seconds, cuts, junk, Path(folder))
    except Exception as error:
        failure = f"{type(error).__name__}: {error}"
        return Measured(subject.title, subject.what, subject.rate, seconds, failure=failure)


def cut_off(reading: ReadShirt, ask: Any, subject: Subject) -> float | None:
    """Cut a driver off until it is silent; return how long (s) after the end of the cut it has a frame again.

    None: it did not fall silent, or no frame came again.
    """
    clock = MonotonicClock()
    ask("cut")
    was_silent = reading.reads_until(reading.quiet_for(ALIVE))
    ask("mend")
    mended = clock.now()
    came_back = reading.reads_until(shows_time(subject))
    return clock.now() - mended if was_silent and came_back else None


def shows_time(subject: Subject) -> Callable[[Any], bool]:
    """Return a function that says whether a frame, or None, shows when it was measured."""
    return lambda frame: frame is not None and not math.isnan(subject.age(frame, 0.0))


@contextmanager
def far_end_of(subject: Subject, link: socket.socket, folder: Path, *, apart: bool) -> Iterator[Any]:
    """Run the far end of a driver; yield what tells it something and returns how many samples it has sent.

    What is yielded takes a function that reads the driver, for the time until the answer: a far end whose cable is full
    waits for the reader, and answers nothing.
    """
    if subject.far_end is None:
        yield lambda *_: 0
        return
    context = get_context("spawn")
    ours, theirs = context.Pipe()
    start: Any = context.Process if apart else threading.Thread
    far_end = start(target=run, args=(subject.far_end, subject.rate, theirs, link, folder), daemon=True)
    far_end.start()

    def tell(read: Callable[[], object], *what: object) -> int:
        ours.send(what)
        until = time.monotonic() + ANSWER
        while not ours.poll(0):
            assert time.monotonic() < until, f"the far end of {subject.title} does not answer"
            read()
        return ours.recv()

    assert ours.poll(ANSWER), f"the far end of {subject.title} does not start"
    ours.recv()
    try:
        yield tell
    finally:
        ours.send(("end",))
        far_end.join(ANSWER)
