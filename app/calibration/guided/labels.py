"""When the body did what the cues asked for: the prompts shifted by the person's lag, and the way back."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

EARLIEST, LATEST = -0.2, 1.2  # s behind the cue: where a joint's lag is looked for
OWN_LAG = 0.35  # s: how far one repetition may be from the joint's lag
WAY_BACK = 1.5  # of the movement's duration, as the calibration's script asks for
LONGEST_HOLD = 3.0  # s: how long a posture may be held before the way back
AT_ONCE = 0.5  # of the largest fall: from here on the way back is taken to have followed at once

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Asked:
    """One repetition in a recording: the rows in which the cue asked for the movement."""

    start: int
    stop: int


def lags_of(rate: Array, asked: Sequence[Asked], sample_rate: float) -> list[int]:
    """Return by how many rows each repetition comes after its cue.

    A lag is good when the joint's place rises over the shifted cue and falls over as much of a way back. All
    repetitions together decide on the joint's lag, each with the same weight; then each finds its own near to it.

    Parameters
    ----------
    rate : (n,) array
        Rate of the joint, rising in the prompted direction.
    asked : sequence of Asked
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
    for one in asked:
        back = one.stop + round(WAY_BACK * (one.stop - one.start))
        score = 2.0 * at(one.stop + lags) - at(one.start + lags) - at(back + lags)
        scores.append(score / max(float(np.abs(score).max()), np.finfo(float).tiny))
    common = np.sum(scores, axis=0)
    common[(lags < EARLIEST * sample_rate) | (lags > LATEST * sample_rate)] = -np.inf
    shared = int(lags[common.argmax()])
    near = np.abs(lags - shared) <= OWN_LAG * sample_rate
    return [int(lags[near][score[near].argmax()]) for score in scores]


def labels(rate: Array, asked: Sequence[Asked], lags: Sequence[int], sample_rate: float) -> NDArray[np.int8]:
    """Return (n,) +1 in the prompted movements, -1 on the ways back, 0 elsewhere; parameters as of `lags_of`.

    A cue says nothing about the way back: it follows at once, unless the place falls much more a while later, which is
    how a posture looks that is held.
    """
    place = np.concatenate(([0.0], np.cumsum(rate)))
    moved = [(max(0, one.start + lag), min(len(rate), one.stop + lag)) for one, lag in zip(asked, lags, strict=True)]
    found = np.zeros(len(rate), dtype=np.int8)
    for (_, stop), one, following in zip(moved, asked, [*moved[1:], (len(rate), 0)], strict=True):
        length = round(WAY_BACK * (one.stop - one.start))
        last = min(following[0] - length, stop + round(LONGEST_HOLD * sample_rate))
        starts = np.arange(stop, max(stop, last) + 1)
        falls = place[np.minimum(starts, len(rate))] - place[np.minimum(starts + length, len(rate))]
        start = stop if falls[0] >= AT_ONCE * falls.max() else int(starts[falls.argmax()])
        found[start : min(start + length, following[0])] = -1
    for start, stop in moved:
        found[start:stop] = 1
    return found
