"""Progress along a path and in a task, computed alike for live picture, score, study and simulated people."""

# Compiled in a wheel (hatch_build.py).

import math
from abc import ABC, abstractmethod

from app.geometry import Pose, wrap_angle
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.movers import Track
from app.world.path import Path
from app.world.tasks import Back, Course, FollowLeader, Turn

WINDOW = 2.0  # m of path, back and ahead, in which the chair is searched first
NEARER = 1.0  # m by which another part of the path must be nearer before the chair counts as being there
BIN = 0.25  # m, the resolution in which the path counts as covered
MOST = 0.5  # share of the path that must be covered before its end can be reached
STANDS = 0.05  # m/s, below which the chair counts as standing
BACKWARDS = math.radians(60)  # largest angle of a backing chair from the direction against the path


class LineProgress:
    """Progress of a chair along a line, update by update.

    A path may cross itself or end where it began: its end counts as reached only after most of it was covered.

    Attributes
    ----------
    s : float, m along the line
    cross_track : float, m, left positive
    reached : bool
    """

    __slots__ = ("_bins", "_count", "_goal_square", "cross_track", "path", "reached", "s")

    def __init__(self, path: Path, goal_radius: float) -> None:
        self.path = path
        self._goal_square = goal_radius * goal_radius
        self._bins = bytearray(max(1, math.ceil(path.length / BIN)))
        self._count = 0
        self.s = 0.0
        self.cross_track = 0.0
        self.reached = False

    @property
    def covered(self) -> float:
        """Share of the line that the chair has been beside, 0..1."""
        return self._count / len(self._bins)

    @property
    def covered_most(self) -> bool:
        """Whether enough of the line was covered for its end to count."""
        return self.covered >= MOST

    def update(self, x: float, y: float) -> None:
        """Update with the chair's position (m), which moves much less than 2 m between two updates."""
        before = self.s
        s, cross_track = self.path.project_near(x, y, before, WINDOW)
        if abs(cross_track) > NEARER:
            elsewhere, distance = self.path.project(x, y)
            if abs(distance) < abs(cross_track) - NEARER:
                s, cross_track = elsewhere, distance
        self.s, self.cross_track = s, cross_track
        self._cover(before if abs(s - before) <= WINDOW else s, s)
        if not self.reached and self.covered_most:
            goal_x, goal_y = self.path.points[-1]
            self.reached = (x - goal_x) ** 2 + (y - goal_y) ** 2 <= self._goal_square

    def _cover(self, a: float, b: float) -> None:
        last = len(self._bins) - 1
        low, high = min(int(min(a, b) / BIN), last), min(int(max(a, b) / BIN), last)
        for index in range(low, high + 1):
            if not self._bins[index]:
                self._bins[index] = 1
                self._count += 1


class TaskProgress(ABC):
    """Progress in a task; made by `progress_of`, updated with every tick in order.

    Attributes
    ----------
    part : PrescribedPath, the path of the present stage
    length : float, length of the present stage: m, or rad for a turn
    s : float, way done in the present stage: m along its path, or rad turned
    cross_track : float, distance to the path, m, left positive; for a turn, distance to the spot
    covered : float, share of the whole task that is done, 0..1
    reached : bool, whether the task is done
    stage, stages : int, the present stage from 0, and the number of stages
    """

    def __init__(self, part: PrescribedPath, length: float, stages: int = 1) -> None:
        self.part = part
        self.length = length
        self.s = self.cross_track = self.covered = 0.0
        self.reached = False
        self.stage = 0
        self.stages = stages

    @abstractmethod
    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Update with the chair's pose and speed (m/s) at the scene's time (s)."""


def progress_of(plan: FloorPlan, path: PrescribedPath) -> TaskProgress:
    """Return the progress at the start of one of the plan's paths."""
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
    """Return the track of the leader that the path's task names, None for a task without a leader."""
    return Track(plan.mover_named(path.task.leader)) if isinstance(path.task, FollowLeader) else None


