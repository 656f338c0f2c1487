"""What stands in the rooms: boxes and cylinders, each with its place, size and word."""

import math
from typing import Annotated, Literal

from pydantic import Field

from app.quantities import Document, Length, Metres, Name, Radians, Title

Point = tuple[Metres, Metres]


class Box(Document):
    """A table, a bed, a cupboard: `size` along its own two sides, turned by `angle`."""

    kind: Literal["box"]
    label: Title
    position: Point  # its middle
    size: tuple[Length, Length]  # m
    height: Length = 0.75
    angle: Radians = 0.0
    model: Name | None = None  # a 3D object, drawn in the box's size instead of what its label says

    def corners(self) -> list[tuple[float, float]]:
        """Return the four corners, counter-clockwise."""
        cos, sin = math.cos(self.angle), math.sin(self.angle)
        half_x, half_y = self.size[0] / 2, self.size[1] / 2
        return [
            (self.position[0] + a * cos - b * sin, self.position[1] + a * sin + b * cos)
            for a, b in ((-half_x, -half_y), (half_x, -half_y), (half_x, half_y), (-half_x, half_y))
        ]

    def covers(self, x: float, y: float) -> bool:
        """Tell whether a place is inside."""
        cos, sin = math.cos(self.angle), math.sin(self.angle)
        away_x, away_y = x - self.position[0], y - self.position[1]
        along, across = away_x * cos + away_y * sin, away_y * cos - away_x * sin
        return abs(along) < self.size[0] / 2 and abs(across) < self.size[1] / 2


class Cylinder(Document):
    """A plant, a column, a round table."""

    kind: Literal["cylinder"]
    label: Title
    position: Point  # its middle
    radius: Length  # m
    height: Length = 0.75


Obstacle = Annotated[Box | Cylinder, Field(discriminator="kind")]
