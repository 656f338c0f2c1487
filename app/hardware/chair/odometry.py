"""Dead reckoning: the pose of a chair from the speeds that it reports."""

import math

from app.geometry import Pose, Twist, wrap_angle

STRAIGHT = 1e-6  # rad: for a smaller turn, chord and arc are equal to within rounding


def arc(pose: Pose, twist: Twist, dt: float) -> Pose:
    """Return the pose after `dt` (s) of constant `twist`: exact for the unicycle, also for large steps.

    The chord of an arc of v dt metres with the turn a = omega dt has the length v dt sin(a/2) / (a/2); its direction
    is the old heading plus half of the turn. Source: Thrun, Burgard, Fox, Probabilistic Robotics (2005), section 5.3.3.
    """
    turn = twist.omega * dt
    half = turn / 2
    chord = twist.v * dt * (math.sin(half) / half if abs(turn) > STRAIGHT else 1.0)
    return Pose(
        pose.x + chord * math.cos(pose.theta + half),
        pose.y + chord * math.sin(pose.theta + half),
        wrap_angle(pose.theta + turn),
    )
