"""What is expected of a prior's map in use: hits of 100 movements, and false activations a minute.

The person's own repetitions are judged by a map that is learnt without them. Before there are any, other people's
strokes and the person's free movement say how many movements are quick enough for the dead-zone.
"""

import math

import numpy as np
from numpy.typing import NDArray

from app.calibration.guided.check import MARGIN, SHORTEST_REST, at_rest
from app.calibration.prior.moments import Moments
from app.calibration.prior.prompting import deviation_of_hits
from app.calibration.prior.solving import DEAD_ZONE_DEVIATIONS, OwnFrames, solve
from app.calibration.prior.strokes import EDGE
from app.calibration.profile import Forecast

LARGE = 0.3  # of the 95th percentile of the free movement's rate: what counts as a movement there
LABELLED = 0.88  # of a real stroke's time above the dead-zone, by that of its labelled part: its slow edges are below
# A movement lasts as long as its cue, and at most so many times its labelled part: a cue may be longer than it. What a
# map does not answer at all is not labelled either, so that the labelled part alone would flatter.
LONGEST = 1.25
WORTH_OF_OTHERS = 1.0  # own repetitions that other people's strokes count for
WORTH_OF_FREE = 0.5  # the same of the free movement, which may be gentler than strokes
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


def share_of_free(rate: Array, dead_zone: float) -> float | None:
    """Return the share of the large movements' time in which the rate (n,) of free movement is above the dead-zone.

    None when nothing moves the gesture's way.
    """
    edges = np.flatnonzero(np.diff((rate > 0.0).astype(np.int8), prepend=0, append=0))
    large = LARGE * float(np.percentile(rate, 95))
    above = total = 0
    for start, stop in zip(edges[::2], edges[1::2], strict=True):
        movement = rate[start:stop]
        peak = float(movement.max())
        if peak > large > 0.0:
            during = movement[movement > EDGE * peak]
            above += int((during > dead_zone).sum())
            total += len(during)
    return above / total if total else None


def share_of_others() -> float:
    """Return the share of other people's strokes' time above their dead-zone, with normally distributed rates."""
    return LABELLED * (1.0 + math.erf(-DEAD_ZONE_DEVIATIONS / math.sqrt(2.0))) / 2.0


def share_of_own(held_out: Array, dead_zone: float, frames: OwnFrames) -> float:
    """Return the share of the person's own repetitions' time in which the rate (n,) is above the dead-zone."""
    strokes = frames.label > 0
    labelled = np.bincount(frames.repetition[strokes], minlength=frames.repetitions)
    lasted = np.minimum(frames.asked[: frames.repetitions], LONGEST * labelled)
    return min(1.0, float((held_out[strokes] > dead_zone).sum() / lasted.sum()))


def expected_hits(free: Array, dead_zone: float, held_out: Array | None, frames: OwnFrames | None) -> Forecast | None:
    """Return the expected hits of 100 movements, as the share of the movements' time with activation.

    None when nothing of this person moved the gesture's way.

    Parameters
    ----------
    free : (n,) array
        Rate during the free movement, in the unit of `dead_zone`.
    dead_zone : float
        From where the rate counts.
    held_out : (m,) array or None
        Rate during the person's own repetitions, by maps that are learnt without them.
    frames : OwnFrames or None
        The labels of those repetitions.
    """
    shares, weights, repetitions = [share_of_others()], [WORTH_OF_OTHERS], 0
    in_free = share_of_free(free, dead_zone)
    if in_free is not None:
        shares.append(LABELLED * in_free)
        weights.append(WORTH_OF_FREE)
    if held_out is not None and frames is not None:
        repetitions = frames.repetitions
        shares.append(share_of_own(held_out, dead_zone, frames))
        weights.append(float(repetitions))
    if in_free is None and not repetitions:
        return None
    share = float(np.average(shares, weights=weights))
    return Forecast(value=round(100 * share, 1), uncertainty=deviation_of_hits(repetitions))


def expected_false(held_out: Array, frames: OwnFrames, dead_zone: float, sample_rate: float) -> Forecast | None:
    """Return the expected activations a minute at rest, from the pauses between the repetitions.

    None when the pauses are shorter than SHORTEST_REST; parameters as of `expected_hits`, `sample_rate` in Hz.
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
