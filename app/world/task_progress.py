"""How far somebody has come with a task: one judgement for live picture, score, study and simulated person."""

import math
from typing import Protocol

from app.geometry import Pose, wrap_angle
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.progress import Progress
from app.world.scenery import Track
from app.world.tasks import Back, Course, FollowLeader, Turn

STANDS = 0.05  # m/s: slower is standing
BACKWARDS = math.radians(60)  # a chair that backs looks against its way, give or take this
Place = tuple[float, float]


class TaskProgress(Protocol):
    """Where somebody stands in a task; made by `progress_of`, told of every tick in order."""

    @property
    def s(self) -> float:
        """How far: m along the path, or rad turned."""
        ...

    @property
    def length(self) -> float:
        """How far it goes: m, or rad for a turn."""
        ...

    @property
    def cross_track(self) -> float:
        """Distance to the path, m, left positive; for a turn, distance to the spot."""
        ...

    @property
    def reached(self) -> bool:
        """Whether the task is done."""
        ...

    @property
    def covered(self) -> float:
        """Share that was gone through, 0..1."""
        ...

    @property
    def stage(self) -> int:
        """The present stage, from 0."""
        ...

    @property
    def stages(self) -> int:
        """How many there are."""
        ...

    @property
    def part(self) -> PrescribedPath:
        """What the present stage asks, as a path of its own."""
        ...

    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Take note of the chair's pose and speed (m/s) at the scene's time (s)."""
        ...


def progress_of(plan: FloorPlan, path: PrescribedPath) -> TaskProgress:
    """Return the progress along one of the plan's paths, at its beginning."""
    match path.task:
        case Turn():
            return TurnProgress(path, path.task)
        case Back():
            return BackProgress(path)
        case FollowLeader():
            return FollowProgress(plan, path, path.task)
        case Course():
            return CourseProgress(plan, path, path.task)
        case _:
            return PathProgress(path)


def leader_of(plan: FloorPlan, path: PrescribedPath) -> Track | None:
    """Return whom the path's task says to follow, None when it does not."""
    return Track(plan.mover_named(path.task.leader)) if isinstance(path.task, FollowLeader) else None


class PathProgress:
    """A path that is driven forwards to its end."""

    stage, stages = 0, 1

    def __init__(self, path: PrescribedPath) -> None:
        self.part = path
        self._along = Progress(path.line, path.goal_radius)

    @property
    def s(self) -> float:
        """M along the path."""
        return self._along.s

    @property
    def length(self) -> float:
        """M."""
        return self._along.path.length

    @property
    def cross_track(self) -> float:
        """M, left positive."""
        return self._along.cross_track

    @property
    def reached(self) -> bool:
        """Whether the end was reached after most of the path."""
        return self._along.reached

    @property
    def covered(self) -> float:
        """Share of the path that the chair has been beside."""
        return self._along.covered

    def update(self, pose: Pose, v: float, scene_t: float) -> None:  # noqa: ARG002
        """Take note of where the chair is; how fast and when does not matter."""
        self._along.update(pose.x, pose.y)


class BackProgress(PathProgress):
    """A path that is driven backwards: at its end the chair still looks against it."""

    def __init__(self, path: PrescribedPath) -> None:
        super().__init__(path)
        self._reached = False

    @property
    def reached(self) -> bool:
        """Whether the end was reached backwards."""
        return self._reached

    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Take note of where the chair is and where it looks."""
        super().update(pose, v, scene_t)
        line = self._along.path
        against = wrap_angle(line.heading_at(line.length) + math.pi - pose.theta)
        goal_x, goal_y = line.points[-1]
        near = math.hypot(pose.x - goal_x, pose.y - goal_y) <= self.part.goal_radius
        self._reached = self._reached or (self._along.covered_most and near and abs(against) <= BACKWARDS)


class FollowProgress(PathProgress):
    """A leader who is followed: done when he stands at his end and the chair is behind him."""

    def __init__(self, plan: FloorPlan, path: PrescribedPath, task: FollowLeader) -> None:
        super().__init__(path)
        self._track = Track(plan.mover_named(task.leader))
        self._near = task.distance + path.goal_radius
        self._reached = False

    @property
    def reached(self) -> bool:
        """Whether both have come to the end."""
        return self._reached

    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Take note of where the chair and the leader are."""
        super().update(pose, v, scene_t)
        leader = self._track.at(scene_t)
        near = math.hypot(pose.x - leader.pose.x, pose.y - leader.pose.y) <= self._near
        arrived = self._track.mover.way(scene_t)[0] >= self._track.length
        self._reached = self._reached or (arrived and near and self._along.covered_most)


