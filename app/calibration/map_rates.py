"""The rates of linear maps over a whole recording at once; the loop computes the same frame by frame."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import AVERAGING_TIMES, RATE_LAGS
from app.signals.low_pass import slow_average, smooth

Array = NDArray[np.float64]


def map_rates(projected: Array, is_read: NDArray[np.bool_], periods: Array, cutoff: float, sample_rate: float) -> Array:
    """Return the rates (n, m) in FS/s of m maps.

    Parameters
    ----------
    projected : (n, p) array
        The projections of the frames on the parts that are read, sorted by map, then by kind of `LinearMap.parts`.
    is_read : (m, KINDS) array of bool
        Which parts of each map those are; p of them are true.
    periods : (n,) array
        Number of sample periods between each frame and the frame before.
    cutoff, sample_rate : float
        Hz.
    """
    per_second = sample_rate / periods
    time = np.cumsum(periods)
    rate = np.zeros((len(projected), len(is_read)))
    for (which, kind), places in zip(np.argwhere(is_read).tolist(), projected.T, strict=True):
        if kind < len(RATE_LAGS):
            lag = round(RATE_LAGS[kind] * sample_rate, 6)
            then = np.interp(time - lag, time, places) if kind else places
            rate[1:, which] += np.diff(then) * per_second[1:]
        else:
            average = slow_average(places, AVERAGING_TIMES[kind - len(RATE_LAGS)], sample_rate, periods)
            rate[:, which] += places - average
    return smooth(rate, cutoff, sample_rate)
