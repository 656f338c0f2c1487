"""Labels the frames of a recording: movement towards the gesture, way back, or neither.

The movement is the cue shifted by the person's lag.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.calibration.script import WAY_BACK

EARLIEST, LATEST = -0.2, 1.2  # s after the cue: limits of a joint's lag
OWN_LAG = 0.35  # s: largest difference of one repetition's lag from the joint's
LONGEST_HOLD = 3.0  # s for which a posture may be held before the way back
AT_ONCE = 0.5  # share of the largest fall of place: when the first fall reaches it, the way back began at once

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class CuedMovement:
    """The rows of a recording in which the cue asked for one movement."""

    start: int
    stop: int


def lags_of(rate: Array, cued: Sequence[CuedMovement], sample_rate: float) -> list[int]:
    """Return the lag of each repetition behind its cue, in rows.

    The score of a lag is the rise of the joint's place over the shifted cue plus its fall over the way back. The
    joint's lag maximises the sum of the normalised scores of all repetitions; the lag of each repetition maximises its
    own score within OWN_LAG of the joint's lag.

    Parameters
    ----------
    rate : (n,) array
        Rate of the joint, rising in the prompted direction.
    cued : sequence of CuedMovement
        In order of time, within the n rows.
    sample_rate : float
        Hz.
    """
    place = np.concatenate(([0.0], np.cumsum(rate)))
    lags = np.arange(round((EARLIEST - OWN_LAG) * sample_rate), round((LATEST + OWN_LAG) * sample_rate) + 1)

    def at(rows: NDArray[np.int_]) -> Array:
        fits: Array = place[np.clip(rows, 0, len(rate))]
        return fits

    scores = []
    for movement in cued:
        back = movement.stop + round(WAY_BACK * (movement.stop - movement.start))
        score = 2.0 * at(movement.stop + lags) - at(movement.start + lags) - at(back + lags)
        scores.append(score / max(float(np.abs(score).max()), np.finfo(float).tiny))
    common = np.sum(scores, axis=0)
    common[(lags < EARLIEST * sample_rate) | (lags > LATEST * sample_rate)] = -np.inf
    shared = int(lags[common.argmax()])
    near = np.abs(lags - shared) <= OWN_LAG * sample_rate
    return [int(lags[near][score[near].argmax()]) for score in scores]


def labels(rate: Array, cued: Sequence[CuedMovement], lags: Sequence[int], sample_rate: float) -> NDArray[np.int8]:
    """Return (n,) +1 in the prompted movements, -1 on the ways back, 0 elsewhere; parameters as of `lags_of`.

    No cue marks the way back. It is taken to begin right after the movement; or where the place falls most, when that
    fall is more than twice the first one: then the person held the posture for a while.
    """
    place = np.concatenate(([0.0], np.cumsum(rate)))
    moved = [
        (max(0, movement.start + lag), min(len(rate), movement.stop + lag))
        for movement, lag in zip(cued, lags, strict=True)
    ]
    label = np.zeros(len(rate), dtype=np.int8)
    for (_, stop), movement, following in zip(moved, cued, [*moved[1:], (len(rate), 0)], strict=True):
        length = round(WAY_BACK * (movement.stop - movement.start))
        last = min(following[0] - length, stop + round(LONGEST_HOLD * sample_rate))
        starts = np.arange(stop, max(stop, last) + 1)
        falls = place[np.minimum(starts, len(rate))] - place[np.minimum(starts + length, len(rate))]
        start = stop if falls[0] >= AT_ONCE * falls.max() else int(starts[falls.argmax()])
        label[start : min(start + length, following[0])] = -1
    for start, stop in moved:
        label[start:stop] = 1
    return label
