"""One limb of the simulated person: up along a minimum-jerk curve, and slowly back to rest."""

from app.hardware.body.minimum_jerk import minimum_jerk

REUSABLE = 0.12  # of the range: nearer to rest than this, a limb can make its next stroke


class Limb:
    """Where a limb is between rest (0) and the end of its range (1)."""

    __slots__ = ("_back", "_low", "_rise", "_start", "_top", "aside")

    def __init__(self) -> None:
        self._start = -1e9  # s
        self._rise = self._back = 1.0  # s
        self._low = self._top = 0.0
        self.aside = 0.0  # share of the level that goes the limb's second way

    def stroke(self, t: float, size: float, rise: float, back: float) -> float:
        """Begin a stroke of `size` at `t` (s), up in `rise` back in `back` seconds; return what there is room for."""
        self._low = self.level(t)
        self._top = min(1.0, self._low + size)
        self._start, self._rise, self._back = t, rise, back
        return self._top - self._low

    def level(self, t: float) -> float:
        """Return where the limb is at `t` (s), 0 to 1."""
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
        """Return whether the limb has come all the way back."""
        return t - self._start >= self._rise + self._back

    def is_ready(self, t: float) -> bool:
        """Return whether there is room for another stroke."""
        return not self.is_rising(t) and self.level(t) < REUSABLE
