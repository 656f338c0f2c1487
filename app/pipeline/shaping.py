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
        return Twist(self.speed(u1, last.v, dt), self.turn_rate(u2, last.omega, dt))

    def speed(self, u1: float, last: float, dt: float) -> float:
        """Return the forward speed (m/s) to ask for, `dt` (s) after `last`."""
        if self._accelerates_u1:
            return min(self._forward, max(-self._reverse, last + u1 * self._acceleration * dt))
        target = min(self._forward, max(-self._reverse, u1 * self._forward))
        if last * target < 0:  # first to standstill, then the other way
            target = 0.0
        change = (self._acceleration if abs(target) > abs(last) else self._deceleration) * dt
        return min(last + change, max(last - change, target))

    def turn_rate(self, u2: float, last: float, dt: float) -> float:
        """Return the turn rate (rad/s) to ask for, `dt` (s) after `last`."""
        if self._accelerates_u2:
            return min(self._turn, max(-self._turn, last + u2 * self._turn / TURN_BUILD_UP * dt))
        change = self._turn_acceleration * dt
        return min(last + change, max(last - change, u2 * self._turn))
