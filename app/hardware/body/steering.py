"""What a driver wants next: faster, slower, left or right, and how much of it."""

import math
from collections.abc import Sequence
from typing import Literal, NamedTuple

from app.geometry import Pose, wrap_angle
from app.hardware.body.course import Course
from app.hardware.body.person_parameters import PersonParameters

Wish = Literal["faster", "slower", "left", "right"]

TURN_SLOWLY = 0.5  # rad of heading error from which on speed is taken away
TURN_ON_THE_SPOT = 1.2  # rad of heading error at which none is left
TOO_FAST = 0.15  # m/s above what fits: braking comes before turning
ROLLING_BACK = -0.05  # m/s: slower than this, going forward again comes before turning
STUCK_TIME = 1.2  # s without getting anywhere, though the chair should move
STUCK_DISTANCE = 0.06  # m that count as getting somewhere
STUCK_SPEED = 0.1  # m/s from which on the chair should move
BACK_SPEED = -0.15  # m/s away from a wall
BACK_DISTANCE = 0.3  # m to back away
BACK_TIME = 8.0  # s, then forward is tried again


class Intention(NamedTuple):
    """A wish and its size: m/s for faster and slower, rad for left and right."""

    wish: Wish
    effect: float


class Steering:
    """Follows a path by sight: slows before corners, turns towards the path, backs away from what it is stuck at."""

    def __init__(self, points: Sequence[tuple[float, float]], parameters: PersonParameters) -> None:
        p = self._parameters = parameters
        self.course = Course(points, p.cruise_speed, p.corner_speed, p.goal_speed, p.braking)
        self._anchor: tuple[float, float, float] | None = None  # x, y, t: where and when it last got somewhere
        self._backing: tuple[float, float, float] | None = None  # x, y, t: where and when backing away began

    def begin(self, pose: Pose) -> None:
        """Look where the chair stands at the start of a drive."""
        self.course.begin(pose)
        self._anchor = self._backing = None

    def want(self, t: float, pose: Pose, v: float, practice: float = 0.0) -> Intention | None:
        """Return what is wanted at `t` (s) with the chair at `pose` and speed `v` (m/s), or None when all is well.

        `practice` is how many strokes the driver has behind him.
        """
        p, course = self._parameters, self.course
        course.follow(pose.x, pose.y)
        ahead = p.look_ahead + p.speed_look_ahead * max(0.0, v)
        error = wrap_angle(course.bearing(pose.x, pose.y, ahead) - pose.theta)
        backing = self._is_backing(t, pose, v)
        if backing:
            speed = BACK_SPEED
        else:
            share = (TURN_ON_THE_SPOT - abs(error)) / (TURN_ON_THE_SPOT - TURN_SLOWLY)
            speed = course.speed(max(0.0, v)) * min(1.0, max(0.0, share))  # where it will be in a second
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

    def _is_backing(self, t: float, pose: Pose, v: float) -> bool:
        """Return whether to back away: from being stuck until a little way off."""
        x, y, since = self._anchor or (pose.x, pose.y, t)
        if abs(v) < STUCK_SPEED or math.hypot(pose.x - x, pose.y - y) > STUCK_DISTANCE:
            x, y, since = pose.x, pose.y, t
        self._anchor = (x, y, since)
        stuck = t - since > STUCK_TIME
        if self._backing:
            x, y, since = self._backing
            far = math.hypot(pose.x - x, pose.y - y) >= BACK_DISTANCE
            if far or t - since > BACK_TIME or (stuck and v < 0):
                self._backing = None
        elif stuck and v > 0:
            self._backing = (pose.x, pose.y, t)
        return self._backing is not None
