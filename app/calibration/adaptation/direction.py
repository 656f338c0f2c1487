"""Directions of a joint in the space of its channels: covariance, principal direction, limited turn, felt change.

See docs/learning/adapting.md, "The rule".
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

HALF_LIFE = 90.0  # s of the joint's movement after which a row's weight has halved
FELT_WINDOW = 60.0  # s of the joint's movement over which the felt change is computed

Vector = NDArray[np.float64]


class Principal(NamedTuple):
    """The main direction of a covariance."""

    weights: Vector  # (k,) unit length, with the sign of the previous direction
    share: float  # of the variance, along `weights`: the EVR


def exponential_covariance(moved: Vector, sample_rate: float, half_life: float = HALF_LIFE) -> Vector:
    """Return C (k, k) after C <- lam C + (1 - lam) x x^T over all rows x of `moved` (m, k), oldest first.

    `half_life` in s of movement: lam = 0.5 ** (1 / (half_life * sample_rate)). The weights are normalised to a sum of
    one, which makes the start value of C irrelevant. The rows are divided by their largest entry: this changes no
    direction and prevents overflow. Returns zeros when nothing moved or a number is not finite.
    """
    count, channels = moved.shape
    largest = float(np.abs(moved).max(initial=0.0))
    if not 0.0 < largest < math.inf:
        return np.zeros((channels, channels))
    rows = moved / largest
    weights = 0.5 ** (np.arange(count - 1, -1, -1) / (half_life * sample_rate))
    covariance: Vector = (rows * (weights / weights.sum())[:, np.newaxis]).T @ rows
    return covariance


def principal(covariance: Vector, before: Vector) -> Principal | None:
    """Return the top eigenvector of a covariance, with the sign that points along `before` (k,).

    None when the covariance is zero or not finite, or when the eigenvector is orthogonal to `before`: then neither sign
    points along it.
    """
    total = float(np.trace(covariance))
    if not 0.0 < total < math.inf or not np.isfinite(covariance).all():
        return None
    values, vectors = np.linalg.eigh(covariance / total)
    along = float(vectors[:, -1] @ before)
    if along == 0.0:
        return None
    return Principal(vectors[:, -1] * math.copysign(1.0, along), min(1.0, max(0.0, float(values[-1]))))


def share_along(covariance: Vector, weights: Vector) -> float:
    """Return the share (0..1) of the variance along the unit vector `weights` (k,)."""
    total = float(np.trace(covariance))
    return min(1.0, max(0.0, float(weights @ covariance @ weights) / total)) if total > 0 else 0.0


def angle(first: Vector, second: Vector) -> float:
    """Return the angle (degrees, 0..180) between two unit vectors, by atan2, which is exact for small angles too."""
    along = float(first @ second)
    return math.degrees(math.atan2(float(np.linalg.norm(second - along * first)), along))


def turn_towards(before: Vector, towards: Vector, most: float) -> Vector:
    """Return the unit vector `before` turned towards the unit vector `towards` by at most `most` degrees."""
    if angle(before, towards) <= most:
        return towards
    aside = towards - (towards @ before) * before
    aside /= np.linalg.norm(aside)
    radians = math.radians(most)
    step: Vector = math.cos(radians) * before + math.sin(radians) * aside
    return step / np.linalg.norm(step)


def felt_change(before: Vector, after: Vector, moved: Vector, sample_rate: float) -> float:
    """Return rms(W_new x - W_old x) / rms(W_old x) over the last minute of movement.

    W_old is `before` (k,), W_new is `after` (k,), the rows x are those of `moved` (m, k), oldest first. Infinite where
    only the new map gives an output.
    """
    last = moved[-max(1, round(FELT_WINDOW * sample_rate)) :]
    difference, old = last @ (after - before), last @ before
    change, felt = float(np.sqrt(np.mean(difference**2))), float(np.sqrt(np.mean(old**2)))
    if felt > 0.0:
        return change / felt
    return 0.0 if change == 0.0 else math.inf
