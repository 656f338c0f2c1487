"""Places and speeds on the floor: x ahead, y left, angles counter-clockwise, SI units."""

import math
from typing import NamedTuple


class Twist(NamedTuple):
    """What a chair is told to do."""

    v: float  # forward speed, m/s
    omega: float  # turn rate, rad/s, left positive


class Pose(NamedTuple):
    """Where a chair stands and where it looks."""

    x: float  # m
    y: float  # m
    theta: float  # rad, 0 along x


STANDSTILL = Twist(0.0, 0.0)


def wrap_angle(angle: float) -> float:
    """Return `angle` (rad) brought into (-pi, pi]."""
    wrapped = math.remainder(angle, math.tau)
    return math.pi if wrapped == -math.pi else wrapped
