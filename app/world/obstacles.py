"""Obstacles in a floor plan: boxes and cylinders, each with position, size and label."""

import math
from typing import Annotated, Literal

from pydantic import Field

from app.quantities import Document, Length, Metres, Name, Radians, Title

Point = tuple[Metres, Metres]


class Box(Document):
    """A box, such as a table, a bed or a cupboard: `size` along its two sides, rotated by `angle`."""

    kind: Literal["box"]
    label: Title
    position: Point  # of its middle
    size: tuple[Length, Length]  # m
    height: Length = 0.75
    angle: Radians = 0.0
    model: Name | None = None  # name of a 3D object, drawn in the box's size instead of the furniture of the label

    def corners(self) -> list[tuple[float, float]]:
        """Return the four corners, counter-clockwise."""
        cos, sin = math.cos(self.angle), math.sin(self.angle)
        half_x, half_y = self.size[0] / 2, self.size[1] / 2
        return [
            (self.position[0] + a * cos - b * sin, self.position[1] + a * sin + b * cos)
            for a, b in ((-half_x, -half_y), (half_x, -half_y), (half_x, half_y), (-half_x, half_y))
        ]

    def covers(self, x: float, y: float) -> bool:
        """Return whether the point (x, y) is inside the box."""
        cos, sin = math.cos(self.angle), math.sin(self.angle)
        away_x, away_y = x - self.position[0], y - self.position[1]
        along, across = away_x * cos + away_y * sin, away_y * cos - away_x * sin
        return abs(along) < self.size[0] / 2 and abs(across) < self.size[1] / 2


class Cylinder(Document):
    """A cylinder, such as a plant, a column or a round table."""

    kind: Literal["cylinder"]
    label: Title
    position: Point  # of its middle
    radius: Length  # m
    height: Length = 0.75


Obstacle = Annotated[Box | Cylinder, Field(discriminator="kind")]
