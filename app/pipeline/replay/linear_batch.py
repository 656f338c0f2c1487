"""The rate of a linear map over a whole recording at once, equal to that of `pipeline.linear_rate` frame by frame."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.profile import AVERAGING_TIMES, RATE_LAGS
from app.signals.smoothing import slow_average, smooth

Array = NDArray[np.float64]


def linear_rate(parts: Array, periods: Array, cutoff: float, sample_rate: float) -> Array:
    """Return the rate (n,) in FS/s of a linear map.

    Parameters
    ----------
    parts : (n, p) array
        The map's projections: the one that is differentiated and earlier ones (FS), then two levels (FS/s).
    periods : (n,) array
        Number of sample periods between each frame and the frame before.
    cutoff, sample_rate : float
        Hz.
    """
    first_level = parts.shape[1] - len(AVERAGING_TIMES)
    rate = np.diff(parts[:, 0], prepend=parts[:1, 0]) * (sample_rate / periods)
    time = np.cumsum(periods)
    for earlier, lag in zip(parts.T[1:first_level], RATE_LAGS[1:], strict=False):  # a guided map has none
        if earlier.any():
            then = np.interp(time - round(lag * sample_rate, 6), time, earlier)
            rate += np.diff(then, prepend=earlier[:1]) * (sample_rate / periods)
    for level, memory in zip(parts.T[first_level:], AVERAGING_TIMES, strict=True):
        if level.any():
            rate += level - slow_average(level, memory, sample_rate, periods)
    return smooth(rate, cutoff, sample_rate)
