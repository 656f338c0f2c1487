"""What moves by itself in a place (a person, a chair, a ball), and where it is at each time."""

import math
from bisect import bisect_right
from itertools import pairwise
from typing import Annotated, Literal, NamedTuple, Self

from pydantic import Field, model_validator

from app.geometry import Pose
from app.quantities import Document, Length, Name, Seconds
from app.texts import Text
from app.world.obstacles import Point
from app.world.path import Path

Pace = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=3)]  # m/s


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
            raise ValueError(Text("plan-mover-pace", mover=self.name))
        try:
            _ = self.line
        except ValueError as error:
            line = Text("plan-line-mover", mover=self.name)
            raise ValueError(Text("plan-line-problem", line=line, problem=error)) from error
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
