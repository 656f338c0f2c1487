"""Poses and twists on the floor: x ahead, y left, angles counter-clockwise, SI units."""

# Compiled in a wheel (hatch_build.py).

import math
from typing import NamedTuple


class Twist(NamedTuple):
    """A command to a chair: forward speed and turn rate."""

    v: float  # forward speed, m/s
    omega: float  # turn rate, rad/s, left positive


class Pose(NamedTuple):
    """Position and heading of a chair in the plan."""

    x: float  # m
    y: float  # m
    theta: float  # rad, 0 along x


STANDSTILL = Twist(0.0, 0.0)


def wrap_angle(angle: float) -> float:
    """Return `angle` (rad) wrapped into (-pi, pi]."""
    wrapped = math.remainder(angle, math.tau)
    return math.pi if wrapped == -math.pi else wrapped
