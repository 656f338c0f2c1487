"""Which files can become a floor plan, and the options of an import: what the file does not say."""

from typing import Annotated, Final, Literal

from pydantic import Field

from app.quantities import Document, Line, Name, Title

MAPS: Final = (".yaml", ".yml")
IMAGES: Final = (".png", ".jpg", ".jpeg")
DRAWINGS: Final = (".dxf",)
SUFFIXES: Final = (*MAPS, *IMAGES, *DRAWINGS)
THRESHOLD: Final = 0.6  # share of white from which on a pixel is free

Scale = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=1000)]


class Options(Document):
    """The options of an import: information that the file does not contain."""

    unit: Literal["mm", "cm", "m", "inch", "foot"] | None = None
    layers: Annotated[tuple[Line, ...], Field(max_length=1000)] | None = None
    metres_per_pixel: Scale | None = None
    width: Scale | None = None  # m, of the whole picture
    threshold: Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, lt=1)] = THRESHOLD
    outside: bool = False  # of a map or a picture: use what can be reached from its edge as well
    title: Title | None = None
    name: Name | None = None
