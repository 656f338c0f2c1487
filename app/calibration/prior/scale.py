"""The scale of each channel on one person, from ten seconds of any movement."""

import numpy as np
from numpy.typing import NDArray

from app.signals.low_pass import STANDARD_CUTOFF, smooth

RANGE = (5.0, 95.0)  # percentiles: a single large movement does not set the scale
MOVEMENT = 10.0  # s of movement that the scale is taken from; a shorter one changes no scale
LEAST_SHARE = 0.1  # of the expected range: a channel that moves less is left out of the equations

Array = NDArray[np.float64]


def first_movement(values: Array, sample_rate: float) -> Array | None:
    """Return the first ten seconds of frames (n, n_channels), None when there are fewer; `sample_rate` in Hz."""
    count = round(MOVEMENT * sample_rate)
    return values[:count] if len(values) >= count - 1 else None


def log_ranges(values: Array, sample_rate: float) -> Array:
    """Return the logarithm (k,) of the range of each smoothed channel (n, k); -inf for a channel that stands still.

    `values` without NaN, in signal units; `sample_rate` in Hz.
    """
    low, high = np.percentile(smooth(values, STANDARD_CUTOFF, sample_rate), RANGE, axis=0)
    with np.errstate(divide="ignore"):
        logs: Array = np.log(high - low)
    return logs


def channels_alive(logs: Array, expected: Array) -> NDArray[np.bool_]:
    """Return which channels (k,) move at least a tenth of what is expected of them on this person.

    `logs` and `expected` (k,) are logarithms of ranges: the person's, and the mean over other people. How much this
    person moves altogether is the median over the channels.
    """
    ratio = logs - expected
    moves = np.isfinite(ratio)
    alive: NDArray[np.bool_] = moves.copy()
    if moves.any():
        alive[moves] = ratio[moves] >= np.median(ratio[moves]) + np.log(LEAST_SHARE)
    return alive


def scales(logs: Array, alive: NDArray[np.bool_], expected: Array | None = None) -> Array:
    """Return what each channel (k,) is divided by: halfway, on a logarithmic scale, from the joint's to its own range.

    Parameters
    ----------
    logs : (k,) array
        Logarithm of each channel's range.
    alive : (k,) array
        The channels that are used; the scale of any other is 1.
    expected : (k,) array or None
        Mean of the logarithms over other people: then the ranges of the channels that are not used count as expected.
        None when all channels are used, or nobody else is known.
    """
    level = float(logs[alive].mean())
    if expected is not None:
        level += float(expected.mean() - expected[alive].mean())
    scale: Array = np.exp((level + np.where(alive, logs, -level)) / 2.0)
    return scale
