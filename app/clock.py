"""All access to time: a monotonic clock for control, UTC for labels that people read."""

import time
from datetime import UTC, datetime
from pathlib import Path
from typing import Final, Protocol

# CLOCK_BOOTTIME also counts while the machine sleeps; `time.monotonic` does not on Linux and macOS. After a laptop was
# closed during a drive, the control loop must see a pause and stop.
CLOCK = getattr(time, "CLOCK_BOOTTIME", getattr(time, "CLOCK_MONOTONIC", None))

BOOT: Final = Path("/proc/sys/kernel/random/boot_id")


class Clock(Protocol):
    """A monotonic clock that can wait."""

    def now(self) -> float:
        """Return monotonic seconds."""
        ...

    def sleep_until(self, deadline: float) -> None:
        """Wait until `deadline` (monotonic seconds)."""
        ...


class MonotonicClock:
    """The machine's monotonic clock; steps of the wall clock do not change it."""

    def now(self) -> float:
        """Return monotonic seconds."""
        return monotonic()

    def sleep_until(self, deadline: float) -> None:
        """Sleep until `deadline`; return at once when it has passed."""
        remaining = deadline - monotonic()
        if remaining > 0:
            time.sleep(remaining)


def monotonic() -> float:
    """Return monotonic seconds, including those while the machine slept."""
    return time.monotonic() if CLOCK is None else time.clock_gettime(CLOCK)


def stopwatch() -> float:
    """Return the seconds of the finest monotonic counter, to measure durations."""
    return time.perf_counter()


def utc_now() -> datetime:
    """Return the present time in UTC."""
    return datetime.now(UTC)


def boot_name() -> str:
    """Return a name of this start of the machine, within which `monotonic` goes on; empty where there is none."""
    try:
        return BOOT.read_text(encoding="ascii").strip() if CLOCK is not None else ""
    except (OSError, ValueError):
        return ""
