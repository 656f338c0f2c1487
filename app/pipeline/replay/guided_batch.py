"""The rate of a guided map over a whole recording at once, equal to that of `pipeline.guided_rate` frame by frame."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.profile import AVERAGING_TIMES
from app.signals.smoothing import slow_average, smooth

Array = NDArray[np.float64]


def guided_rate(parts: Array, periods: Array, cutoff: float, sample_rate: float) -> Array:
    """Return the rate (n,) in FS/s of a guided map.

    Parameters
    ----------
    parts : (n, 3) array
        The map's projections: the one that is differentiated (FS), and two levels (FS/s).
    periods : (n,) array
        Number of sample periods between each frame and the frame before.
    cutoff, sample_rate : float
        Hz.
    """
    rate = np.diff(parts[:, 0], prepend=parts[:1, 0]) * (sample_rate / periods)
    for level, memory in zip(parts.T[1:], AVERAGING_TIMES, strict=True):
        if level.any():
            rate += level - slow_average(level, memory, sample_rate, periods)
    return smooth(rate, cutoff, sample_rate)
