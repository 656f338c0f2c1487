"""What is expected of a prior's map in use: hits of 100 movements, and false activations a minute.

A hit is a movement that reaches half of a full activation, as for every other map. How quick the person's movements
are is known from the own repetitions, judged by a map that is learnt without them, and from the free movement.
"""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from app.calibration.gestures.cross_check import hit_level
from app.calibration.gestures.prediction import hit_probability
from app.calibration.guided.check import MARGIN, SHORTEST_REST, at_rest
from app.calibration.linear_map import Forecast
from app.calibration.prior.hit_uncertainty import deviation_of_hits
from app.calibration.prior.moments import Moments
from app.calibration.prior.solving import OwnFrames, solve
from app.calibration.script import REPETITIONS

FREE_PERCENTILE = 97.0  # of the rate of free movement: its quick movements peak there
LEAST_FULL = 1.2  # of the dead-zone: a movement that hardly leaves it is not full at once
USUAL_FALSE, USUAL_MINUTES = 1.0, 0.5  # false activations expected before any is counted, and the rest they stand for

Array = NDArray[np.float64]


def held_out_rate(frames: OwnFrames, people: Moments, sample_rate: float) -> Array:
    """Return the rate (n,) of each repetition by the map that is learnt without that repetition; Hz."""
    rate = np.empty(len(frames.label))
    for repetition in range(frames.repetitions):
        rows = frames.repetition == repetition
        others = frames.without(repetition)
        rate[rows] = frames.features[rows] @ solve(people, sample_rate, others if len(others.label) else None)
    return rate


def own_peaks(free: Array, dead_zone: float, held_out: Array | None, frames: OwnFrames | None) -> list[float]:
    """Return the peak rates of the person's movements, in the unit of the rates; empty when nothing is known of them.

    Those of the own repetitions; as long as these are fewer than a calibration has, the free movement counts as one.

    Parameters
    ----------
    free : (n,) array
        Rate during the free movement.
    dead_zone : float
        From where the rate counts: free movement that is slower was not this gesture.
    held_out : (m,) array or None
        Rate during the person's own repetitions, by maps that are learnt without them.
    frames : OwnFrames or None
        The labels of those repetitions.
    """
    peaks = []
    if held_out is not None and frames is not None:
        moving = [(frames.repetition == number) & (frames.label > 0) for number in range(frames.repetitions)]
        peaks = [float(held_out[rows].max()) for rows in moving if rows.any()]
    in_free = float(np.percentile(free, FREE_PERCENTILE)) if len(free) else 0.0
    return [*peaks, in_free] if len(peaks) < REPETITIONS and in_free > dead_zone else peaks


def own_full(peaks: Sequence[float], dead_zone: float, full: float) -> float:
    """Return the rate that is full for this person: the median peak, or `full` of other people where none is known."""
    return max(float(np.median(peaks)) if peaks else full, LEAST_FULL * dead_zone)


def expected_hits(peaks: Sequence[float], dead_zone: float, full: float, repetitions: int) -> Forecast | None:
    """Return the expected hits of 100 movements with so many own repetitions; None without any known peak."""
    if not peaks:
        return None
    share = hit_probability(peaks, hit_level(dead_zone, full))
    return Forecast(value=round(100 * share, 1), uncertainty=deviation_of_hits(repetitions))


def expected_false(held_out: Array, frames: OwnFrames, dead_zone: float, sample_rate: float) -> Forecast | None:
    """Return the expected activations a minute at rest, from the pauses between the repetitions.

    None when the pauses are shorter than SHORTEST_REST; parameters as of `own_peaks`, `sample_rate` in Hz.
    """
    resting = at_rest(frames.label, round(MARGIN * sample_rate))
    seconds = float(resting.sum()) / sample_rate
    if seconds < SHORTEST_REST:
        return None
    active = (held_out > dead_zone) & resting
    count = int(np.count_nonzero(np.diff(active.astype(np.int8), prepend=0) > 0))
    minutes = seconds / 60.0 + USUAL_MINUTES
    return Forecast(
        value=round((count + USUAL_FALSE) / minutes, 2), uncertainty=round(math.sqrt(count + USUAL_FALSE) / minutes, 2)
    )
