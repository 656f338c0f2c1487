"""A chair that drives a circle endlessly, so that each position has one time per round."""

import math
from typing import Final

import numpy as np

from app.messages import TICK

TICK_RATE: Final = 200.0  # Hz: faster than the scene's updates
RADIUS: Final = 2.0  # m
TURN_RATE: Final = 0.4  # rad/s
ROUND: Final = math.tau / TURN_RATE  # s


def driving(now: float) -> np.void:
    """Return the tick of the chair at `now` (monotonic s)."""
    angle = TURN_RATE * now
    tick: np.void = np.zeros(1, dtype=TICK)[0]
    tick["number"], tick["t"] = int(now * TICK_RATE), now
    tick["x"], tick["y"] = RADIUS * math.cos(angle), RADIUS * math.sin(angle)
    tick["theta"] = math.remainder(angle + math.pi / 2, math.tau)
    tick["scene_t"] = now
    tick["head_yaw"] = tick["head_pitch"] = tick["head_roll"] = tick["head_age"] = math.nan
    return tick


def age_at(x: float, y: float, now: float) -> float:
    """Return how long (s) before `now` (monotonic s) the chair was at x, y (m): from 0 to less than a round."""
    return (now - math.atan2(y, x) / TURN_RATE) % ROUND
