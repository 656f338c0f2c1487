"""Prepares a person's prompted frames for the prior: features, labels, and which repetition a frame belongs to."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from app.calibration.features import features
from app.calibration.fit.joint_evidence import CUTOFF
from app.calibration.fit.repetitions import Stretch
from app.calibration.guided.labels import CuedMovement, labels
from app.calibration.prior.moments import Moments
from app.calibration.prior.solving import OwnFrames, solve_direction
from app.calibration.prior.strokes import STILL, movement_lags, stroke_labels
from app.signals.smoothing import smooth

SHORTEST_CUE = 0.25  # s: a shorter cue covers a part of a movement only

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
        cued = [CuedMovement(one.start, one.stop) for one in stretch.moving]
        long_enough = [one for one in cued if one.stop - one.start >= SHORTEST_CUE * sample_rate]
        if long_enough:
            pieces.append(stretch.values[:, list(channels)] / scale)
            cues.append(long_enough)
    if not pieces:
        return None
    lags = [movement_lags(piece, cued, sample_rate) for piece, cued in zip(pieces, cues, strict=True)]
    made = [features(piece, sample_rate) for piece in pieces]
    repetition = _repetitions(pieces, cues, lags, sample_rate)
    if people is None:
        rates = _first_rates(pieces, cues, lags, sample_rate)
    else:
        weights = solve_direction(people, sample_rate)
        rates = [one @ weights for one in made]
    together = np.concatenate(made)
    asked = np.array([one.stop - one.start for cued in cues for one in cued])
    rough = np.concatenate([labels(*one, sample_rate) for one in zip(rates, cues, lags, strict=True)])
    if people is None:
        if not (rough > 0).any():
            return None
        weights = solve_direction(Moments.of(together, rough), sample_rate)
    else:
        weights = solve_direction(people, sample_rate, OwnFrames(together, rough, repetition, asked))
    rates = [one @ weights for one in made]
    label = np.concatenate([stroke_labels(*one, sample_rate) for one in zip(rates, cues, lags, strict=True)])
    return OwnFrames(together, label, repetition, asked) if (label > 0).any() else None


def _first_rates(
    pieces: Sequence[Array], cues: Sequence[Sequence[CuedMovement]], lags: Sequence[Sequence[int]], sample_rate: float
) -> list[Array]:
    """Return the rates along the mean displacement of the prompted movements."""
    moved = np.zeros(pieces[0].shape[1])
    for piece, cued, own in zip(pieces, cues, lags, strict=True):
        for one, lag in zip(cued, own, strict=True):
            start, stop = np.clip((one.start + lag, one.stop + lag), 0, len(piece) - 1)
            moved += piece[stop] - piece[start]
    places = [smooth(piece @ moved, CUTOFF, sample_rate) for piece in pieces]
    return [np.diff(place, prepend=place[:1]) * sample_rate for place in places]


def _repetitions(
    pieces: Sequence[Array], cues: Sequence[Sequence[CuedMovement]], lags: Sequence[Sequence[int]], sample_rate: float
) -> NDArray[np.int_]:
    """Return (n,) the repetition of each frame: from shortly before its stroke to shortly before the next one."""
    numbers, before = [], 0
    for piece, cued, own in zip(pieces, cues, lags, strict=True):
        starts = [one.start + lag - round(STILL * sample_rate) for one, lag in zip(cued, own, strict=True)]
        edges = [max(start, following) for start, following in pairwise(starts)]
        numbers.append(before + np.searchsorted(np.array(edges, dtype=np.int_), np.arange(len(piece)), "right"))
        before += len(cued)
    return np.concatenate(numbers)
