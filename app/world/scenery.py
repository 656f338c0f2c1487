"""The scenery of a place besides walls and obstacles: ground, cones, gaps, moving things and lights."""

import math
from bisect import bisect_right
from itertools import pairwise
from typing import Annotated, Literal, NamedTuple, Self

from pydantic import Field, model_validator

from app.geometry import Pose
from app.quantities import Document, Fraction, Length, Metres, Name, Radians, Seconds, Title
from app.world.obstacles import Point
from app.world.path import Path

Colour = tuple[
    Annotated[int, Field(strict=True, ge=0, le=255)],
    Annotated[int, Field(strict=True, ge=0, le=255)],
    Annotated[int, Field(strict=True, ge=0, le=255)],
]
Pace = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=3)]  # m/s


class Dune(Document):
    """A hill of sand, for the view only: it lies outside the ground that the chair drives on."""

    position: Point  # of its middle
    radius: Length  # m
    height: Length = 2.0


class Ground(Document):
    """The ground; without an area, it is as large as the plan's content."""

    kind: Literal["hall", "sand", "grass", "asphalt"] = "hall"
    area: tuple[Metres, Metres, Metres, Metres] | None = None  # x_min, y_min, x_max, y_max
    dunes: Annotated[tuple[Dune, ...], Field(max_length=100)] = ()

    @model_validator(mode="after")
    def _is_an_area(self) -> Self:
        if self.area is None:
            if self.dunes:
                raise ValueError("dunes lie around an area: give the ground its area")
            return self
        x_min, y_min, x_max, y_max = self.area
        if not (x_min < x_max and y_min < y_max):
            raise ValueError("area is x_min, y_min, x_max, y_max, the smaller ones first: correct it")
        for number, dune in enumerate(self.dunes, start=1):
            (x, y), r = dune.position, dune.radius
            nearest = math.hypot(x - min(max(x, x_min), x_max), y - min(max(y, y_min), y_max))
            if nearest < r:
                raise ValueError(f"dune {number} reaches into the area that is driven on: move it out")
        return self


class Cone(Document):
    """A soft cone: touching it is counted, but it does not stop the chair."""

    position: Point
    radius: Annotated[Length, Field(le=0.5)] = 0.15
    height: Annotated[Length, Field(le=2)] = 0.5


class Gap(Document):
    """A narrow place whose clearance is measured: its middle, its clear width, and the way through it."""

    label: Title
    position: Point
    width: Length
    heading: Radians = 0.0  # of the way through


class Lights(Document):
    """The direction and brightness of the sun, and the brightness of the sky."""

    azimuth: Radians = -2.1112  # rad, of the sun, from x counter-clockwise
    elevation: Annotated[Radians, Field(ge=0, le=1.5708)] = 1.0002  # rad above the ground
    sun: Fraction = 0.7  # of full brightness
    sky: Fraction = 0.8
    colour: Colour = (255, 250, 240)  # of the sun


class MoverState(NamedTuple):
    """The pose and speed of a moving thing."""

    pose: Pose
    v: float  # m/s


class Mover(Document):
    """A person, a chair or a ball that moves along a line, independently of the driver.

    Its position depends only on the scene's time (`Tick.scene_t`), which stands still while the chair is not armed.
    """

    name: Name
    kind: Literal["person", "chair", "ball"]
    points: Annotated[tuple[Point, ...], Field(min_length=2, max_length=1000)]
    pace: Annotated[tuple[tuple[Seconds, Pace], ...], Field(min_length=1, max_length=100)]
    """Pairs of a time (s) and the speed (m/s) from then on; the first time is 0."""
    radius: Annotated[Length, Field(le=1)] = 0.3
    returns: bool = False  # moves to and fro; otherwise it stops at the line's end

    @model_validator(mode="after")
    def _is_in_order(self) -> Self:
        times = [t for t, _ in self.pace]
        if times[0] != 0.0 or any(later <= earlier for earlier, later in pairwise(times)):
            raise ValueError(f"mover '{self.name}': the times of its pace begin with 0 and grow: correct them")
        try:
            _ = self.line
        except ValueError as error:
            raise ValueError(f"mover '{self.name}': {error}") from error
        return self

    @property
    def line(self) -> Path:
        """Return the line's geometry."""
        return Path(self.points)

    def way(self, t: float) -> tuple[float, float]:
        """Return the way (m) it has gone at `t` (s), and its speed (m/s)."""
        last = max(0, bisect_right([start for start, _ in self.pace], t) - 1)
        gone = sum(v * (self.pace[i + 1][0] - start) for i, (start, v) in enumerate(self.pace[:last]))
        start, v = self.pace[last]
        return gone + v * max(0.0, t - start), v


class Track:
    """The motion of a mover over time; its line's geometry is computed once."""

    __slots__ = ("_line", "mover")

    def __init__(self, mover: Mover) -> None:
        self.mover = mover
        self._line = mover.line

    @property
    def length(self) -> float:
        """Return the length of the line, m."""
        return self._line.length

    def at(self, t: float) -> MoverState:
        """Return the mover's pose and speed at the scene's time `t` (s)."""
        gone, v = self.mover.way(t)
        length = self._line.length
        if not self.mover.returns:
            s, turned = min(gone, length), False
            v = v if gone < length else 0.0
        else:
            turned = gone % (2 * length) > length
            s = 2 * length - gone % (2 * length) if turned else gone % (2 * length)
        heading = self._line.heading_at(s)
        if turned:
            heading = math.remainder(heading + math.pi, math.tau)
        return MoverState(Pose(*self._line.point_at(s), heading), v)
