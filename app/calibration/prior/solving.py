"""Solves for the weights of a prior's map, from other people's moments alone or with a person's own frames."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import KINDS
from app.calibration.prior.moments import Moments
from app.calibration.ridge import ridge

RIDGE = 0.01  # of each feature's own power
GAIN_UNCERTAINTY = 1.1  # factor on a channel's moments with itself: its gain differs from person to person
WORTH = 30.0  # s of a person's own frames that other people's moments count for; 10 to 60 s do equally well
# Deviations from the mean rate of strokes, whose slow edges are not labelled: chosen on the real knit, where 0.73
# hits less and 1.05 is active at rest (docs/learning/prior.md).
DEAD_ZONE_DEVIATIONS = -0.9
FULL_DEVIATIONS = 1.46  # about the 90 % quantile of the rates above the dead-zone

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class OwnFrames:
    """A person's own prompted frames, in the features of the prior."""

    features: Array  # (n, d) of scaled signals
    label: NDArray[np.int8]  # (n,) +1 in the strokes, -1 on the ways back, 0 elsewhere
    repetition: NDArray[np.int_]  # (n,) number of the repetition, counted from 0, that a frame belongs to
    asked: NDArray[np.int_]  # (repetitions,) rows that each was cued for

    @property
    def repetitions(self) -> int:
        """How many repetitions there are."""
        return int(self.repetition.max()) + 1

    def without(self, repetition: int) -> "OwnFrames":
        """Return the frames without those of one repetition."""
        rows = self.repetition != repetition
        return OwnFrames(self.features[rows], self.label[rows], self.repetition[rows], self.asked)


def solve(people: Moments, sample_rate: float, own_frames: OwnFrames | None = None) -> Array:
    """Return the weights (d,) of the ridge regression to the labels.

    Parameters
    ----------
    people : Moments
        Mean over other people, of the channels that are used.
    sample_rate : float
        Hz, of the person's own frames.
    own_frames : OwnFrames or None
        Without own frames the weights are other people's.
    """
    channel = np.tile(np.arange(len(people.moment) // KINDS), KINDS)
    return _solve(people, channel, sample_rate, own_frames)


def _solve(people: Moments, channel: NDArray[np.int_], sample_rate: float, own_frames: OwnFrames | None) -> Array:
    """Return the weights of features, each of which belongs to a `channel`."""
    gram: Array = people.gram
    moment: Array = people.moment
    if own_frames is not None:
        frames = WORTH * sample_rate
        gram = np.asarray(frames * gram + own_frames.features.T @ own_frames.features, dtype=np.float64)
        moment = np.asarray(frames * moment + own_frames.features.T @ own_frames.label, dtype=np.float64)
    gram = np.where(np.equal.outer(channel, channel), GAIN_UNCERTAINTY * gram, gram)
    power = np.diag(gram).copy()
    power[power <= 0.0] = 1.0  # a channel that no other person had
    return ridge(gram, moment, RIDGE * power)


def solve_direction(people: Moments, sample_rate: float, own_frames: OwnFrames | None = None) -> Array:
    """Return weights (d,) of the newest rates alone, all others 0; parameters as of `solve`.

    Such a map ends when the movement ends, also when the labels that it is learnt from are longer than the movement.
    """
    d = len(people.moment)
    k = d // KINDS
    newest = Moments(people.gram[:k, :k], people.moment[:k], people.stroke_mean[:k], people.stroke_gram[:k, :k])
    rates = (
        None
        if own_frames is None
        else OwnFrames(own_frames.features[:, :k], own_frames.label, own_frames.repetition, own_frames.asked)
    )
    weights = np.zeros(d)
    weights[:k] = _solve(newest, np.arange(k), sample_rate, rates)
    return weights


def thresholds(weights: Array, people: Moments) -> tuple[float, float]:
    """Return dead-zone and full of a map, in the unit of its rate, from other people's strokes.

    One or two repetitions of one's own set the dead-zone worse: that was the main harm of a short calibration. The
    full of others is beyond the reach of a slow person: `app.calibration.prior.prior_map.own_full`.
    """
    mean = float(weights @ people.stroke_mean)
    deviation = math.sqrt(max(0.0, float(weights @ people.stroke_gram @ weights) - mean * mean))
    return mean + DEAD_ZONE_DEVIATIONS * deviation, mean + FULL_DEVIATIONS * deviation
