"""A path as its driver sees it, and the next intention on it: faster, slower, left or right, and by how much."""

# Compiled in a wheel (hatch_build.py).

import bisect
import math
from collections.abc import Sequence
from typing import Literal, NamedTuple

from app.geometry import Pose, wrap_angle
from app.hardware.base import LeaderView
from app.hardware.body.person_parameters import PersonParameters
from app.world.path import Path

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


STEP = 0.1  # m between the places for which a speed is stored
SIGHT = 0.45  # m on either side of a place over which the bend is measured
GENTLE_BEND = 0.3  # rad: a smaller bend does not reduce the speed
SHARP_BEND = 1.2  # rad: a larger bend counts as a corner
OFF = 0.6  # m off the path beyond which the way is stored
LOST = 1.0  # m off the path beyond which the driver returns by the stored way
BACK_AHEAD = 0.6  # m to the stored place that is steered for: a nearer place would be circled
CRUMB = 0.3  # m between stored places
WINDOW = 1.5  # m along the path in which the nearest place is searched


class Intention(NamedTuple):
    """A wish and its size: m/s for faster and slower, rad for left and right."""

    wish: Wish
    effect: float


class DrivingLine:
    """A path with a speed for each place, and the driver's place on it, first its start."""

    def __init__(
        self, points: Sequence[tuple[float, float]], cruise: float, corner: float, goal: float, braking: float
    ) -> None:
        """Compute the speed of each place; speeds in m/s, `braking` in m/s2."""
        self.path = Path(points)
        self.s = 0.0  # m along the path, where the driver is
        self.cross_track = 0.0  # m, left positive
        self._way_back: list[tuple[float, float]] = []  # places (m) since the path was left
        count = max(2, math.ceil(self.path.length / STEP) + 1)
        self._places = [i * self.path.length / (count - 1) for i in range(count)]
        self._speeds = [self._speed_of_bend(s, cruise, corner) for s in self._places]
        self._speeds[-1] = min(self._speeds[-1], goal)
        for i in range(count - 2, -1, -1):
            run = self._places[i + 1] - self._places[i]
            self._speeds[i] = min(self._speeds[i], math.sqrt(self._speeds[i + 1] ** 2 + 2 * braking * run))

    def _speed_of_bend(self, s: float, cruise: float, corner: float) -> float:
        length = self.path.length
        before, after = max(0.0, s - SIGHT), min(length, s + SIGHT)
        bend = abs(wrap_angle(self.path.heading_at(after) - self.path.heading_at(before)))
        share = min(1.0, max(0.0, (bend - GENTLE_BEND) / (SHARP_BEND - GENTLE_BEND)))
        return cruise + (corner - cruise) * share

    def follow(self, x: float, y: float) -> None:
        """Find the nearest place on the path, close to the last place; off the path, store the way."""
        s, self.cross_track = self.path.project_near(x, y, self.s, WINDOW)
        if not self.is_lost:
            self.s = s
        if abs(self.cross_track) < OFF:
            self._way_back.clear()
            return
        for i, (crumb_x, crumb_y) in enumerate(self._way_back):
            if math.hypot(x - crumb_x, y - crumb_y) < CRUMB:  # here before: drop the detour since
                del self._way_back[i + 1 :]
                return
        self._way_back.append((x, y))

    @property
    def is_lost(self) -> bool:
        """Whether the path is so far away that it may lie behind a wall."""
        return abs(self.cross_track) > LOST

    def speed(self, ahead: float) -> float:
        """Return the speed (m/s) of the place `ahead` (m) along the path."""
        place = bisect.bisect_left(self._places, self.s + ahead)
        return self._speeds[min(place, len(self._speeds) - 1)]

    def bearing(self, x: float, y: float, ahead: float) -> float:
        """Return the direction (rad) from (x, y) to the point to steer for, `ahead` (m) along the path."""
        target_x, target_y = self._place_back(x, y) or self.path.point_at(min(self.s + ahead, self.path.length))
        return math.atan2(target_y - y, target_x - x)

    def _place_back(self, x: float, y: float) -> tuple[float, float] | None:
        """Return the last stored place that is far enough from (x, y) to steer for; None when not lost."""
        if self.is_lost:
            for place in reversed(self._way_back):
                if math.hypot(place[0] - x, place[1] - y) > BACK_AHEAD:
                    return place
        return None


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
