"""How far a joint's direction may turn towards what the last movements show (signal-chain.md, section 6)."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

HALF_LIFE = 90.0  # s of movement of the joint, after which a movement counts half
LAST_MINUTE = 60.0  # s of movement over which a change is felt

Vector = NDArray[np.float64]


class Principal(NamedTuple):
    """The main direction of a covariance."""

    weights: Vector  # (k,) unit length, pointing as the direction before did
    share: float  # of the variance that lies along it: the EVR


def exponential_covariance(moved: Vector, sample_rate: float, half_life: float = HALF_LIFE) -> Vector:
    """Return C (k, k) after C <- lam C + (1 - lam) x x^T over all rows x of `moved` (m, k), oldest first.

    `half_life` in s of movement: lam = 0.5 ** (1 / (half_life * sample_rate)). The weights are made to sum to one, so
    that the beginning is not held for stillness; and the rows are divided by their largest entry, which changes no
    direction and keeps huge numbers finite. Zeros when nothing moved or a number is not finite.
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
    """Return the top eigenvector of a covariance with the sign that `before` (k,) has; None when there is none.

    None too when it stands square to `before`: then neither sign is that of the old direction.
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
    """Return the share (0..1) of the variance that lies along a unit vector."""
    total = float(np.trace(covariance))
    return min(1.0, max(0.0, float(weights @ covariance @ weights) / total)) if total > 0 else 0.0


def angle(one: Vector, other: Vector) -> float:
    """Return the angle (degrees, 0..180) between two unit vectors, exact also where it is tiny."""
    along = float(one @ other)
    return math.degrees(math.atan2(float(np.linalg.norm(other - along * one)), along))


def turned(before: Vector, towards: Vector, most: float) -> Vector:
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

    `before` and `after` (k,) take channels to a command; `moved` (m, k), oldest first. Infinite where the old map felt
    nothing and the new one does.
    """
    last = moved[-max(1, round(LAST_MINUTE * sample_rate)) :]
    difference, old = last @ (after - before), last @ before
    change, felt = float(np.sqrt(np.mean(difference**2))), float(np.sqrt(np.mean(old**2)))
    if felt > 0.0:
        return change / felt
    return 0.0 if change == 0.0 else math.inf
