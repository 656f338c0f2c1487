"""From u1 and u2 to the twist that is asked for: control mode, speeds, ramps. Never on the stop path."""

from app.calibration.vocabulary import DriveParameters
from app.geometry import Twist

TURN_BUILD_UP = 1.0  # s: full u2 in acceleration mode reaches the full turn rate after this time


class Shaper:
    """Holds no state: what the chair was last told comes in, what it should be told next goes out."""

    def __init__(self, parameters: DriveParameters) -> None:
        speeds = parameters.speeds
        self._accelerates_u1 = parameters.mode_u1 == "acceleration"
        self._accelerates_u2 = parameters.mode_u2 == "acceleration"
        self._forward = speeds.forward
        self._reverse = speeds.reverse
        self._turn = speeds.turn
        self._acceleration = speeds.acceleration
        self._deceleration = speeds.deceleration
        self._turn_acceleration = speeds.turn_acceleration

    def step(self, u1: float, u2: float, last: Twist, dt: float) -> Twist:
        """Return the twist to ask for, `dt` (s) after `last` was commanded."""
        if self._accelerates_u1:
            v = last.v + u1 * self._acceleration * dt
        else:
            v = self._ramp(last.v, u1 * self._forward, dt)
        v = min(self._forward, max(-self._reverse, v))
        if self._accelerates_u2:
            omega = last.omega + u2 * self._turn / TURN_BUILD_UP * dt
        else:
            step = self._turn_acceleration * dt
            omega = min(last.omega + step, max(last.omega - step, u2 * self._turn))
        return Twist(v, min(self._turn, max(-self._turn, omega)))

    def _ramp(self, last: float, target: float, dt: float) -> float:
        """Return the speed (m/s) that moves from `last` towards `target` as fast as the ramps allow."""
        target = min(self._forward, max(-self._reverse, target))
        if last * target < 0:  # first to standstill, then the other way
            target = 0.0
        change = (self._acceleration if abs(target) > abs(last) else self._deceleration) * dt
        return min(last + change, max(last - change, target))
