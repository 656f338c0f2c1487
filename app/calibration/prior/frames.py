"""Prepares a person's prompted frames for the prior: features, labels, and which repetition a frame belongs to.

A cue says when a movement was asked for, not when it was made. The rate of a map cannot tell either when the map is
what is to be learnt: on a real knit the main direction of a joint's channels turns back in the middle of some
movements. So a stroke begins where the channels begin to move at all, in whichever direction.
"""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.calibration.features import features
from app.calibration.fit.repetitions import Stretch
from app.calibration.guided.labels import EARLIEST, LATEST, OWN_LAG, CuedMovement, labels
from app.calibration.prior.moments import Moments
from app.calibration.prior.solving import OwnFrames, solve_direction
from app.signals.low_pass import STANDARD_CUTOFF, smooth

SHORTEST_CUE = 0.25  # s: a shorter cue covers a part of a movement only
STILL = 0.5  # s before a stroke in which the channels move less than during it
EDGE = 0.15  # of a stroke's own peak rate: where the stroke begins and ends
LARGEST_SHIFT = 0.1  # s by which an edge may lie outside of the cue that was shifted by the person's lag

Array = NDArray[np.float64]


def prompted_frames(
    stretches: Sequence[Stretch],
    channels: Sequence[int],
    scale: Array,
    sample_rate: float,
    people: Moments | None = None,
) -> OwnFrames | None:
    """Return the labelled frames of one joint; None without a prompted movement.

    Labels are found twice: a first map that is learnt from rough labels says where each stroke begins and ends. It
    reads the newest rates only, so that it ends with the movement when the cue was longer.

    Parameters
    ----------
    stretches : sequence of Stretch
        Of this joint, without gaps.
    channels : sequence of int
        Indices of the joint's k channels, in the order of the features.
    scale : (k,) array
        What each channel is divided by.
    sample_rate : float
        Hz.
    people : Moments or None
        Other people's moments, from which the first map is learnt as well; None where there are none yet.
    """
    pieces, cues = [], []
    for stretch in stretches:
        cued = [CuedMovement(movement.start, movement.stop) for movement in stretch.moving]
        long_enough = [movement for movement in cued if movement.stop - movement.start >= SHORTEST_CUE * sample_rate]
        if long_enough:
            pieces.append(stretch.values[:, list(channels)] / scale)
            cues.append(long_enough)
    if not pieces:
        return None
    lags = [movement_lags(piece, cued, sample_rate) for piece, cued in zip(pieces, cues, strict=True)]
    readings = [features(piece, sample_rate) for piece in pieces]
    repetition = _repetitions(pieces, cues, lags, sample_rate)
    if people is None:
        rates = _first_rates(pieces, cues, lags, sample_rate)
    else:
        weights = solve_direction(people, sample_rate)
        rates = [reading @ weights for reading in readings]
    together = np.concatenate(readings)
    cue_rows = np.array([movement.stop - movement.start for cued in cues for movement in cued])
    rough = np.concatenate([labels(*inputs, sample_rate) for inputs in zip(rates, cues, lags, strict=True)])
    if people is None:
        if not (rough > 0).any():
            return None
        weights = solve_direction(Moments.of(together, rough), sample_rate)
    else:
        weights = solve_direction(people, sample_rate, OwnFrames(together, rough, repetition, cue_rows))
    rates = [reading @ weights for reading in readings]
    label = np.concatenate([stroke_labels(*inputs, sample_rate) for inputs in zip(rates, cues, lags, strict=True)])
    return OwnFrames(together, label, repetition, cue_rows) if (label > 0).any() else None


def _first_rates(
    pieces: Sequence[Array], cues: Sequence[Sequence[CuedMovement]], lags: Sequence[Sequence[int]], sample_rate: float
) -> list[Array]:
    """Return the rates along the mean displacement of the prompted movements."""
    moved = np.zeros(pieces[0].shape[1])
    for piece, cued, piece_lags in zip(pieces, cues, lags, strict=True):
        for movement, lag in zip(cued, piece_lags, strict=True):
            start, stop = np.clip((movement.start + lag, movement.stop + lag), 0, len(piece) - 1)
            moved += piece[stop] - piece[start]
    places = [smooth(piece @ moved, STANDARD_CUTOFF, sample_rate) for piece in pieces]
    return [np.diff(place, prepend=place[:1]) * sample_rate for place in places]


def _repetitions(
    pieces: Sequence[Array], cues: Sequence[Sequence[CuedMovement]], lags: Sequence[Sequence[int]], sample_rate: float
) -> NDArray[np.int_]:
    """Return (n,) the repetition of each frame: from shortly before its stroke to shortly before the next one."""
    numbers, before = [], 0
    for piece, cued, piece_lags in zip(pieces, cues, lags, strict=True):
        starts = [
            movement.start + lag - round(STILL * sample_rate) for movement, lag in zip(cued, piece_lags, strict=True)
        ]
        edges = [max(start, following) for start, following in pairwise(starts)]
        numbers.append(before + np.searchsorted(np.array(edges, dtype=np.int_), np.arange(len(piece)), "right"))
        before += len(cued)
    return np.concatenate(numbers)


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
    rates = np.diff(smooth(values, STANDARD_CUTOFF, sample_rate), axis=0)
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
    for movement in cued:
        start, stop = movement.start + lags, movement.stop + lags
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
    label = np.zeros_like(rough)
    edges = np.flatnonzero(np.diff(rough, prepend=0, append=0))
    for start, stop in pairwise(edges.tolist()):
        sign = rough[start]
        if sign:
            first, last = _stroke(sign * rate, start, stop, round(LARGEST_SHIFT * sample_rate))
            part = label[first:last]
            part[part == 0] = sign
    return label


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
