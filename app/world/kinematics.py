"""Kinematics of the chair: the unicycle of the paper."""

import math

from app.geometry import Pose, Twist

CHAIR_RADIUS = 0.32  # m, of the chair's circular footprint: a powered chair is 0.64 m wide


def step(pose: Pose, twist: Twist, dt: float) -> Pose:
    """Return the pose after `dt` seconds of `twist`, by one Euler step; the heading is wrapped into (-pi, pi].

    Source: the paper's kinematic equations, x' = v cos(theta), y' = v sin(theta), theta' = omega.
    """
    theta = pose.theta + twist.omega * dt
    if not -math.pi < theta <= math.pi:
        theta = math.remainder(theta, math.tau)
    return Pose(
        pose.x + twist.v * math.cos(pose.theta) * dt,
        pose.y + twist.v * math.sin(pose.theta) * dt,
        theta,
    )
