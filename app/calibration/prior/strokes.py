"""Labels the frames of a recording for the prior: finds each prompted stroke, from where it begins to where it ends.

A cue says when a movement was asked for, not when it was made. The rate of a map cannot tell either when the map is
what is to be learnt: on a real knit the main direction of a joint's channels turns back in the middle of some
movements. So a stroke is looked for where the channels begin to move at all, in whichever direction.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.calibration.fit.joint_evidence import CUTOFF
from app.calibration.guided.labels import EARLIEST, LATEST, OWN_LAG, CuedMovement, labels
from app.signals.smoothing import smooth

STILL = 0.5  # s before a stroke in which the channels move less than during it
EDGE = 0.15  # of a stroke's own peak rate: where the stroke begins and ends
LARGEST_SHIFT = 0.1  # s by which an edge may lie outside of the cue that was shifted by the person's lag

Array = NDArray[np.float64]


def movement_lags(values: Array, cued: Sequence[CuedMovement], sample_rate: float) -> list[int]:
    """Return the lag (rows) of each movement behind its cue.

    The score of a lag is the mean power of the channels' rates during the shifted cue, less that of the STILL seconds
    before it. All movements of a recording share one lag, from which each may differ by OWN_LAG.

    Parameters
    ----------
    values : (n, k) array
        A joint's channels, without NaN.
    cued : sequence of CuedMovement
        In order of time, within the n rows.
    sample_rate : float
        Hz.
    """
    rates = np.diff(smooth(values, CUTOFF, sample_rate), axis=0)
    power = rates**2
    mean = power.mean(axis=0)
    summed = np.concatenate(([0.0, 0.0], np.cumsum((power / np.where(mean > 0.0, mean, 1.0)).mean(axis=1))))
    lags = np.arange(round((EARLIEST - OWN_LAG) * sample_rate), round((LATEST + OWN_LAG) * sample_rate) + 1)
    still = max(1, round(STILL * sample_rate))

    def mean_power(first: NDArray[np.int_], last: NDArray[np.int_]) -> Array:
        ends = summed[np.clip(last, 0, len(values))] - summed[np.clip(first, 0, len(values))]
        means: Array = ends / (last - first)
        return means

    scores = []
    for one in cued:
        start, stop = one.start + lags, one.stop + lags
        score = mean_power(start, stop) - mean_power(start - still, start)
        scores.append(score / max(float(np.abs(score).max()), np.finfo(float).tiny))
    common = np.sum(scores, axis=0)
    common[(lags < EARLIEST * sample_rate) | (lags > LATEST * sample_rate)] = -np.inf
    near = np.abs(lags - lags[common.argmax()]) <= OWN_LAG * sample_rate
    return [int(lags[near][score[near].argmax()]) for score in scores]


def stroke_labels(
    rate: Array, cued: Sequence[CuedMovement], lags: Sequence[int], sample_rate: float
) -> NDArray[np.int8]:
    """Return (n,) +1 in the prompted strokes, -1 on the ways back, 0 elsewhere.

    The edges of each stroke are moved to where the rate crosses EDGE of its own peak: a cue that is longer than the
    movement would otherwise teach that rest is movement.

    Parameters
    ----------
    rate : (n,) array
        Rate of the joint, rising in the prompted direction; its unit does not matter.
    cued : sequence of CuedMovement
        In order of time.
    lags : sequence of int
        Rows by which each movement follows its cue.
    sample_rate : float
        Hz.
    """
    rough = labels(rate, cued, lags, sample_rate)
    found = np.zeros_like(rough)
    edges = np.flatnonzero(np.diff(rough, prepend=0, append=0))
    for start, stop in pairwise(edges.tolist()):
        sign = rough[start]
        if sign:
            first, last = _stroke(sign * rate, start, stop, round(LARGEST_SHIFT * sample_rate))
            part = found[first:last]
            part[part == 0] = sign
    return found


def _stroke(rate: Array, start: int, stop: int, most: int) -> tuple[int, int]:
    """Return the rows from the first to the last time that the rate is above EDGE of its peak between two rows.

    Where the rate is still above that, each edge goes on outwards, for at most `most` rows.
    """
    least = EDGE * float(rate[start:stop].max())
    if least <= 0.0:
        return start, start
    inside = start + np.flatnonzero(rate[start:stop] >= least)
    first, last = int(inside[0]), int(inside[-1]) + 1
    while first > max(0, start - most) and rate[first - 1] >= least:
        first -= 1
    while last < min(len(rate), stop + most) and rate[last] >= least:
        last += 1
    return first, last
