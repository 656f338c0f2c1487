"""The features of a linear map over a whole recording, seven per channel: what maps are learnt from."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import AVERAGING_TIMES, RATE_LAGS
from app.signals.low_pass import STANDARD_CUTOFF, slow_average, smooth

Array = NDArray[np.float64]


def features(values: Array, sample_rate: float) -> Array:
    """Return the features (n, 7k) of k channels (n, k): five rates of different age, then two levels.

    The columns are sorted by kind, then by channel: smoothed rates (signal units/s) as they were RATE_LAGS (s) ago, and
    smoothed levels (signal units) above the averages over AVERAGING_TIMES (s). Between two frames the rates are
    interpolated, so that one set of weights serves every sample rate. Before the first frame the rates are zero.

    Parameters
    ----------
    values : (n, k) array
        Without NaN, of frames one sample period apart.
    sample_rate : float
        Hz.
    """
    smoothed = smooth(values, STANDARD_CUTOFF, sample_rate)
    rates = np.diff(smoothed, axis=0, prepend=smoothed[:1]) * sample_rate
    levels = [smoothed - slow_average(smoothed, memory, sample_rate) for memory in AVERAGING_TIMES]
    return np.concatenate([*(_delayed(rates, lag * sample_rate) for lag in RATE_LAGS), *levels], axis=1)


def _delayed(rates: Array, frames: float) -> Array:
    """Return the rates (n, k) as they were `frames` sample periods earlier."""
    whole, part = divmod(round(frames, 6), 1.0)
    earlier = [np.concatenate((np.zeros((int(by), rates.shape[1])), rates))[: len(rates)] for by in (whole, whole + 1)]
    delayed: Array = (1.0 - part) * earlier[0] + part * earlier[1]
    return delayed
