"""How much of a joint's movement the direction of its map does not see."""

import math

import numpy as np
from numpy.typing import NDArray

from app.calibration.adaptation.change_limits import STANDARD_LIMITS
from app.calibration.adaptation.direction import principal, share_along
from app.calibration.adaptation.movement import LONGEST_BREAK, SHORTEST_PIECE, stretches
from app.calibration.profile import JointMap

Numbers = NDArray[np.float64]


def blindness(joint: JointMap, values: Numbers, moving: NDArray[np.bool_], sample_rate: float) -> float | None:
    """Return the share (0..1) of the movement's rate that is lost because the map points beside the movement.

    It is 1 - sqrt(share of the variance along the map / share along the movement's own main direction). A direction
    that is 8 degrees off loses 0.01, one of 18 degrees 0.05, one of 26 degrees 0.10.

    Parameters
    ----------
    joint
        With a PCA map; other maps have no direction to turn, and the answer is None.
    values
        (n, n_channels) signal units, without missing samples.
    moving
        (n,) where the joint makes a movement of its own.
    sample_rate
        Hz.
    """
    weights = np.array(joint.direction)
    if joint.map != "pca":
        return None
    signals = values[:, list(joint.channels)] * (weights != 0.0)
    pieces = stretches(moving, LONGEST_BREAK, SHORTEST_PIECE, sample_rate)
    rows = [signals[piece] - signals[piece].mean(axis=0) for piece in pieces]
    if sum(map(len, rows)) < STANDARD_LIMITS.least_movement * sample_rate:
        return None
    moved = np.concatenate(rows)
    covariance = moved.T @ moved
    found = principal(covariance, weights)
    if found is None or found.share <= 0.0:
        return None
    return max(0.0, 1.0 - math.sqrt(min(1.0, share_along(covariance, weights) / found.share)))
