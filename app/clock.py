"""The only home of time: monotonic for control, UTC for people."""

import time
from datetime import UTC, datetime
from typing import Protocol

# Counts while the machine sleeps, too, which `time.monotonic` does not on Linux and macOS: a lid that was closed over
# a drive must show as a pause, after which nothing drives on.
CLOCK = getattr(time, "CLOCK_BOOTTIME", getattr(time, "CLOCK_MONOTONIC", None))


class Clock(Protocol):
    """Monotonic seconds and the means to wait."""

    def now(self) -> float:
        """Return monotonic seconds."""
        ...

    def sleep_until(self, deadline: float) -> None:
        """Return no earlier than `deadline` (monotonic seconds)."""
        ...


class MonotonicClock:
    """The machine's own monotonic clock; a step of the wall clock does not touch it."""

    def now(self) -> float:
        """Return monotonic seconds."""
        return monotonic()

    def sleep_until(self, deadline: float) -> None:
        """Sleep until `deadline`; return at once when it has passed."""
        remaining = deadline - monotonic()
        if remaining > 0:
            time.sleep(remaining)


class FakeClock:
    """A clock for tests: time passes only when somebody waits."""

    def __init__(self, start: float = 0.0) -> None:
        self.time = start

    def now(self) -> float:
        """Return the time that has been waited for so far."""
        return self.time

    def sleep_until(self, deadline: float) -> None:
        """Let time jump to `deadline`."""
        self.time = max(self.time, deadline)


def monotonic() -> float:
    """Return monotonic seconds; the machine's sleep counts."""
    return time.monotonic() if CLOCK is None else time.clock_gettime(CLOCK)


def stopwatch() -> float:
    """Return seconds of the finest monotonic counter, for measuring durations."""
    return time.perf_counter()


def utc_now() -> datetime:
    """Return the present moment, in UTC, for labels that people read."""
    return datetime.now(UTC)
