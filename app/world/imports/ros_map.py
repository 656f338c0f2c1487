"""Reads occupancy maps of the ROS map_server: a YAML document and the image that it names."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import yaml
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from app.quantities import Fraction, Metres
from app.sentences import one_sentence

MOST_CELLS = 40_000_000
FORMATS = ("PPM", "PNG", "BMP", "JPEG")  # other formats can hold several pictures or need a further library
Resolution = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.005, le=1.0)]  # m per cell
Yaw = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-6.2832, le=6.2832)]  # rad


class MapDocument(BaseModel):
    """The YAML document of a map; fields of other programs are ignored."""

    model_config = ConfigDict(extra="ignore", frozen=True)

    image: Annotated[str, Field(min_length=1)]
    resolution: Resolution
    origin: tuple[Metres, Metres, Yaw]  # of the image's lower left corner
    negate: Literal[0, 1] = 0
    occupied_thresh: Fraction = 0.65
    free_thresh: Fraction = 0.196


@dataclass(frozen=True, slots=True)
class OccupancyMap:
    """A grid of free cells; cell [0, 0] is at the lower left, rows grow with y and columns with x."""

    free: NDArray[np.bool_]  # (rows, columns); False for occupied and for unknown cells
    resolution: float  # m per cell
    origin: tuple[float, float, float]  # x (m), y (m), yaw (rad) of the lower left corner

    def place(self, cells: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the coordinates (n, 2) in m of `cells` (n, 2): (column, row) from the lower left corner."""
        x, y, yaw = self.origin
        cos, sin = np.cos(yaw), np.sin(yaw)
        turn = np.array([[cos, -sin], [sin, cos]])
        return np.asarray(cells * self.resolution @ turn.T + (x, y))


def read_occupancy_map(file: Path, image_file: Path | None = None) -> OccupancyMap:
    """Read a map's YAML file and the image that it names, or `image_file` instead of that image.

    A pixel is free when its occupancy, (255 - value) / 255 or with `negate` value / 255, is below `free_thresh`.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    document = _read_document(file)
    image_file = image_file or file.parent / document.image
    pixels = _read_image(image_file, file)
    occupancy = (pixels if document.negate else 255.0 - pixels) / 255.0
    free = np.flipud(occupancy < document.free_thresh)
    if not free.any():
        raise ValueError(f"{image_file}: no pixel is free, check negate and free_thresh in {file.name}")
    return OccupancyMap(np.ascontiguousarray(free), document.resolution, document.origin)


def _read_document(file: Path) -> MapDocument:
    try:
        text = file.read_text(encoding="utf-8")
        # A few nested aliases expand to billions of values; no map needs an alias.
        if any(isinstance(event, yaml.AliasEvent) for event in yaml.parse(text, Loader=yaml.SafeLoader)):
            raise ValueError(f"{file}: a map's document has no aliases (*name), write the values themselves")
        content = yaml.safe_load(text)
    except FileNotFoundError as error:
        raise ValueError(f"{file}: there is no such file, check its name") from error
    except OSError as error:
        raise ValueError(f"{file}: this file cannot be read ({error.strerror or error}), check it") from error
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        if str(error).startswith(f"{file}: "):
            raise
        raise ValueError(f"{file}: this is not a YAML document, name the .yaml file of a map_server map") from error
    if not isinstance(content, dict):
        raise ValueError(f"{file}: this is not a map's document (image, resolution, origin), name another file")
    try:
        return MapDocument.model_validate(content)
    except ValidationError as error:
        raise ValueError(one_sentence(error, str(file))) from error


def _read_image(image_file: Path, named_in: Path) -> NDArray[np.float32]:
    """Return the grey values (rows, columns), 0..255."""
    try:
        with Image.open(image_file, formats=FORMATS) as image:
            too_large = image.width * image.height > MOST_CELLS
            grey = None if too_large else np.asarray(image.convert("L"), dtype=np.float32)
    except FileNotFoundError as error:
        raise ValueError(f"{image_file}: there is no such image, put it where {named_in.name} names it") from error
    except (UnidentifiedImageError, Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        raise ValueError(f"{image_file}: this is not an image (PGM or PNG) that can be read, save it anew") from error
    except (OSError, SyntaxError, ValueError) as error:
        what = getattr(error, "strerror", None) or error
        raise ValueError(f"{image_file}: this image cannot be read ({what}), save it anew") from error
    if grey is None:
        raise ValueError(f"{image_file}: this image has more than {MOST_CELLS:,} pixels, make it coarser")
    return grey
