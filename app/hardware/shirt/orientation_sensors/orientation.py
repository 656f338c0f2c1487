"""The mathematics of orientation sensors: from quaternions to channels (docs/orientation.md).

A quaternion is (..., 4): x, y, z, w of unit length; it turns vectors of the sensor into vectors of the room. A
rotation vector is (..., 3), rad: its direction is the axis, its length the angle.
"""

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

Rotations = NDArray[np.float64]

_INVERSE: Final = np.array((-1.0, -1.0, -1.0, 1.0))
# From p to the matrix (4, 4), here in one row, by which p multiplies from the left; its columns are x, y, z, w of q.
_LEFT: Final = np.array(
    (
        *((0, 0, 0, 1), (0, 0, -1, 0), (0, 1, 0, 0), (-1, 0, 0, 0)),  # x of p
        *((0, 0, 1, 0), (0, 0, 0, 1), (-1, 0, 0, 0), (0, -1, 0, 0)),
        *((0, -1, 0, 0), (1, 0, 0, 0), (0, 0, 0, 1), (0, 0, -1, 0)),
        *((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)),  # w of p
    ),
    dtype=np.float64,
).reshape(4, 16)
UNIT_TOLERANCE: Final = 0.05  # of the length of a quaternion: float32 and 16-bit sensors stay within 0.001


def unit_quaternion(x: float, y: float, z: float, w: float) -> Rotations | None:
    """Return the quaternion (4,) with length 1; None when it is not finite or its length is far from 1."""
    length = math.sqrt(x * x + y * y + z * z + w * w)
    if not abs(length - 1.0) <= UNIT_TOLERANCE:  # also for NaN
        return None
    return np.array((x, y, z, w)) / length


def inverse(q: Rotations) -> Rotations:
    """Return the inverse rotations (..., 4)."""
    inverted: Rotations = q * _INVERSE
    return inverted


def product(p: Rotations, q: Rotations) -> Rotations:
    """Return the rotations p q (..., 4): first q, then p."""
    by_p = (p @ _LEFT).reshape(*p.shape[:-1], 4, 4)
    multiplied: Rotations = (by_p @ q[..., np.newaxis])[..., 0]
    return multiplied


def logarithm(q: Rotations) -> Rotations:
    """Return the rotation vectors (..., 3) of at most pi (rad) of quaternions (..., 4).

    q and -q are one rotation. The angle is 2 atan2(|vector|, |w|): unlike an arc cosine it is exact near 0, and unlike
    an arc sine near pi.
    """
    vector, w = np.where(q[..., 3:] < 0.0, -q, q)[..., :3], np.abs(q[..., 3:])
    length = np.sqrt((vector * vector).sum(axis=-1, keepdims=True))
    is_none = length == 0.0
    angle_per_length = np.where(is_none, 2.0, 2.0 * np.arctan2(length, w) / np.where(is_none, 1.0, length))
    return vector * angle_per_length


def exponential(vector: Rotations) -> Rotations:
    """Return the quaternions (..., 4) of rotation vectors (..., 3), rad."""
    angle = np.sqrt((vector * vector).sum(axis=-1, keepdims=True))
    # sinc(t) is sin(pi t) / (pi t), and 1 at 0
    return np.concatenate((vector * (0.5 * np.sinc(angle / math.tau)), np.cos(0.5 * angle)), axis=-1)


def nearest_vector(vector: Rotations, before: Rotations) -> Rotations:
    """Return rotation vectors (..., 3) of the rotations of `vector` that are nearest to `before`, rad.

    A whole turn more or less about its axis is the rotation itself. Without this, a vector that passes pi would jump to
    the other end of its axis. Zeros as `before` give vectors of at most pi.
    """
    angle = np.sqrt((vector * vector).sum(axis=-1, keepdims=True))
    angle_before = np.sqrt((before * before).sum(axis=-1, keepdims=True))
    has_axis, had_axis = angle > 0.0, angle_before > 0.0
    axis = np.where(has_axis, vector / np.where(has_axis, angle, 1.0), before / np.where(had_axis, angle_before, 1.0))
    turns = np.round(((before * axis).sum(axis=-1, keepdims=True) - angle) / math.tau)
    nearest: Rotations = vector + axis * (math.tau * turns)
    return nearest


def angle_between(p: Rotations, q: Rotations) -> NDArray[np.float64]:
    """Return the angle (...,) between orientations, rad, 0 to pi."""
    angle: NDArray[np.float64] = np.linalg.norm(logarithm(product(inverse(p), q)), axis=-1)
    return angle


def mean_orientation(q: Rotations) -> Rotations:
    """Return the mean (4,) of orientations (n, 4) that differ little: their normalised sum, all on one side."""
    total = np.where((q @ q[0])[:, np.newaxis] < 0.0, -q, q).sum(axis=0)
    mean: Rotations = total / np.linalg.norm(total)
    return mean


def drift_rate(q: Rotations, step: float) -> float:
    """Return how fast (rad/s) the orientation of a sensor creeps in the room.

    A movement goes there and back, drift goes on: each component of the turn rate has it as its median, as long as the
    sensor moves to one side for less than half of the time.

    Parameters
    ----------
    q : (n, 4) array
        The orientation, n at least 2.
    step : float
        Time between two rows, s.
    """
    rates = logarithm(product(q[1:], inverse(q[:-1]))) / step
    return float(np.linalg.norm(np.median(rates, axis=0)))
