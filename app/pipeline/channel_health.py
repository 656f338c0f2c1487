"""Which channels are bad."""

# Compiled in a wheel (hatch_build.py).

from collections import deque
from itertools import islice
from typing import Any, Final

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from app.calibration.profile import CalibrationProfile

Array = NDArray[np.float64]
Frame = NDArray[np.float32] | Array

FLAT_TIME: Final = 0.2  # s: a fabric sensor always shows noise; a signal constant for so long is a broken line
STUCK_TIME: Final = 0.3  # s: real knit never was so quiet for so long, in 48 recordings by a factor of 1.3 at least
FEWEST_STUCK: Final = 20  # frames: fewer of them can lie close together by chance
STUCK_SHARE: Final = 0.7  # of the standard deviation of a channel's own noise: a smaller range is none of its own
SAMPLES: Final = 12  # frames of half a window whose range is computed first: of 12, noise seldom has so small a range
RANGE_FACTOR: Final = 1.5  # of the calibrated half-range: a value beyond it is not from this body
SMALLEST_HALF_RANGE: Final = 1e-9  # signal units, for a channel that did not change in the calibration


class ChannelHealth:
    """Checks channels for NaN, for values outside 1.5 x the calibrated range, and for channels that are stuck.

    A channel is stuck when it is constant, or its range is smaller than its own noise explains: a sensor that broke may
    still show the noise of the converter. That does not hold for channels whose value may stay constant by the layout:
    their driver makes them NaN when their sensor does not answer.

    Whether a channel is constant is checked every `flat_after // 2` frames only: a channel that has not been constant
    for at least the other half cannot become flat before the next check. While some channel could, all are counted
    frame by frame.
    """

    def __init__(self, profile: CalibrationProfile, watched: NDArray[np.bool_], sample_rate: float) -> None:
        low, high = np.array(profile.low), np.array(profile.high)
        middle, reach = (low + high) / 2, RANGE_FACTOR * np.maximum((high - low) / 2, SMALLEST_HALF_RANGE)
        self._low = np.where(watched, middle - reach, -np.inf)
        self._high = np.where(watched, middle + reach, np.inf)
        # Rows low, frame, high: one comparison of neighbouring rows tests both limits.
        self._table = np.stack((self._low, middle, self._high))
        self._within = np.empty((2, len(low)), dtype=np.bool_)
        self._all_within = np.ones((2, len(low)), dtype=np.bool_).tobytes()
        self._watched = watched
        self._must_change = watched & ~np.array(profile.layout.may_stay_constant, dtype=np.bool_)
        self._flat_after = max(2, round(FLAT_TIME * sample_rate))
        self._check_every = self._flat_after // 2
        self._suspect_after = self._flat_after - self._check_every
        noise = np.array(profile.noise)
        # Signal units, -1 where no range is too small.
        self._least_range = np.where(self._must_change & (noise > 0.0), STUCK_SHARE * noise, -1.0)
        self._has_noise = bool((self._least_range > 0.0).any())
        self._stuck_after = max(FEWEST_STUCK, round(STUCK_TIME * sample_rate))
        self._samples = min(SAMPLES, self._stuck_after // 2)
        self._sample_step = self._stuck_after // 2 // self._samples
        self.reset()

    def reset(self) -> None:
        """Forget for how long each channel was constant."""
        self._recent: deque[Frame] = deque(maxlen=max(self._flat_after, self._stuck_after))
        self._until_check = self._check_every + 1
        self._still: NDArray[np.int32] | None = None  # frames, while some channel is suspect
        self._until_range = self._stuck_after // 2 if self._has_noise else -1
        self._window: Array | None = None  # (stuck_after, n_channels) the newest frames, while a range is suspect
        self._oldest = 0  # row of the window

    @property
    def frame(self) -> NDArray[np.float64]:
        """The frame (n_channels,) of the last step; the next step overwrites it."""
        frame: NDArray[np.float64] = self._table[1]
        return frame

    @property
    def previous(self) -> Frame | None:
        """The frame (n_channels,) before that of the last step; None when there was none."""
        return self._recent[-2] if len(self._recent) > 1 else None

    def step(self, values: Frame) -> NDArray[np.bool_] | None:
        """Return which channels are bad in this frame (n_channels,), or None when none is.

        `values` (n_channels,) in signal units; the caller must not change the array afterwards.
        """
        self._recent.append(values)
        if self._still is not None:
            self._still += 1
            self._still *= self._must_change & (values == self._recent[-2])
        self._until_check -= 1
        if not self._until_check:
            self._until_check = self._check_every
            self._check_constant(values)
        stuck = None
        self._until_range -= 1
        if not self._until_range or self._window is not None:
            stuck = self._stuck(values)
        self._table[1] = values
        np.less_equal(self._table[:2], self._table[1:], out=self._within)
        # Comparing bytes is the fastest test for "all true"; a NaN compares false and so takes the exact way below.
        if self._still is None and stuck is None and self._within.tobytes() == self._all_within:
            return None
        wrong = ~self._within.all(axis=0)
        if self._still is not None:
            wrong |= self._still >= self._flat_after
        if stuck is not None:
            wrong |= stuck
        bad: NDArray[np.bool_] = wrong & self._watched
        return bad if bad.any() else None

    def _stuck(self, values: Frame) -> NDArray[np.bool_] | None:
        """Return which channels have a range that is too small for their noise (n_channels,), None when none may have.

        Every half window a few frames are sampled. Only when their range is too small, the range of the whole window is
        computed, frame by frame.
        """
        window = self._window
        if window is not None:
            window[self._oldest] = values
            self._oldest = (self._oldest + 1) % len(window)
        if not self._until_range:
            self._until_range = self._stuck_after // 2
            newest = np.array([self._recent[-1 - i * self._sample_step] for i in range(self._samples)])
            if not self._too_small(newest).any():
                self._window = window = None
            elif window is None:
                recent = np.array(self._recent, dtype=np.float64)[-self._stuck_after :]
                window = np.full((self._stuck_after, len(values)), np.nan)  # no range is known before it is full
                window[: len(recent)] = recent
                self._window, self._oldest = window, len(recent) % self._stuck_after
        return None if window is None else self._too_small(window)

    def _too_small(self, frames: Frame) -> NDArray[np.bool_]:
        """Return whether the range of each channel in frames (n, n_channels) is too small for its noise."""
        small: NDArray[np.bool_] = frames.max(axis=0) <= frames.min(axis=0) + self._least_range
        return small

    def _stuck_in_block(self, frames: NDArray[Any]) -> NDArray[np.bool_] | None:
        """Return what `_stuck` does for each of many frames (n, n_channels), None when no range is too small."""
        if not self._has_noise or len(frames) < self._stuck_after:
            return None
        sampled = sliding_window_view(frames[:: self._sample_step], self._samples, axis=0)
        suspect = (sampled.max(axis=-1) <= sampled.min(axis=-1) + self._least_range).any(axis=0)
        if not suspect.any():
            return None
        stuck = np.zeros(frames.shape, dtype=np.bool_)
        for channel in np.flatnonzero(suspect):
            windows = sliding_window_view(frames[:, channel], self._stuck_after)
            small = windows.max(axis=-1) <= windows.min(axis=-1) + self._least_range[channel]
            stuck[self._stuck_after - 1 :, channel] = small
        return stuck

    def _check_constant(self, values: Frame) -> None:
        """Begin or end to count frame by frame."""
        if self._still is not None:
            if self._still.max() < self._suspect_after:
                self._still = None
        elif (self._must_change & (values == self._recent[-1 - self._check_every])).any():
            still = self._count_back()
            if still.max() >= self._suspect_after:
                self._still = still

    def _count_back(self) -> NDArray[np.int32]:
        """Return for how many of the newest frames, `flat_after` at most, each channel has been constant.

        It is 0 for those that may stay constant.
        """
        backwards = np.array(list(islice(reversed(self._recent), self._flat_after + 1)))
        same = (backwards[:-1] == backwards[1:]) & self._must_change
        return np.asarray(np.logical_and.accumulate(same).sum(axis=0), dtype=np.int32)

    def block(self, values: NDArray[np.float64], before: NDArray[np.float64] | None) -> NDArray[np.bool_]:
        """Return which channels are bad (n, n_channels) for many frames at once, as `step` would frame by frame."""
        bad = self.bad_in_block(values, before)
        return np.zeros(values.shape, dtype=np.bool_) if bad is None else bad

    def bad_in_block(self, values: Frame, before: Frame | None) -> NDArray[np.bool_] | None:
        """Return what `block` does, None when no channel is bad.

        `before` are the `memory` frames just before them, to notice a constant channel; None at the beginning.
        """
        frames = values if before is None else np.concatenate((before, values))
        wrong = None
        # A NaN is the smallest and the largest value of its channel, and compares false.
        if not ((values.min(axis=0) >= self._low) & (values.max(axis=0) <= self._high))[self._watched].all():
            wrong = ~((values >= self._low) & (values <= self._high))
        sampled = frames[:: self._check_every]  # two neighbours of these lie in every stretch that is long enough
        if ((sampled[1:] == sampled[:-1]) & self._must_change).any():
            rows = np.arange(len(frames), dtype=np.int32)[:, np.newaxis]
            changed = np.ones(frames.shape, dtype=np.bool_)
            np.not_equal(frames[1:], frames[:-1], out=changed[1:])
            flat = rows - np.maximum.accumulate(np.where(changed, rows, 0), axis=0) >= self._flat_after
            flat = flat[len(frames) - len(values) :] & self._must_change
            wrong = flat if wrong is None else wrong | flat
        stuck = self._stuck_in_block(frames)
        if stuck is not None:
            stuck = stuck[len(frames) - len(values) :]
            wrong = stuck if wrong is None else wrong | stuck
        if wrong is None:
            return None
        bad: NDArray[np.bool_] = wrong & self._watched
        return bad if bad.any() else None

    @property
    def memory(self) -> int:
        """How many earlier frames decide whether a channel is stuck."""
        return max(self._flat_after, self._stuck_after) + 1
