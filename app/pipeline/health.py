"""Which channels can be believed, and whether too many frames get lost."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.profile import CalibrationProfile

FLAT_TIME = 0.2  # s: fabric always trembles a little; a signal that does not move at all is a broken line
RANGE_FACTOR = 1.5  # of the calibrated half-range: beyond it a value is not this body's
SMALLEST_HALF_RANGE = 1e-9  # signal units: keeps a channel that never moved from dividing by zero
LOSS_WINDOW = 1.0  # s
LOSS_LIMIT = 0.1  # share of frames


class ChannelHealth:
    """Watches each channel for NaN, for values outside 1.5 x the calibrated range, and for standing still."""

    def __init__(self, profile: CalibrationProfile, channels: NDArray[np.intp], sample_rate: float) -> None:
        low, high = np.array(profile.low)[channels], np.array(profile.high)[channels]
        self._middle = (low + high) / 2
        self._per_half_range = 1.0 / np.maximum((high - low) / 2, SMALLEST_HALF_RANGE)
        self._flat_after = max(2, round(FLAT_TIME * sample_rate))
        self._scaled = np.empty(len(low))
        self.reset()

    def reset(self) -> None:
        """Forget how long each channel stood still."""
        count = len(self._middle)
        self._previous = np.full(count, np.nan)
        self._still = np.zeros(count, dtype=np.int32)

    def step(self, values: NDArray[np.float64]) -> NDArray[np.bool_] | None:
        """Return which channels are bad in this frame, or None when all are well.

        `values` (n_watched,), the watched channels in signal units; the caller leaves the array alone afterwards.
        """
        self._still += 1
        self._still[values != self._previous] = 0
        self._previous = values
        scaled = np.subtract(values, self._middle, out=self._scaled)
        scaled *= self._per_half_range
        np.abs(scaled, out=scaled)
        # Written so that a NaN, which compares false to everything, takes the careful way.
        if scaled.max() <= RANGE_FACTOR and self._still.max() < self._flat_after:
            return None
        bad: NDArray[np.bool_] = ~(scaled <= RANGE_FACTOR) | (self._still >= self._flat_after)
        return bad

    def block(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return the same as `step` for all frames (n, n_watched) of a recording at once."""
        scaled = np.abs((values - self._middle) * self._per_half_range)
        bad: NDArray[np.bool_] = ~(scaled <= RANGE_FACTOR)
        rows = np.arange(len(values), dtype=np.int32)[:, np.newaxis]
        changed = np.ones(values.shape, dtype=np.bool_)
        changed[1:] = values[1:] != values[:-1]
        last_change = np.maximum.accumulate(np.where(changed, rows, 0), axis=0)
        return bad | (rows - last_change >= self._flat_after)


class LossWindow:
    """The share of frames that were lost over the last second, in ten bins that are used in turn."""

    BINS = 10

    def __init__(self) -> None:
        self.reset()

    def reset(self) -> None:
        """Forget the losses."""
        self._came = [0] * self.BINS
        self._missing = [0] * self.BINS
        self._bin = 0

    def step(self, t: float, missing: int) -> None:
        """Count one frame that came at `t` (s) after `missing` others that did not."""
        current = int(t * self.BINS / LOSS_WINDOW)
        if current != self._bin:
            for stale in range(max(self._bin + 1, current - self.BINS + 1), current + 1):
                self._came[stale % self.BINS] = self._missing[stale % self.BINS] = 0
            self._bin = current
        self._came[current % self.BINS] += 1
        self._missing[current % self.BINS] += missing

    @property
    def too_lossy(self) -> bool:
        """Whether more than a tenth of the last second's frames are missing."""
        missing = sum(self._missing)
        return missing > 0 and missing > LOSS_LIMIT * (missing + sum(self._came))