class TurnProgress:
    """A turn on the spot, done when the chair has stood for a moment looking at the mark."""

    stage, stages = 0, 1

    def __init__(self, path: PrescribedPath, task: Turn) -> None:
        self.part = path
        self.s = 0.0
        self.cross_track = 0.0
        self.reached = False
        self._task = task
        self._spot = path.points[0]
        self._target = path.line.heading_at(0.0)
        self._sign = 1.0 if task.direction == "left" else -1.0
        self.length = (self._sign * (self._target - path.start.theta)) % math.tau or math.tau
        self._theta = path.start.theta
        self._since: float | None = None  # the scene's time from which on it stood right

    @property
    def covered(self) -> float:
        """Share of the turn."""
        return min(1.0, max(0.0, self.s / self.length))

    @property
    def heading_error(self) -> float:
        """How far (rad) beside the mark the chair looks, left positive."""
        return wrap_angle(self._theta - self._target)

    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Take note of where the chair looks."""
        self.s += self._sign * wrap_angle(pose.theta - self._theta)
        self._theta = pose.theta
        self.cross_track = math.hypot(pose.x - self._spot[0], pose.y - self._spot[1])
        task = self._task
        # Who turned the other way round looks at the mark too, but a whole turn short of it.
        right = self.s >= self.length - task.tolerance and abs(self.heading_error) <= task.tolerance
        if not (right and abs(v) < STANDS and self.cross_track <= self.part.goal_radius):
            self._since = None
        elif self._since is None:
            self._since = scene_t
        self.reached = self.reached or (self._since is not None and scene_t - self._since >= task.hold)


class CourseProgress:
    """Stages, one after the other."""

    def __init__(self, plan: FloorPlan, path: PrescribedPath, task: Course) -> None:
        self.parts = parts_of(path, task)
        self._parts = [progress_of(plan, part) for part in self.parts]
        self.stages = len(self._parts)
        self.stage = 0

    @property
    def _now(self) -> TaskProgress:
        return self._parts[self.stage]

    @property
    def part(self) -> PrescribedPath:
        """What the present stage asks."""
        return self._now.part

    @property
    def s(self) -> float:
        """How far in the present stage."""
        return self._now.s

    @property
    def length(self) -> float:
        """How far the present stage goes."""
        return self._now.length

    @property
    def cross_track(self) -> float:
        """Of the present stage."""
        return self._now.cross_track

    @property
    def reached(self) -> bool:
        """Whether the last stage is done."""
        return self.stage == self.stages - 1 and self._now.reached

    @property
    def covered(self) -> float:
        """Share of all stages."""
        return (self.stage + self._now.covered) / self.stages

    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Take note of the chair; a stage that is done is followed by the next."""
        self._now.update(pose, v, scene_t)
        if self._now.reached and self.stage < self.stages - 1:
            self.stage += 1


def parts_of(path: PrescribedPath, task: Course) -> list[PrescribedPath]:
    """Return the stages of a course as paths of their own; each begins as the one before it ended."""
    parts: list[PrescribedPath] = []
    heading = path.start.theta
    for number, stage in enumerate(task.stages):
        part = PrescribedPath(
            name=f"{path.name}.{number + 1}",
            title=stage.title,
            points=stage.points,
            goal_radius=stage.goal_radius,
            time_limit=path.time_limit,
            instruction=stage.instruction,
            start_heading=wrap_angle(heading),
            task=stage.task,
        )
        parts.append(part)
        line = part.line
        end = line.heading_at(line.length)
        heading = end + math.pi if isinstance(stage.task, Back) else end
    return parts
