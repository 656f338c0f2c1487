"""Frames at absolute deadlines: no drift, and after a hold-up of the machine no long catching up."""

from app.clock import Clock

LONGEST_LAG = 1.0  # s: frames that are later than this count as lost, as of a device that went on


class Pace:
    """The deadlines of frames: the first at once, then one every period."""

    __slots__ = ("_clock", "_missed", "_number", "_period", "_start")

    def __init__(self, clock: Clock, sample_rate: float) -> None:
        self._clock = clock
        self._period = 1.0 / sample_rate
        self._start = clock.now()
        self._number = 0  # of the next frame
        self._missed = 0

    def is_due(self) -> bool:
        """Return whether a frame is due now."""
        return self._clock.now() >= self._due

    def wait(self, timeout: float) -> bool:
        """Wait at most `timeout` (s) for the next deadline; True when it has passed, and the one after it is next."""
        now, due = self._clock.now(), self._due
        if due > now:
            if due > now + timeout:
                self._clock.sleep_until(now + timeout)
                return False
            self._clock.sleep_until(due)
        elif now - due > LONGEST_LAG:
            behind = int((now - due) / self._period)
            self._missed += behind
            self._number += behind
        self._number += 1
        return True

    def missed(self) -> int:
        """Return how many frames were lost since the last call."""
        missed, self._missed = self._missed, 0
        return missed

    @property
    def _due(self) -> float:
        return self._start + self._number * self._period
