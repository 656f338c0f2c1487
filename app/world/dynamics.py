"""Dynamics of a powered wheelchair: a unicycle with lagging motors, castors and wheel slip.

Two driven wheels behind, two castors in front. Deterministic; without these effects the model is the unicycle.

Sources
-------
Castor orientations beside the wheel speeds as the chair's state: Johnson and Aylor, IEEE Trans. Industry Applications
IA-21, 1985. A castor's wheel rolls and does not skid: Campion, Bastin and D'Andrea-Novel, IEEE Trans. Robotics and
Automation 12, 1996. Reversing with castors across pushes a chair off its direction: Guo, Cooper, Corfman, Ding and
Grindle, Assistive Technology 15, 2003. That wheels slip on ordinary floors: Wang, Salatin, Grindle, Ding and Cooper,
Medical Engineering and Physics 31, 2009. The numbers are plausible choices, not those of one measured chair.
"""

# Compiled in a wheel (hatch_build.py).

import math
from dataclasses import dataclass, fields
from typing import NamedTuple

from app.geometry import STANDSTILL, Pose, Twist
from app.world.kinematics import unicycle

REST_SPEED, REST_TURN = 1e-3, 1e-3  # m/s, rad/s: below both, and commanded to stand, the parking brakes close
POISE = math.pi - 0.1  # rad: largest angle of a castor to its way; the unstable balance at pi does not occur on a floor


@dataclass(frozen=True, slots=True)
class Wheelchair:
    """The parameters by which a chair differs from the unicycle.

    Attributes
    ----------
    speed_lag, turn_lag : s until 63 % of a change of speed or turn rate is done, 0 to 2. Chairs of 150 kg with motors
        and gears need 0.1 to 0.4 s; turning moves less mass.
    wheelbase : m from the driven axle forwards to the castors' stems, 0.3 to 0.8.
    track : m between the stems, 0.2 to 0.8.
    trail : m from a stem to its wheel's contact with the floor, 0.02 to 0.1. A castor aligns within about six trails of
        way.
    castor_push : share of the speed at which a castor's wheel is dragged sideways that the chair loses at the castor,
        0 to 0.5: larger shares make the model unstable.
    turn_slip, speed_slip : share of turn rate and of speed lost for each m/s2 of lateral acceleration, s2/m, 0 to 0.5.
        The turn loses more, so that the chair drifts to the outside of a curve.
    largest_slip : largest share that is lost, 0 to 0.5.

    Raises
    ------
    ValueError
        When a parameter is out of its bounds.
    """

    speed_lag: float = 0.2
    turn_lag: float = 0.12
    wheelbase: float = 0.45
    track: float = 0.4
    trail: float = 0.06
    castor_push: float = 0.4
    turn_slip: float = 0.06
    speed_slip: float = 0.02
    largest_slip: float = 0.3

    def __post_init__(self) -> None:
        """Check the bounds."""
        for field in fields(self):
            low, high = BOUNDS[field.name]
            value = getattr(self, field.name)
            if not low <= value <= high:
                raise ValueError(f"the wheelchair's {field.name} is {value}: give one between {low} and {high}")


BOUNDS = {
    "speed_lag": (0.0, 2.0),
    "turn_lag": (0.0, 2.0),
    "wheelbase": (0.3, 0.8),
    "track": (0.2, 0.8),
    "trail": (0.02, 0.1),
    "castor_push": (0.0, 0.5),
    "turn_slip": (0.0, 0.5),
    "speed_slip": (0.0, 0.5),
    "largest_slip": (0.0, 0.5),
}


class Motion(NamedTuple):
    """The state of a chair: pose, speeds, and directions of its castors."""

    pose: Pose
    v: float = 0.0  # m/s, forwards
    omega: float = 0.0  # rad/s
    left: float = 0.0  # rad, rolling direction of the left castor from straight ahead
    right: float = 0.0  # rad, rolling direction of the right castor


def step(motion: Motion, twist: Twist, dt: float, chair: Wheelchair) -> Motion:
    """Return the motion after `dt` seconds (above 0) of the command `twist`."""
    pose, v, omega, left, right = motion
    across = abs(v * omega)  # m/s2
    target_v = twist.v * (1.0 - min(chair.largest_slip, chair.speed_slip * across))
    target_omega = twist.omega * (1.0 - min(chair.largest_slip, chair.turn_slip * across))
    if chair.castor_push:
        left, left_v, left_omega = _castor(left, chair.track / 2, v, omega, dt, chair)
        right, right_v, right_omega = _castor(right, -chair.track / 2, v, omega, dt, chair)
        target_v += left_v + right_v
        target_omega += left_omega + right_omega
    v = _follow(v, target_v, dt, chair.speed_lag)
    omega = _follow(omega, target_omega, dt, chair.turn_lag)
    if twist == STANDSTILL and abs(v) < REST_SPEED and abs(omega) < REST_TURN:
        v = omega = 0.0
    return Motion(Pose(*unicycle(*pose, v, omega, dt)), v, omega, left, right)


def _follow(speed: float, target: float, dt: float, lag: float) -> float:
    """Return the exact solution of a first-order lag (s): `speed` after `dt` (s) with a constant `target`."""
    return target + (speed - target) * math.exp(-dt / lag) if lag else target


def _castor(angle: float, y: float, v: float, omega: float, dt: float, chair: Wheelchair) -> tuple[float, float, float]:
    """Return a castor's new angle (rad), and the changes of speed (m/s) and turn rate (rad/s) that it causes.

    The stem is `y` (m) left of the middle and pulls the wheel: the angle a between the stem's velocity and the wheel
    obeys a' = -(speed / trail) sin(a), hence tan(a / 2) = tan(a0 / 2) exp(-way / trail), while the chair turns by
    omega dt. The floor resists the sideways motion of the wheel at its contact, across the wheel: this only takes
    energy from the chair, and none while the castors keep their angles.
    """
    stem_x, stem_y = v - omega * y, omega * chair.wheelbase
    speed = math.hypot(stem_x, stem_y)
    if not speed:
        return angle, 0.0, 0.0
    heading = math.atan2(stem_y, stem_x)
    error = math.remainder(angle - heading, math.tau)
    error = min(POISE, max(-POISE, error))
    swung = 2.0 * math.atan(math.tan(error / 2.0) * math.exp(-speed * dt / chair.trail))
    change = swung - error - omega * dt
    middle = heading + error + change / 2.0
    push = chair.castor_push * chair.trail * change / dt / 2.0  # each castor carries half of the front
    sine, cosine = math.sin(middle), math.cos(middle)
    arm = chair.wheelbase * cosine + y * sine - chair.trail
    new_angle = math.remainder(heading + error + change, math.tau)
    return new_angle, push * sine, -push * arm / (chair.wheelbase**2 + y**2)
