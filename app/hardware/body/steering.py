"""The driver's next intention on a path: faster, slower, left or right, and by how much."""

# Compiled in a wheel (hatch_build.py).

import math
from collections.abc import Sequence
from typing import Literal, NamedTuple

from app.geometry import Pose, wrap_angle
from app.hardware.base import LeaderView
from app.hardware.body.course import DrivingLine
from app.hardware.body.person_parameters import PersonParameters

Wish = Literal["faster", "slower", "left", "right"]

TURN_SLOWLY = 0.5  # rad of heading error above which the speed is reduced
TURN_ON_THE_SPOT = 1.2  # rad of heading error above which the speed is 0
TOO_FAST = 0.15  # m/s above the wanted speed: braking comes before turning
ROLLING_BACK = -0.05  # m/s: below it, driving forward again comes before turning
STUCK_TIME = 1.2  # s without progress although the chair should move
STUCK_DISTANCE = 0.06  # m that count as progress
STUCK_SPEED = 0.1  # m/s above which the chair should move
BACK_SPEED = -0.15  # m/s away from a wall
BACK_DISTANCE = 0.3  # m to back away
BACK_TIME = 6.0  # s, then forward is tried again
FOLLOWING = 0.35  # 1/s: m/s faster for each metre that the leader is too far ahead
GRACE = 2.0  # s after backing in which the chair does not count as stuck


class Intention(NamedTuple):
    """A wish and its size: m/s for faster and slower, rad for left and right."""

    wish: Wish
    effect: float


class Steering:
    """Follows a path by sight: slows before corners, turns towards the path, backs away from obstacles."""

    def __init__(
        self, points: Sequence[tuple[float, float]], parameters: PersonParameters, distance: float | None = None
    ) -> None:
        """Take the path; `distance` (m) is to be kept behind a leader, when there is one."""
        p = self._parameters = parameters
        self._distance = distance
        self.course = DrivingLine(points, p.cruise_speed, p.corner_speed, p.goal_speed, p.braking)
        self._anchor: tuple[float, float, float] | None = None  # x, y, t: place and time of the last progress
        self._backing: tuple[float, float, float] | None = None  # x, y, t: place and time at which backing away began

    def begin(self) -> None:
        """Begin, or continue after a stop: keep the place on the path, reset the detection of being stuck."""
        self._anchor = self._backing = None

    def want(
        self, t: float, pose: Pose, v: float, in_contact: bool, practice: float, leader: LeaderView | None = None
    ) -> Intention | None:
        """Return the intention at `t` (s) with the chair at `pose` and speed `v` (m/s), None for no change.

        `in_contact`: the chair touches something. `practice`: strokes practised so far.
        """
        p, course = self._parameters, self.course
        course.follow(pose.x, pose.y)
        ahead = p.look_ahead + p.speed_look_ahead * max(0.0, v)
        error = wrap_angle(course.bearing(pose.x, pose.y, ahead) - pose.theta)
        backing = self._is_backing(t, pose, v, in_contact)
        if backing:
            speed = BACK_SPEED
        else:
            share = (TURN_ON_THE_SPOT - abs(error)) / (TURN_ON_THE_SPOT - TURN_SLOWLY)
            speed = self._fitting(pose, v, leader) * min(1.0, max(0.0, share))
        excess = v - speed
        tolerance = max(p.speed_tolerance, 0.15 * abs(speed))
        if excess > (max(tolerance, TOO_FAST) if speed else tolerance):
            return Intention("slower", excess)
        if v < ROLLING_BACK and not backing and -excess > tolerance:
            return Intention("faster", -excess)
        if abs(error) > p.heading_tolerance.after(practice) and not (backing and v < ROLLING_BACK):
            return Intention("left" if error > 0 else "right", abs(error))
        if excess > tolerance:
            return Intention("slower", excess)
        if -excess > tolerance:
            return Intention("faster", -excess)
        return None

    def _fitting(self, pose: Pose, v: float, leader: LeaderView | None) -> float:
        """Return the speed (m/s) that fits the path one second ahead, and behind a leader the distance to keep."""
        speed = self.course.speed(max(0.0, v))
        if leader is None or self._distance is None:
            return speed
        gap = math.hypot(leader.pose.x - pose.x, leader.pose.y - pose.y) - self._distance
        behind = leader.v + FOLLOWING * gap
        return min(max(speed, self._parameters.corner_speed), max(0.0, behind))

    def _is_backing(self, t: float, pose: Pose, v: float, in_contact: bool) -> bool:
        """Return whether to back away: when stuck, until `BACK_DISTANCE` is reached or `BACK_TIME` is over."""
        x, y, since = self._anchor or (pose.x, pose.y, t)
        should_move = abs(v) > STUCK_SPEED or in_contact  # a chair at a wall does not move
        if not should_move or math.hypot(pose.x - x, pose.y - y) > STUCK_DISTANCE:
            x, y, since = pose.x, pose.y, t
        self._anchor = (x, y, since)
        if self._backing is None and t - since > STUCK_TIME:
            self._backing = (pose.x, pose.y, t)
        elif self._backing is not None:
            x, y, since = self._backing
            if math.hypot(pose.x - x, pose.y - y) >= BACK_DISTANCE or t - since > BACK_TIME:
                self._backing = None
                self._anchor = (pose.x, pose.y, t + GRACE)
        return self._backing is not None
