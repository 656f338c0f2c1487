"""Kinematics of the chair: the unicycle of the paper."""

# Compiled in a wheel (hatch_build.py).

import math


def unicycle(x: float, y: float, theta: float, v: float, omega: float, dt: float) -> tuple[float, float, float]:
    """Return x, y (m) and theta (rad) after `dt` seconds at speed `v` and turn rate `omega`, by one Euler step.

    The heading is wrapped into (-pi, pi]. Source: the paper's kinematic equations, x' = v cos(theta),
    y' = v sin(theta), theta' = omega.
    """
    turned = theta + omega * dt
    if not -math.pi < turned <= math.pi:
        turned = math.remainder(turned, math.tau)
    return x + v * math.cos(theta) * dt, y + v * math.sin(theta) * dt, turned
