"""The path as a driver sees it: the point to steer for, and the speed for each place."""

# Compiled in a wheel (hatch_build.py).

import bisect
import math
from collections.abc import Sequence

from app.geometry import wrap_angle
from app.world.path import Path

STEP = 0.1  # m between the places for which a speed is stored
SIGHT = 0.45  # m on either side of a place over which the bend is measured
GENTLE_BEND = 0.3  # rad: a smaller bend does not reduce the speed
SHARP_BEND = 1.2  # rad: a larger bend counts as a corner
OFF = 0.6  # m off the path beyond which the way is stored
LOST = 1.0  # m off the path beyond which the driver returns by the stored way
BACK_AHEAD = 0.6  # m to the stored place that is steered for: a nearer place would be circled
CRUMB = 0.3  # m between stored places
WINDOW = 1.5  # m along the path in which the nearest place is searched


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
