"""The moments of one joint's features and labels, which are all that a prior keeps of a recording."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Self

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import KINDS

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Moments:
    """Means over the frames of a recording, or sums of such means over people; d = 7k features of k channels.

    The features are those of signals divided by the scale of their channel (`app.calibration.prior.scale`). Those of a
    channel that cannot be used are zero.
    """

    gram: Array  # (d, d) mean of F'F
    moment: Array  # (d,) mean of F'y; y is +1 in a prompted stroke, -1 on the way back, 0 elsewhere
    stroke_mean: Array  # (d,) mean of F in the strokes
    stroke_gram: Array  # (d, d) mean of F'F in the strokes

    @classmethod
    def of(cls, features: Array, label: NDArray[np.int8]) -> Self:
        """Return the moments of one recording: features (n, d) with labels (n,), among them at least one +1."""
        strokes = features[label > 0]
        return cls(
            features.T @ features / len(features),
            features.T @ label / len(features),
            strokes.mean(axis=0),
            strokes.T @ strokes / len(strokes),
        )

    @classmethod
    def zero(cls, channels: int) -> Self:
        """Return the sum over nobody."""
        d = KINDS * channels
        return cls(np.zeros((d, d)), np.zeros(d), np.zeros(d), np.zeros((d, d)))

    def __add__(self, other: Self) -> Self:
        return type(self)(*(part + another for part, another in zip(self._parts, other._parts, strict=True)))

    def __mul__(self, share: float) -> Self:
        return type(self)(*(share * part for part in self._parts))

    def rescaled(self, factors: Array) -> Self:
        """Return the moments of features whose channels (k,) are multiplied by `factors`."""
        each = np.tile(factors, KINDS)
        both = np.outer(each, each)
        return type(self)(self.gram * both, self.moment * each, self.stroke_mean * each, self.stroke_gram * both)

    def of_channels(self, channels: Sequence[int] | NDArray[np.int_]) -> Self:
        """Return the moments of some of the channels, in the order given."""
        count = len(self.moment) // KINDS
        rows = np.add.outer(count * np.arange(KINDS), np.asarray(channels, dtype=np.int_)).ravel()
        both = np.ix_(rows, rows)
        return type(self)(self.gram[both], self.moment[rows], self.stroke_mean[rows], self.stroke_gram[both])

    def at_places(self, channels: Sequence[int] | NDArray[np.int_], count: int) -> Self:
        """Return the moments of `count` channels: these at the places `channels`, zero for all others."""
        d = KINDS * count
        rows = np.add.outer(count * np.arange(KINDS), np.asarray(channels, dtype=np.int_)).ravel()
        gram, moment, stroke_mean, stroke_gram = np.zeros((d, d)), np.zeros(d), np.zeros(d), np.zeros((d, d))
        both = np.ix_(rows, rows)
        gram[both], moment[rows] = self.gram, self.moment
        stroke_mean[rows], stroke_gram[both] = self.stroke_mean, self.stroke_gram
        return type(self)(gram, moment, stroke_mean, stroke_gram)

    @property
    def _parts(self) -> tuple[Array, Array, Array, Array]:
        return self.gram, self.moment, self.stroke_mean, self.stroke_gram


def mean_of(moments: Iterable[Moments]) -> Moments:
    """Return the mean over at least one recording."""
    every = list(moments)
    return reduce(add, every) * (1.0 / len(every))