class PathProgress(TaskProgress):
    """Progress on a path that is driven forwards: done at its end, after most of it was covered."""

    def __init__(self, path: PrescribedPath) -> None:
        super().__init__(path, path.line.length)
        self._line = LineProgress(path.line, path.goal_radius)

    def update(self, pose: Pose, v: float, scene_t: float) -> None:  # noqa: ARG002
        """Update with the chair's pose and the scene's time (s); the speed does not matter."""
        self._line.update(pose.x, pose.y)
        self.s, self.cross_track, self.covered = self._line.s, self._line.cross_track, self._line.covered
        self.reached = self.reached or self._is_done(pose, scene_t)

    def _is_done(self, pose: Pose, scene_t: float) -> bool:  # noqa: ARG002
        return self._line.reached


class BackProgress(PathProgress):
    """Progress on a path that is driven backwards: at its end, the chair faces against it."""

    def _is_done(self, pose: Pose, scene_t: float) -> bool:  # noqa: ARG002
        line = self._line.path
        against = wrap_angle(line.heading_at(line.length) + math.pi - pose.theta)
        goal_x, goal_y = line.points[-1]
        near = math.hypot(pose.x - goal_x, pose.y - goal_y) <= self.part.goal_radius
        return self._line.covered_most and near and abs(against) <= BACKWARDS


class FollowProgress(PathProgress):
    """Progress behind a leader: done when the leader has reached the end and the chair is near the leader."""

    def __init__(self, plan: FloorPlan, path: PrescribedPath, task: FollowLeader) -> None:
        super().__init__(path)
        self._track = Track(plan.mover_named(task.leader))
        self._near = task.distance + path.goal_radius

    def _is_done(self, pose: Pose, scene_t: float) -> bool:
        leader = self._track.at(scene_t)
        near = math.hypot(pose.x - leader.pose.x, pose.y - leader.pose.y) <= self._near
        arrived = self._track.mover.way(scene_t)[0] >= self._track.length
        return arrived and near and self._line.covered_most


class TurnProgress(TaskProgress):
    """Progress of a turn on the spot: done when the chair has stood for the task's hold time, facing the mark."""

    def __init__(self, path: PrescribedPath, task: Turn) -> None:
        self._task = task
        self._spot = path.points[0]
        self._target = path.line.heading_at(0.0)
        self._sign = 1.0 if task.direction == "left" else -1.0
        self._theta = path.start.theta
        self._since: float | None = None  # the scene's time since when the chair has stood facing the mark
        super().__init__(path, (self._sign * (self._target - self._theta)) % math.tau or math.tau)

    @property
    def heading_error(self) -> float:
        """Angle (rad) of the chair's heading from the mark, left positive."""
        return wrap_angle(self._theta - self._target)

    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Update with the chair's pose and speed (m/s) at the scene's time (s)."""
        self.s += self._sign * wrap_angle(pose.theta - self._theta)
        self.covered = min(1.0, max(0.0, self.s / self.length))
        self._theta = pose.theta
        self.cross_track = math.hypot(pose.x - self._spot[0], pose.y - self._spot[1])
        task = self._task
        # A chair that was turned the other way round also faces the mark, but its `s` is a whole turn less.
        facing = self.s >= self.length - task.tolerance and abs(self.heading_error) <= task.tolerance
        if not (facing and abs(v) < STANDS and self.cross_track <= self.part.goal_radius):
            self._since = None
        elif self._since is None:
            self._since = scene_t
        self.reached = self.reached or (self._since is not None and scene_t - self._since >= task.hold)


class CourseProgress(TaskProgress):
    """Progress in a course: its stages in sequence, done with the last one."""

    def __init__(self, plan: FloorPlan, path: PrescribedPath, task: Course) -> None:
        self.parts = parts_of(path, task)
        self._stages = [progress_of(plan, part) for part in self.parts]
        super().__init__(self.parts[0], self._stages[0].length, len(self.parts))

    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Update the present stage; when it is done, go on to the next."""
        present = self._stages[self.stage]
        present.update(pose, v, scene_t)
        if present.reached and self.stage < self.stages - 1:
            self.stage += 1
            present = self._stages[self.stage]
        self.part, self.length, self.s, self.cross_track = present.part, present.length, present.s, present.cross_track
        self.covered = (self.stage + present.covered) / self.stages
        self.reached = self.stage == self.stages - 1 and present.reached


def parts_of(path: PrescribedPath, task: Course) -> list[PrescribedPath]:
    """Return the stages of a course as paths of their own; each begins with the heading in which the last one ended."""
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
