"""Frames at absolute deadlines: no drift, and no endless catching up after the machine stood still."""

from app.clock import Clock

LONGEST_LAG = 1.0  # s: what is later than this is lost, as with a device that went on without us


class Pace:
    """Says when each frame is due: the first one at once, then one every period."""

    __slots__ = ("_clock", "_due", "_missed", "_period")

    def __init__(self, clock: Clock, sample_rate: float) -> None:
        self._clock = clock
        self._period = 1.0 / sample_rate
        self._due = clock.now()
        self._missed = 0

    def is_due(self) -> bool:
        """Return whether a frame is due now."""
        return self._clock.now() >= self._due

    def wait(self, timeout: float) -> bool:
        """Wait at most `timeout` (s) for the next frame; True when it has come and the one after it is next."""
        now = self._clock.now()
        if self._due > now:
            if self._due > now + timeout:
                self._clock.sleep_until(now + timeout)
                return False
            self._clock.sleep_until(self._due)
        elif now - self._due > LONGEST_LAG:
            behind = int((now - self._due) / self._period)
            self._missed += behind
            self._due += behind * self._period
        self._due += self._period
        return True

    def missed(self) -> int:
        """Return how many frames were lost since this was asked last."""
        missed, self._missed = self._missed, 0
        return missed
