"""One limb of the simulated person: a stroke along a minimum-jerk curve, and a slower return to rest."""

# Compiled in a wheel (hatch_build.py).

from app.hardware.body.minimum_jerk import minimum_jerk

REUSABLE = 0.12  # of the range: below it a limb can make its next stroke


class Limb:
    """The position of a limb between rest (0) and the end of its range (1)."""

    __slots__ = ("_back", "_low", "_rise", "_start", "_top", "aside")

    def __init__(self) -> None:
        self._start = -1e9  # s
        self._rise = self._back = 1.0  # s
        self._low = self._top = 0.0
        self.aside = 0.0  # share of the level in the limb's second degree of freedom

    def stroke(self, t: float, size: float, rise: float, back: float) -> float:
        """Begin a stroke at `t` (s), there in `rise` and back in `back` s; return the size that the range allows."""
        self._low = self.level(t)
        self._top = min(1.0, self._low + size)
        self._start, self._rise, self._back = t, rise, back
        return self._top - self._low

    def level(self, t: float) -> float:
        """Return the position of the limb at `t` (s), 0 to 1."""
        since = t - self._start
        if since < self._rise:
            return min(1.0, self._low + (self._top - self._low) * minimum_jerk(since / self._rise))
        since -= self._rise
        if since < self._back:
            return max(0.0, self._top * (1.0 - minimum_jerk(since / self._back)))
        return 0.0

    def is_rising(self, t: float) -> bool:
        """Return whether the limb still moves into the gesture."""
        return t - self._start < self._rise

    def is_resting(self, t: float) -> bool:
        """Return whether the limb has returned to rest."""
        return t - self._start >= self._rise + self._back

    def is_ready(self, t: float) -> bool:
        """Return whether the limb is close enough to rest for another stroke."""
        return not self.is_rising(t) and self.level(t) < REUSABLE
