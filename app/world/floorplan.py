"""The floor plan: a building storey with its walls, obstacles, rooms and prescribed paths, as a document."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path as FilePath
from typing import Annotated, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import FailFast, Field, ValidationError, ValidationInfo, model_validator

from app.geometry import Pose, wrap_angle
from app.quantities import Document, Length, Line, Name, Radians, Seconds, Title
from app.sentences import one_sentence
from app.settings import data_folder
from app.texts import Figure, Text, Value
from app.world.clearance import Clearance
from app.world.footprint import CHAIR_RADIUS
from app.world.movers import Mover
from app.world.obstacles import Box, Cylinder, Obstacle, Point
from app.world.path import Path
from app.world.scenery import Cone, Gap, Ground, Lights
from app.world.tasks import GOAL_RADIUS, Back, Course, FollowLeader, FollowPath, Task, Turn

MAX_WALLS = 5000  # pieces of all walls: each is drawn, and compared with each movement of the chair
MAX_LINE_POINTS = 2000  # points of all paths and movers: each piece of them is compared with every wall
LINES_ARE_FREE = {"lines": "free"}  # context of the validation of a plan whose lines were found free before
MAX_BYTES = 8_000_000  # a document larger than this is not a floor plan

# FailFast reports the first error only: collecting a million errors would block the process for seconds.
Polyline = Annotated[tuple[Point, ...], Field(min_length=2, max_length=MAX_WALLS), FailFast()]


class ClearanceError(ValueError):
    """A path or a mover's line is too near to a wall or an obstacle, at (x, y) in m."""

    def __init__(self, sentence: Text, x: float, y: float) -> None:
        super().__init__(sentence)
        self.x, self.y = x, y


class Room(Document):
    """A room's label and its position on the plan."""

    label: Title
    position: Point


class Door(Document):
    """A door frame, drawn in the gap between two walls: its middle, its clear width, and the way through it."""

    position: Point
    width: Length = 1.0
    heading: Radians = 0.0  # of the way through


class PrescribedPath(Document):
    """A path on the floor and the task along it."""

    name: Name
    title: Title
    points: Polyline
    goal_radius: Length = GOAL_RADIUS  # m around the last point
    time_limit: Seconds = 180.0
    instruction: Annotated[Line, Field(min_length=1, max_length=200)]
    start_heading: Radians | None = None  # along the path when not given
    task: Task = FollowPath()

    @property
    def line(self) -> Path:
        """Return the path's geometry."""
        return Path(self.points)

    @property
    def start(self) -> Pose:
        """Return the chair's pose at the start of a trial; for a path driven backwards, its heading is reversed."""
        heading = self.line.heading_at(0.0) if self.start_heading is None else self.start_heading
        if self.start_heading is None and isinstance(self.task, Back):
            heading = wrap_angle(heading + math.pi)
        return Pose(self.points[0][0], self.points[0][1], heading)


