"""The ramp of a stop: how the gate brings each axis to standstill; no earlier step of the chain takes part."""

# Compiled in a wheel (hatch_build.py).

from typing import Final

STOP_DECELERATION: Final = 3.0  # m/s2: the upper end of what powered chairs do
STOP_TURN_DECELERATION: Final = 6.0  # rad/s2
STOP_TIME: Final = 0.25  # s: longest stop from any permitted speed


def stop_rate(speed: float, deceleration: float) -> float:
    """Return the deceleration of a stop from `speed`: `deceleration`, or more where STOP_TIME needs it."""
    return max(deceleration, abs(speed) / STOP_TIME)


def towards_zero(speed: float, change: float) -> float:
    """Return `speed` moved by `change` towards zero, at most to zero."""
    return max(0.0, speed - change) if speed > 0 else min(0.0, speed + change)
