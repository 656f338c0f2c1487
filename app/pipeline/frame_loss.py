"""Whether too many frames are lost."""

# Compiled in a wheel (hatch_build.py).

from typing import Final

LOSS_WINDOW: Final = 1.0  # s
LOSS_LIMIT: Final = 0.1  # share of frames


class LossWindow:
    """The share of frames lost over the last second, counted in a ring of ten bins."""

    BINS = 10

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Forget the losses."""
        self._came = [0] * self.BINS
        self._missing = [0] * self.BINS
        self._bin = 0
        self.too_lossy = False
        """Whether more than a tenth of the last second's frames are missing."""

    def step(self, t: float, missing: int) -> None:
        """Count one frame that came at `t` (s), and `missing` frames lost before it."""
        current = int(t * self.BINS / LOSS_WINDOW)
        if current != self._bin:
            for stale in range(max(self._bin + 1, current - self.BINS + 1), current + 1):
                self._came[stale % self.BINS] = self._missing[stale % self.BINS] = 0
            self._bin = current
        place = current % self.BINS
        self._came[place] += 1
        if missing or self.too_lossy:
            self._missing[place] += missing
            lost = sum(self._missing)
            self.too_lossy = lost > LOSS_LIMIT * (lost + sum(self._came))