class FloorPlan(Document):
    """One storey of a building. Doorways are gaps between walls; the chair collides with walls as thick as drawn."""

    name: Name
    title: Title
    walls: Annotated[tuple[Polyline, ...], Field(max_length=MAX_WALLS), FailFast()]
    obstacles: Annotated[tuple[Obstacle, ...], Field(max_length=1000)] = ()
    rooms: Annotated[tuple[Room, ...], Field(max_length=200)] = ()
    doors: Annotated[tuple[Door, ...], Field(max_length=200)] = ()
    paths: Annotated[tuple[PrescribedPath, ...], Field(min_length=1, max_length=20)]
    wall_height: Length = 2.6
    wall_thickness: Annotated[Length, Field(le=1.0)] = 0.1
    ground: Ground = Ground()
    cones: Annotated[tuple[Cone, ...], Field(max_length=200)] = ()
    gaps: Annotated[tuple[Gap, ...], Field(max_length=50)] = ()
    movers: Annotated[tuple[Mover, ...], Field(max_length=10)] = ()
    lights: Lights = Lights()

    @model_validator(mode="after")
    def _path_names_are_unique(self) -> Self:
        names = [path.name for path in self.paths]
        for name in names:
            if names.count(name) > 1:
                raise ValueError(Text("plan-path-twice", path=name))
        return self

    @model_validator(mode="after")
    def _is_small_enough(self) -> Self:
        pieces = sum(len(wall) - 1 for wall in self.walls)
        if pieces > MAX_WALLS:
            raise ValueError(Text("plan-walls-too-many", count=pieces, most=MAX_WALLS))
        points = sum(len(line) for _, line, _ in self._lines())
        if points > MAX_LINE_POINTS:
            raise ValueError(Text("plan-points-too-many", count=points, most=MAX_LINE_POINTS))
        return self

    @model_validator(mode="after")
    def _movers_are_known(self) -> Self:
        names = [mover.name for mover in self.movers]
        for name in names:
            if names.count(name) > 1:
                raise ValueError(Text("plan-mover-twice", mover=name))
        for path in self.paths:
            if isinstance(path.task, FollowLeader) and path.task.leader not in names:
                unknown = {"path": path.name, "leader": path.task.leader}
                if not names:
                    raise ValueError(Text("plan-leader-without-movers", **unknown))
                raise ValueError(Text("plan-leader-unknown", **unknown, names=", ".join(names)))
        return self

    @model_validator(mode="after")
    def _lines_are_free(self, info: ValidationInfo) -> Self:
        if info.context == LINES_ARE_FREE:
            return self
        # A cone does not stop the chair, but no path may lead over one.
        cones = [
            Cylinder(kind="cylinder", label="cone", position=cone.position, radius=cone.radius) for cone in self.cones
        ]
        things = [*self.obstacles, *cones]
        clearance = Clearance(self.walls, self.wall_thickness, things)
        for description, points, radius in self._lines():
            try:
                line = Path(points).points if len(points) > 1 else (points[0], points[0])
            except ValueError as error:
                raise ValueError(Text("plan-line-problem", line=description, problem=error)) from error
            narrowest = clearance.along(line)
            if narrowest.distance < radius:
                place: dict[str, Value] = {
                    "line": description,
                    "distance": Figure(max(narrowest.distance, 0.0), 2),
                    "x": Figure(narrowest.x, 2),
                    "y": Figure(narrowest.y, 2),
                    "radius": radius,
                }
                if narrowest.obstacle is None:
                    sentence = Text("plan-near-wall", **place)
                elif narrowest.obstacle in cones:
                    sentence = Text("plan-near-cone", **place, number=cones.index(narrowest.obstacle) + 1)
                else:
                    sentence = Text("plan-near-obstacle", **place, label=narrowest.obstacle.label)
                raise ClearanceError(sentence, narrowest.x, narrowest.y)
        return self

    def _lines(self) -> Iterator[tuple[Text, Sequence[Point], float]]:
        """Yield the lines that must keep clear of walls and obstacles: description, points, and the room needed (m)."""
        for path in self.paths:
            if isinstance(path.task, Course):
                for stage in path.task.stages:
                    turns = isinstance(stage.task, Turn)
                    description = Text("plan-line-stage", path=path.name, stage=stage.title)
                    yield description, stage.points[: 1 if turns else None], CHAIR_RADIUS
            else:
                turns = isinstance(path.task, Turn)
                yield Text("plan-line-path", path=path.name), path.points[: 1 if turns else None], CHAIR_RADIUS
        for mover in self.movers:
            yield Text("plan-line-mover", mover=mover.name), mover.points, mover.radius

    def segments(self) -> NDArray[np.float64]:
        """Return the edges of walls (their middle lines) and boxes, (n, 4): x1, y1, x2, y2 in m."""
        edges = [(*a, *b) for wall in self.walls for a, b in pairwise(wall)]
        for obstacle in self.obstacles:
            if isinstance(obstacle, Box):
                corners = obstacle.corners()
                edges += [(*a, *b) for a, b in pairwise([*corners, corners[0]])]
        return np.array(edges, dtype=np.float64).reshape(-1, 4)

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """Return the bounding box of the plan: x_min, y_min, x_max, y_max in m."""
        points = [point for wall in self.walls for point in wall]
        points += [point for path in self.paths for point in path.points]
        for obstacle in self.obstacles:
            if isinstance(obstacle, Cylinder):
                (x, y), r = obstacle.position, obstacle.radius
                points += [(x - r, y - r), (x + r, y + r)]
            else:
                points += obstacle.corners()
        points += [cone.position for cone in self.cones] + [point for mover in self.movers for point in mover.points]
        if self.ground.area is not None:
            x_min, y_min, x_max, y_max = self.ground.area
            points += [(x_min, y_min), (x_max, y_max)]
        corners = np.array(points)
        low, high = corners.min(axis=0), corners.max(axis=0)
        return float(low[0]), float(low[1]), float(high[0]), float(high[1])

    def mover_named(self, name: str) -> Mover:
        """Return the mover of this name, which must exist."""
        return next(mover for mover in self.movers if mover.name == name)

    def path_named(self, name: str) -> PrescribedPath:
        """Return the path of this name.

        Raises
        ------
        ValueError
            When no path has this name.
        """
        for path in self.paths:
            if path.name == name:
                return path
        names = ", ".join(path.name for path in self.paths)
        raise ValueError(Text("plan-path-unknown", plan=self.name, path=name, names=names))


def load_floorplan(file: FilePath) -> FloorPlan:
    """Read a floor plan from a JSON file.

    Raises
    ------
    ValueError
        One sentence that names the file, the place in it, and what to do.
    """
    try:
        if file.stat().st_size > MAX_BYTES:
            raise ValueError(Text("plan-file-large", file=str(file), most=MAX_BYTES // 1_000_000))
        content = file.read_bytes()
    except FileNotFoundError as error:
        raise ValueError(Text("plan-file-missing", file=str(file))) from error
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(Text("plan-file-unreadable", file=str(file), reason=reason)) from error
    try:
        return FloorPlan.model_validate_json(content)
    except ValidationError as error:
        raise ValueError(one_sentence(error, str(file))) from error


def bundled_floorplans() -> dict[str, FilePath]:
    """Return the files of the floor plans that come with the software, by name, in alphabetical order."""
    return {file.stem: file for file in sorted((data_folder() / "floorplans").glob("*.json"))}
