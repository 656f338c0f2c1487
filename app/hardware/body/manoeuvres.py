"""The driver's next intention when turning on the spot or driving backwards."""

import math

from app.geometry import Pose, wrap_angle
from app.hardware.body.person_parameters import PersonParameters
from app.hardware.body.steering import Intention
from app.world.floorplan import PrescribedPath
from app.world.path import Path
from app.world.progress import TurnProgress
from app.world.tasks import Turn

CREEP = 0.03  # m/s: a slower chair counts as standing
SURE = 0.6  # share of the task's tolerance that the driver aims for
NEAR = 0.7  # of the spot's radius: further away the driver returns to the spot
ALONG = 0.5  # share of the distance to the spot that must lie ahead or behind to drive there
RETURN_SPEED = 0.12  # m/s
BACK_SPEED = 0.2  # m/s
BACK_BRAKING = 0.08  # m/s2 of braking that the driver expects while driving backwards
BACK_AHEAD = 0.8  # m along the line to the point that is steered for
BACK_TOLERANCE = 0.1  # rad of heading error that is not corrected


class TurnAim:
    """Stand still, then turn in the asked direction up to the mark; return to the spot after rolling off it."""

    def __init__(self, part: PrescribedPath, task: Turn) -> None:
        self._progress = TurnProgress(part, task)
        self._sign = 1.0 if task.direction == "left" else -1.0
        self._tolerance = SURE * task.tolerance
        self._spot = part.points[0]
        self._near = NEAR * part.goal_radius

    def begin(self) -> None:
        """Begin, or continue after a stop: the angle turned so far is kept."""

    def want(self, t: float, pose: Pose, v: float, *_others: object) -> Intention | None:
        """Return the intention at `t` (s) with the chair at `pose` and speed `v` (m/s), None for no change."""
        self._progress.update(pose, v, t)
        speed = self._speed(pose)
        excess = v - speed
        if abs(excess) > CREEP:
            return Intention("slower" if excess > 0 else "faster", abs(excess))
        if speed != 0.0:
            return None
        left = self._sign * (self._progress.length - self._progress.s)
        if abs(left) <= self._tolerance:
            return None
        return Intention("left" if left > 0 else "right", abs(left))

    def _speed(self, pose: Pose) -> float:
        """Return the wanted speed (m/s): 0 near the spot, and while the spot lies to the side."""
        away_x, away_y = self._spot[0] - pose.x, self._spot[1] - pose.y
        away = math.hypot(away_x, away_y)
        ahead = away_x * math.cos(pose.theta) + away_y * math.sin(pose.theta)
        if away <= self._near or abs(ahead) < ALONG * away:
            return 0.0
        return math.copysign(RETURN_SPEED, ahead)


class BackAim:
    """Drive backwards along a line and stop at its end."""

    def __init__(self, part: PrescribedPath, parameters: PersonParameters) -> None:
        self._line: Path = part.line
        self._near = part.goal_radius
        self._tolerance = parameters.speed_tolerance
        self._s = 0.0

    def begin(self) -> None:
        """Begin, or continue after a stop: the place on the line is kept."""

    def want(self, _t: float, pose: Pose, v: float, *_others: object) -> Intention | None:
        """Return the intention with the chair at `pose` and speed `v` (m/s), None for no change."""
        self._s, _ = self._line.project_near(pose.x, pose.y, self._s, BACK_AHEAD)
        left = self._line.length - self._s
        speed = 0.0 if left <= self._near / 2 else -min(BACK_SPEED, math.sqrt(2 * BACK_BRAKING * left))
        excess = v - speed
        tolerance = self._tolerance if speed else CREEP
        if abs(excess) > tolerance:
            return Intention("slower" if excess > 0 else "faster", abs(excess))
        x, y = self._line.point_at(self._s + BACK_AHEAD)
        if left < BACK_AHEAD:  # beyond its end the line continues straight
            heading = self._line.heading_at(self._line.length)
            x, y = x + (BACK_AHEAD - left) * math.cos(heading), y + (BACK_AHEAD - left) * math.sin(heading)
        error = wrap_angle(math.atan2(pose.y - y, pose.x - x) - pose.theta)
        if speed and abs(error) > BACK_TOLERANCE:
            return Intention("left" if error > 0 else "right", abs(error))
        return None
