"""The scenery of a place besides walls and obstacles: ground, cones, gaps and lights."""

import math
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from app.quantities import Document, Fraction, Length, Metres, Radians, Title
from app.texts import Text
from app.world.obstacles import Point

Colour = tuple[
    Annotated[int, Field(strict=True, ge=0, le=255)],
    Annotated[int, Field(strict=True, ge=0, le=255)],
    Annotated[int, Field(strict=True, ge=0, le=255)],
]


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
                raise ValueError(Text("plan-dunes-without-area"))
            return self
        x_min, y_min, x_max, y_max = self.area
        if not (x_min < x_max and y_min < y_max):
            raise ValueError(Text("plan-area-order"))
        for number, dune in enumerate(self.dunes, start=1):
            (x, y), r = dune.position, dune.radius
            nearest = math.hypot(x - min(max(x, x_min), x_max), y - min(max(y, y_min), y_max))
            if nearest < r:
                raise ValueError(Text("plan-dune-inside", number=number))
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
