"""From u1 and u2 to the twist that is asked for: control mode, speeds, ramps. Never on the stop path."""

from collections.abc import Sequence

from app.calibration.vocabulary import DriveParameters
from app.geometry import Twist
from app.pipeline.ramp import Ramp
from app.speeds import Speeds

TURN_BUILD_UP = 1.0  # s: full u2 in acceleration mode reaches the full turn rate after this time


def forward_ramp(speeds: Speeds) -> Ramp:
    """Return the limits of the forward speed."""
    return Ramp(speeds.forward, speeds.reverse, speeds.acceleration, speeds.deceleration, speeds.jerk)


def turn_ramp(speeds: Speeds) -> Ramp:
    """Return the limits of the turn rate."""
    return Ramp(speeds.turn, speeds.turn, speeds.turn_acceleration, speeds.turn_acceleration, speeds.turn_jerk)


class Shaper:
    """Knows what the chair was last told, and for how long nobody has asked a cruising chair for anything."""

    def __init__(self, parameters: DriveParameters) -> None:
        self._accelerates_u1 = parameters.mode_u1 == "acceleration"
        self._accelerates_u2 = parameters.mode_u2 == "acceleration"
        self._cruise_time = parameters.cruise_time
        self.restrict(parameters.speeds)
        self.reset()

    def restrict(self, speeds: Speeds) -> None:
        """Shape within these limits from now on."""
        self._forward, self._turn = forward_ramp(speeds), turn_ramp(speeds)

    def reset(self) -> None:
        """Forget how long nothing was asked for."""
        self._unasked = 0.0

    def step(self, u1: float, u2: float, last: Twist, rates: Twist, dt: float) -> Twist:
        """Return the twist to ask for, `dt` (s) after `last` was commanded with the changes `rates` (per s)."""
        return Twist(self.speed(u1, last.v, rates.v, dt), self.turn_rate(u2, last.omega, rates.omega, dt))

    def speed(self, u1: float, last: float, rate: float, dt: float) -> float:
        """Return the forward speed (m/s) to ask for, `dt` (s) after `last`, which had changed by `rate` (m/s2)."""
        ramp = self._forward
        if self._accelerates_u1:
            self._unasked = 0.0 if u1 else self._unasked + dt
            if self._unasked <= self._cruise_time:
                return last + u1 * ramp.acceleration * dt
            target = 0.0
        else:
            target = min(ramp.top, max(-ramp.bottom, u1 * ramp.top))
            if last * target < 0.0:  # first to standstill, then the other way
                target = 0.0
        return ramp.towards(last, rate, target, dt)

    def coast(self, steps: Sequence[float]) -> int:
        """Let `steps` (s) pass in which nothing is asked and the speed stays; return how many until it runs out."""
        if not self._accelerates_u1:
            return len(steps)
        for count, dt in enumerate(steps):
            if self._unasked + dt > self._cruise_time:
                return count
            self._unasked += dt
        return len(steps)

    def turn_rate(self, u2: float, last: float, rate: float, dt: float) -> float:
        """Return the turn rate (rad/s) to ask for, `dt` (s) after `last`, which had changed by `rate` (rad/s2)."""
        ramp = self._turn
        if self._accelerates_u2:
            return last + u2 * ramp.top / TURN_BUILD_UP * dt
        return ramp.towards(last, rate, u2 * ramp.top, dt)
