"""The simulated person as a driver: sees with a delay, moves in strokes, makes errors, and learns."""

# Compiled in a wheel (hatch_build.py).

import math
import random
from collections import deque

from app.geometry import Pose, wrap_angle
from app.hardware.base import LeaderView
from app.hardware.body.person_parameters import PersonParameters
from app.hardware.body.steering import Intention, Steering, Wish
from app.hardware.body.stroke_estimate import StrokeEstimate
from app.hardware.body.stroke_maker import OTHER_ELBOW, StrokeMaker
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.path import Path
from app.world.progress import TaskProgress, TurnProgress, progress_of
from app.world.tasks import Back, FollowLeader, Turn

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


Aim = Steering | TurnAim | BackAim

LIMB_OF: dict[Wish, str] = {
    "faster": "right_elbow",
    "slower": "left_elbow",
    "left": "right_shoulder",
    "right": "left_shoulder",
}
WISH_OF: dict[str, Wish] = {limb: wish for wish, limb in LIMB_OF.items()}
USUAL_EFFECT: dict[Wish, float] = {"faster": 0.3, "slower": 0.3, "left": 0.45, "right": 0.45}
"""Effect of a full stroke under the standard parameters, m/s and rad; first estimates are spread around it."""
USUAL_LOSS = 0.08  # of the range, lost in the dead-zone
LARGEST_FIRST_ERROR = 1.5  # of a first estimate, in standard deviations
LOOK_PERIOD = 0.05  # s between two decisions
SLOWEST, FASTEST = -0.29, 0.79  # m/s: beyond these speeds the limits cut the effect of a stroke
SETTLING = 0.12  # s until the effect of a finished stroke has passed the low-pass filter


class Stroke:
    """A stroke whose outcome is not yet seen, and the speed or heading before it."""

    __slots__ = ("before", "end", "limb", "size", "spoilt")

    def __init__(self, limb: str, size: float, end: float, before: float) -> None:
        self.limb, self.size, self.end, self.before = limb, size, end, before
        self.spoilt = False  # whether a wall affected the outcome


class Driver:
    """Decides on strokes of four limbs from what is seen of the chair."""

    def __init__(self, parameters: PersonParameters, seed: int) -> None:
        self.parameters = parameters
        self._random = random.Random(seed)
        self.strokes = StrokeMaker(parameters, self._random)
        spread = parameters.estimate_error.after(parameters.practice)
        self.estimates = {
            limb: StrokeEstimate(USUAL_EFFECT[wish] * math.exp(spread * self._first_error()), USUAL_LOSS)
            for limb, wish in WISH_OF.items()
        }
        self.steering: Aim | None = None
        self._course: TaskProgress | None = None  # of a task with several stages
        self._seen: deque[tuple[float, Pose, float, bool, LeaderView | None]] = deque()
        self._open: list[Stroke] = []  # strokes whose outcome has not been seen yet
        self._free_at = 0.0
        self._look_at = 0.0
        self._began = False
        self._rested = 0.0  # s of the task in which the chair was not permitted to move
        self._driven = 0.0  # s of the task in which the chair was permitted to move

    def _first_error(self) -> float:
        """Return the error of a first estimate in standard deviations, clipped to [-1.5, 1.5]."""
        return min(LARGEST_FIRST_ERROR, max(-LARGEST_FIRST_ERROR, self._random.gauss(0, 1)))

    def show_task(self, plan: FloorPlan, path: PrescribedPath) -> None:
        """Take the floor plan and the path to drive."""
        progress = progress_of(plan, path)
        self._course = progress if progress.stages > 1 else None
        self._driven = 0.0
        self.steering = self._aim(progress.part)
        self._began = False

    def _aim(self, part: PrescribedPath) -> Aim:
        match part.task:
            case Turn():
                return TurnAim(part, part.task)
            case Back():
                return BackAim(part, self.parameters)
            case FollowLeader():
                return Steering(part.points, self.parameters, part.task.distance)
            case _:
                return Steering(part.points, self.parameters)

    def rest(self) -> None:
        """Stop driving; moving limbs return to rest."""
        self._began = False
        self._seen.clear()
        self._open.clear()

    def drive(self, t: float, pose: Pose, v: float, in_contact: bool, leader: LeaderView | None = None) -> None:
        """Look at `t` (s) at the chair's pose, speed (m/s), contact and leader; begin a stroke when one is due."""
        if self.steering is None:
            return
        if not self._began:
            self._began = True
            self._rested = t - self._driven
            self.steering.begin()
            self._free_at = self._look_at = t + self.parameters.reaction_time + self.strokes.pause()
        seen = self._seen
        seen.append((t, pose, v, in_contact, leader))
        while len(seen) > 1 and seen[1][0] <= t - self.parameters.reaction_time:
            seen.popleft()
        self._driven = t - self._rested
        self._look_at_stage(*seen[0][:3])
        if t >= self._look_at:
            self._look_at = t + LOOK_PERIOD
            self._look(t, *seen[0])

    def _look(self, t: float, seen_t: float, pose: Pose, v: float, in_contact: bool, leader: LeaderView | None) -> None:
        self._learn_from_outcomes(seen_t, pose, v, in_contact)
        if t < self._free_at or self.strokes.is_moving(t) or self.steering is None:
            return
        late = t - seen_t
        now = Pose(
            pose.x + v * late * math.cos(pose.theta),
            pose.y + v * late * math.sin(pose.theta),
            pose.theta,
        )
        intention = self.steering.want(t, now, v, in_contact, self.strokes.practice, leader)
        if intention is None:
            return
        limb = LIMB_OF[intention.wish]
        if self._awaits_outcome(limb) or not self.strokes.can_move(limb, t):
            return
        size = self.estimates[limb].size_for(intention.effect)
        self._begin_stroke(t, limb, size, pose, v)

    def _look_at_stage(self, seen_t: float, pose: Pose, v: float) -> None:
        """Begin the next stage of a course when the stage before is seen to be finished."""
        if self._course is None:
            return
        before = self._course.stage
        self._course.update(pose, v, seen_t - self._rested)
        if self._course.stage != before:
            self.steering = self._aim(self._course.part)
            self.steering.begin()

    def _begin_stroke(self, t: float, limb: str, size: float, pose: Pose, v: float) -> None:
        performed = self.strokes.make(t, limb, size)
        before = v if performed.limb in OTHER_ELBOW else pose.theta
        self._open.append(Stroke(performed.limb, performed.size, t + performed.rise, before))
        self._free_at = performed.free_at

    def _awaits_outcome(self, limb: str) -> bool:
        """Return whether the outcome of a stroke for this limb's control is not yet seen."""
        return any((stroke.limb in OTHER_ELBOW) == (limb in OTHER_ELBOW) for stroke in self._open)

    def _learn_from_outcomes(self, seen_t: float, pose: Pose, v: float, in_contact: bool) -> None:
        """Compare the seen effects of finished strokes with the expected effects, and correct the estimates."""
        open_strokes = []
        for stroke in self._open:
            elbow = stroke.limb in OTHER_ELBOW
            stroke.spoilt = stroke.spoilt or (elbow and in_contact)
            if seen_t < stroke.end + SETTLING:
                open_strokes.append(stroke)
                continue
            change = v - stroke.before if elbow else wrap_angle(pose.theta - stroke.before)
            effect = change if WISH_OF[stroke.limb] in ("faster", "left") else -change
            at_limit = elbow and not SLOWEST < v < FASTEST
            if self.parameters.learns and not stroke.spoilt and not at_limit:
                self.estimates[stroke.limb].learn(stroke.size, effect, self.parameters.correction)
        self._open = open_strokes
