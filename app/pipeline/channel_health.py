"""Which channels are bad, and whether too many frames are lost."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.profile import CalibrationProfile

FLAT_TIME = 0.2  # s: a fabric sensor always shows noise; a signal that stays constant for so long is a broken line
RANGE_FACTOR = 1.5  # of the calibrated half-range: a value beyond it is not from this body
SMALLEST_HALF_RANGE = 1e-9  # signal units, for a channel that did not change in the calibration
LOSS_WINDOW = 1.0  # s
LOSS_LIMIT = 0.1  # share of frames


class ChannelHealth:
    """Checks channels for NaN, for values outside 1.5 x the calibrated range, and for constant values."""

    def __init__(self, profile: CalibrationProfile, watched: NDArray[np.bool_], sample_rate: float) -> None:
        low, high = np.array(profile.low), np.array(profile.high)
        reach = RANGE_FACTOR * np.maximum((high - low) / 2, SMALLEST_HALF_RANGE)
        self._low = np.where(watched, (low + high) / 2 - reach, -np.inf)
        self._high = np.where(watched, (low + high) / 2 + reach, np.inf)
        self._watched = watched
        self._same = np.empty(len(low), dtype=np.bool_)
        self._flat_after = max(2, round(FLAT_TIME * sample_rate))
        self._above = np.empty(len(low), dtype=np.bool_)
        self._below = np.empty(len(low), dtype=np.bool_)
        self._all = np.ones(len(low), dtype=np.bool_).tobytes()
        self.reset()

    def reset(self) -> None:
        """Forget for how long each channel was constant."""
        self._previous = np.full(len(self._low), np.nan)
        self._still = np.zeros(len(self._low), dtype=np.int32)
        self._some_still = False

    def step(self, values: NDArray[np.float64]) -> NDArray[np.bool_] | None:
        """Return which channels are bad in this frame (n_channels,), or None when none is.

        `values` (n_channels,) in signal units; the caller must not change the array afterwards.
        """
        longest = self._count_still(values)
        np.greater_equal(values, self._low, out=self._above)
        np.less_equal(values, self._high, out=self._below)
        # Comparing bytes is the fastest test for "all true"; a NaN compares false and so takes the exact way below.
        if longest < self._flat_after and self._above.tobytes() == self._all == self._below.tobytes():
            return None
        wrong = ~(self._above & self._below) | (self._still >= self._flat_after)
        bad: NDArray[np.bool_] = wrong & self._watched
        return bad if bad.any() else None

    def _count_still(self, values: NDArray[np.float64]) -> int:
        """Count for how many frames each watched channel has been constant; return the largest count."""
        np.equal(values, self._previous, out=self._same)
        np.logical_and(self._same, self._watched, out=self._same)
        self._previous = values
        if b"\x01" in self._same.tobytes():
            self._still += 1
            self._still *= self._same
            self._some_still = True
            return int(self._still.max())
        if self._some_still:
            self._still[:] = 0
            self._some_still = False
        return 0

    def block(self, values: NDArray[np.float64], before: NDArray[np.float64] | None) -> NDArray[np.bool_]:
        """Return which channels are bad (n, n_channels) for many frames at once, as `step` would frame by frame.

        `before` are the `memory` frames just before them, to notice a constant channel; None at the beginning.
        """
        known = values if before is None else np.concatenate((before, values))
        rows = np.arange(len(known), dtype=np.int32)[:, np.newaxis]
        changed = np.ones(known.shape, dtype=np.bool_)
        np.not_equal(known[1:], known[:-1], out=changed[1:])
        flat = rows - np.maximum.accumulate(np.where(changed, rows, 0), axis=0) >= self._flat_after
        wrong = ~((values >= self._low) & (values <= self._high)) | flat[len(known) - len(values) :]
        return np.asarray(wrong & self._watched)

    @property
    def memory(self) -> int:
        """How many earlier frames decide whether a channel is constant."""
        return self._flat_after + 1


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
