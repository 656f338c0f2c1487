"""From u1 and u2 to the requested twist: control mode, speeds, ramps. Stops do not pass through here."""

# Compiled in a wheel (hatch_build.py).

from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.calibration.vocabulary import DriveParameters
from app.geometry import Twist
from app.pipeline.ramp import Ramp
from app.speed_limits import Speeds

TURN_BUILD_UP: Final = 1.0  # s: full u2 in acceleration mode reaches the full turn rate after this time
REST: Final = 0.3  # s with control 0 that count as a rest: people rest so long within 1.4 s while they drive
LEAST_PUSH: Final = 3.0  # s without a rest that are permitted, however short the time-out is


def forward_ramp(speeds: Speeds) -> Ramp:
    """Return the limits of the forward speed."""
    return Ramp(speeds.forward, speeds.reverse, speeds.acceleration, speeds.deceleration, speeds.jerk)


def turn_ramp(speeds: Speeds) -> Ramp:
    """Return the limits of the turn rate."""
    return Ramp(speeds.turn, speeds.turn, speeds.turn_acceleration, speeds.turn_acceleration, speeds.turn_jerk)


class Cruise:
    """The time-outs of an axis that keeps its speed (safety S10): without a wish, and with one that never rests.

    Nobody drives by pushing on and on, but a sensor that is stuck does. `longest` is the time-out (s) while the control
    is 0.
    """

    def __init__(self, longest: float) -> None:
        self._longest = longest
        self._most = max(LEAST_PUSH, self._longest)
        self.reset()

    def reset(self) -> None:
        """Restart the time-outs."""
        self._unasked = self._pushed = 0.0  # s: with control 0, and since the last rest

    def goes_on(self, control: float, dt: float) -> bool:
        """Return whether the speed is still kept after `dt` (s) with this `control`."""
        self._unasked = 0.0 if control else self._unasked + dt
        self._pushed = 0.0 if self._unasked >= REST else self._pushed + dt
        return self._unasked <= self._longest and self._pushed <= self._most

    def coast(self, control: float, steps: NDArray[np.float64]) -> int:
        """Let `steps` (n,) in s pass with a constant control and speed; return how many pass before a time-out."""
        pushed = np.cumsum(np.concatenate(([self._pushed], steps)))
        if control:
            count = int(np.searchsorted(pushed[1:], self._most, side="right"))
            self._unasked, self._pushed = 0.0, float(pushed[count])
            return count
        unasked = np.cumsum(np.concatenate(([self._unasked], steps)))
        rested = unasked >= REST
        is_over = (unasked > self._longest) | (~rested & (pushed > self._most))
        count = int(np.argmax(is_over[1:])) if is_over[1:].any() else len(steps)
        self._unasked = float(unasked[count])
        self._pushed = 0.0 if rested[count] else float(pushed[count])
        return count


class Shaper:
    """How the chair follows the controls: the mode and the limits of each axis.

    `cruise` and `turn_cruise` are the time-outs of axes in acceleration mode, None for an axis in velocity mode.
    """

    def __init__(self, parameters: DriveParameters) -> None:
        self.cruise = Cruise(parameters.cruise_time) if parameters.mode_u1 == "acceleration" else None
        self.turn_cruise = Cruise(parameters.turn_cruise_time) if parameters.mode_u2 == "acceleration" else None
        self.restrict(parameters.speeds)

    def restrict(self, speeds: Speeds) -> None:
        """Set other limits."""
        self._forward, self._turn = forward_ramp(speeds), turn_ramp(speeds)

    def reset(self) -> None:
        """Restart the time-outs."""
        for cruise in (self.cruise, self.turn_cruise):
            if cruise:
                cruise.reset()

    def step(self, u1: float, u2: float, last: Twist, rates: Twist, dt: float) -> Twist:
        """Return the twist to request, `dt` (s) after `last` was commanded with the changes `rates` (per s)."""
        return Twist(self.speed(u1, last.v, rates.v, dt), self.turn_rate(u2, last.omega, rates.omega, dt))

    def speed(self, u1: float, last: float, rate: float, dt: float) -> float:
        """Return the forward speed (m/s) to request, `dt` (s) after `last`, which had changed by `rate` (m/s2)."""
        ramp = self._forward
        if self.cruise:
            if self.cruise.goes_on(u1, dt):
                return last + u1 * ramp.acceleration * dt
            target = 0.0
        else:
            target = min(ramp.top, max(-ramp.bottom, u1 * ramp.top))
            if last * target < 0.0:  # first to standstill, then in the other direction
                target = 0.0
        return ramp.towards(last, rate, target, dt)

    def turn_rate(self, u2: float, last: float, rate: float, dt: float) -> float:
        """Return the turn rate (rad/s) to request, `dt` (s) after `last`, which had changed by `rate` (rad/s2)."""
        ramp = self._turn
        if self.turn_cruise:
            if self.turn_cruise.goes_on(u2, dt):
                return last + u2 * ramp.top / TURN_BUILD_UP * dt
            return ramp.towards(last, rate, 0.0, dt)
        return ramp.towards(last, rate, u2 * ramp.top, dt)
