"""Reads occupancy maps of the ROS map_server: a YAML document and the image that it names."""

import re
from dataclasses import dataclass
from pathlib import Path, PureWindowsPath
from typing import Annotated, Final, Literal

import numpy as np
import yaml
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from app.quantities import Fraction, Metres
from app.sentences import one_sentence
from app.texts import Text, text_of

MOST_CELLS = 40_000_000
FORMATS = ("PPM", "PNG", "BMP", "JPEG")  # other formats can hold several pictures or need a further library
Resolution = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.005, le=1.0)]  # m per cell
Yaw = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=-6.2832, le=6.2832)]  # rad


# YAML 1.2, core schema (10.3.2): PyYAML reads numbers by YAML 1.1, where 5e-2 is a word and 010 is eight.
NUMBER: Final = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?|[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")
NEGATED: Final = (
    {"0": 0, "1": 1} | dict.fromkeys(("false", "no", "off", "n"), 0) | dict.fromkeys(("true", "yes", "on", "y"), 1)
)

MOST_OCCUPIED: Final = 100  # of a cell in the mode raw: 0 is free, 1 to 100 are occupied, the rest is unknown
UNKNOWN_GREY: Final = 205  # written by the map savers of ROS 1 and ROS 2 for unknown cells, whatever the thresholds
SHADES_BESIDE: Final = 10  # to each side of a grey, with which its count is compared
FREE, OCCUPIED, UNKNOWN = np.uint8(0), np.uint8(1), np.uint8(2)


def _number(value: object) -> object:
    """Return the number that a scalar of a YAML 1.2 document stands for; anything else unchanged."""
    if not isinstance(value, str) or not NUMBER.fullmatch(value):
        return value
    return float(value.replace(".inf", "inf").replace(".nan", "nan") if value[-1].isalpha() else value)


def _negated(value: object) -> object:
    return NEGATED.get(value.lower(), value) if isinstance(value, str) else value


Number = BeforeValidator(_number)


class MapDocument(BaseModel):
    """The YAML document of a map; fields of other programs are ignored."""

    model_config = ConfigDict(extra="ignore", frozen=True)

    image: Annotated[str, Field(min_length=1)]
    mode: Literal["trinary", "scale", "raw"] = "trinary"
    resolution: Annotated[Resolution, Number]
    origin: tuple[Annotated[Metres, Number], Annotated[Metres, Number], Annotated[Yaw, Number]]  # lower left corner
    negate: Annotated[Literal[0, 1], BeforeValidator(_negated)] = 0
    occupied_thresh: Annotated[Fraction, Number] = 0.65
    free_thresh: Annotated[Fraction, Number] = 0.196


@dataclass(frozen=True, slots=True)
class OccupancyMap:
    """A grid of free cells; cell [0, 0] is at the lower left, rows grow with y and columns with x."""

    free: NDArray[np.bool_]  # (rows, columns); False for occupied and for unknown cells
    resolution: float  # m per cell
    origin: tuple[float, float, float] = (0.0, 0.0, 0.0)  # x (m), y (m), yaw (rad) of the lower left corner
    unknown: int = 0  # number of cells that the map marks as unknown

    def place(self, cells: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the coordinates (n, 2) in m of `cells` (n, 2): (column, row) from the lower left corner."""
        x, y, yaw = self.origin
        cos, sin = np.cos(yaw), np.sin(yaw)
        turn = np.array([[cos, -sin], [sin, cos]])
        return np.asarray(cells * self.resolution @ turn.T + (x, y))


def read_occupancy_map(file: Path, image_file: Path | None = None) -> OccupancyMap:
    """Read a map's YAML file and the image that it names, or `image_file` instead of that image.

    The cells are those of nav2's map_server (`map_io.cpp`): in the modes trinary and scale a pixel's occupancy is
    (255 - value) / 255, or with `negate` value / 255; from `occupied_thresh` on the cell is occupied, up to
    `free_thresh` it is free. Between them it is unknown in the mode trinary and partly occupied in the mode scale. In
    the mode raw the value itself is the occupancy. A pixel that is not opaque is unknown. Unlike in nav2, the grey 205,
    which map savers write for unknown, stays unknown when `free_thresh` would make it free.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    document = _read_document(file)
    image_file = image_file or _image_beside(file, document.image)
    grey, opaque = _read_image(image_file, file)
    cells = _states(document, np.bincount(grey.ravel(), minlength=256))[grey]
    if opaque is not None:
        cells[~opaque] = UNKNOWN
    free = np.ascontiguousarray(np.flipud(cells == FREE))
    if not free.any():
        raise ValueError(Text("plan-map-nothing-free", file=str(image_file), document=file.name))
    return OccupancyMap(free, document.resolution, document.origin, int(np.count_nonzero(cells == UNKNOWN)))


def _states(document: MapDocument, counts: NDArray[np.intp]) -> NDArray[np.uint8]:
    """Return the state of a cell for each grey value, (256,); `counts` (256,) are the picture's pixels of each."""
    grey = np.arange(256)
    states = np.full(256, UNKNOWN)
    if document.mode == "raw":
        states[: MOST_OCCUPIED + 1] = OCCUPIED
        states[0] = FREE
        return states
    occupancy = (grey if document.negate else 255 - grey) / 255.0
    if document.mode == "scale":
        states[:] = OCCUPIED
    states[occupancy <= document.free_thresh] = FREE
    states[occupancy >= document.occupied_thresh] = OCCUPIED
    if document.mode == "trinary" and not document.negate and _stands_out(counts, UNKNOWN_GREY):
        states[UNKNOWN_GREY] = UNKNOWN
    return states


def _stands_out(counts: NDArray[np.intp], grey: int) -> bool:
    """Return whether a grey is more frequent than its neighbours together: in a map of probabilities it is not."""
    near = int(counts[grey - SHADES_BESIDE : grey + SHADES_BESIDE + 1].sum())
    return 2 * int(counts[grey]) > near


def _image_beside(file: Path, named: str) -> Path:
    """Return the image that a map names; when there is no such file, one of the same name beside the map.

    Map savers write the image's whole path on the robot, which is wrong once the two files are copied.
    """
    image_file = file.parent / named
    beside = file.parent / PureWindowsPath(named).name  # which takes / and \\ as separators
    try:
        return beside if not image_file.exists() and beside.is_file() else image_file
    except OSError:  # no file can have such a name; the read that follows refuses it
        return image_file


def _read_document(file: Path) -> MapDocument:
    try:
        text = file.read_text(encoding="utf-8")
        # A few nested aliases expand to billions of values; no map needs an alias.
        if any(isinstance(event, yaml.AliasEvent) for event in yaml.parse(text, Loader=yaml.BaseLoader)):
            raise ValueError(Text("plan-map-alias", file=str(file)))
        content = yaml.load(text, Loader=yaml.BaseLoader)  # noqa: S506  (reads nothing but text, lists and mappings)
    except FileNotFoundError as error:
        raise ValueError(Text("plan-file-missing", file=str(file))) from error
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(Text("plan-file-unreadable", file=str(file), reason=reason)) from error
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        if isinstance(text_of(error), Text):
            raise
        raise ValueError(Text("plan-map-no-yaml", file=str(file))) from error
    if not isinstance(content, dict):
        raise ValueError(Text("plan-map-no-document", file=str(file)))
    try:
        return MapDocument.model_validate(content)
    except ValidationError as error:
        raise ValueError(one_sentence(error, str(file))) from error


def _read_image(image_file: Path, named_in: Path) -> tuple[NDArray[np.uint8], NDArray[np.bool_] | None]:
    """Return the grey values (rows, columns), 0..255, and which pixels are opaque; None without transparency."""
    try:
        with Image.open(image_file, formats=FORMATS) as image:
            too_large = image.width * image.height > MOST_CELLS
            read = None if too_large else (_grey(image), _opaque(image))
    except FileNotFoundError as error:
        raise ValueError(Text("plan-map-image-missing", file=str(image_file), document=named_in.name)) from error
    except (UnidentifiedImageError, Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        raise ValueError(Text("plan-map-no-image", file=str(image_file))) from error
    except (OSError, SyntaxError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise ValueError(Text("plan-map-image-unreadable", file=str(image_file), reason=reason)) from error
    if read is None:
        raise ValueError(Text("plan-map-image-pixels", file=str(image_file), most=MOST_CELLS))
    return read


def _grey(image: Image.Image) -> NDArray[np.uint8]:
    if image.mode.startswith("I"):  # 16 bits of grey
        return np.asarray(np.rint(np.asarray(image) / 257.0).clip(0, 255).astype(np.uint8))
    if image.mode in {"RGBA", "LA", "PA"} or "transparency" in image.info:
        # The colour as it is stored: mixing in the background would change it.
        image = image.convert("RGBA").convert("RGB")
    return np.asarray(image.convert("L"))


def _opaque(image: Image.Image) -> NDArray[np.bool_] | None:
    if image.mode not in {"RGBA", "LA", "PA"} and "transparency" not in image.info:
        return None
    return np.asarray(np.asarray(image.convert("RGBA").getchannel("A")) == 255)
