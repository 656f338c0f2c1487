"""Imports a picture of a floor plan: light areas are free, dark areas become walls."""

from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageOps, UnidentifiedImageError

from app.texts import Figure, Text, text_of
from app.world.imports.distances import joined
from app.world.imports.draft import Draft
from app.world.imports.file_limits import MOST_PLAN_BYTES
from app.world.imports.map_draft import draft_of_map
from app.world.imports.options import THRESHOLD
from app.world.imports.ros_map import OccupancyMap

FORMATS: Final = ("PNG", "JPEG", "PPM")
MOST_PIXELS: Final = 40_000_000
MOST_CELLS: Final = 2_000_000
FINEST: Final = (
    0.04  # m per cell; pixels of finer pictures are grouped: a cell is a wall when any of its pixels is dark
)
COARSEST: Final = 0.2  # m per cell; in coarser cells doorways close
WIDEST: Final = 500.0  # m


def import_image(
    file: Path,
    metres_per_pixel: float | None = None,
    width: float | None = None,
    threshold: float = THRESHOLD,
    title: str | None = None,
    name: str | None = None,
    *,
    outside: bool = False,
) -> Draft:
    """Return a floor plan made of a PNG or JPEG picture, with its lower left corner at the origin.

    Either `metres_per_pixel` or `width` (m, of the picture) is given; `threshold` is the share of white from which on a
    pixel is free. `outside`: what can be reached from the picture's edge is used as well.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    if not 0.0 < threshold < 1.0:
        raise ValueError(Text("plan-picture-threshold", file=str(file)))
    if (metres_per_pixel is None) == (width is None):
        raise ValueError(Text("plan-picture-without-scale", file=str(file)))
    grey = _read(file)
    rows, columns = grey.shape
    scale = metres_per_pixel if metres_per_pixel is not None else (width or 0.0) / columns
    largest = max(rows, columns) * scale
    if not (np.isfinite(largest) and 1.0 <= largest <= WIDEST):
        size = {"width": Figure(columns * scale, 2), "height": Figure(rows * scale, 2)}
        raise ValueError(Text("plan-picture-size", file=str(file), **size))
    side = _pixels_per_cell(file, rows, columns, scale)
    # From the lower left corner, which is the origin, and not from the first row, which is the uppermost one.
    free = joined(np.flipud(grey >= threshold * 255.0), side, beyond=True)
    if not free.any():
        raise ValueError(Text("plan-picture-dark", file=str(file)))
    occupancy = OccupancyMap(np.ascontiguousarray(free), scale * side)
    return draft_of_map(occupancy, file, title, name, noun="picture", outside=outside)


def _pixels_per_cell(file: Path, rows: int, columns: int, scale: float) -> int:
    """Return the number of pixels along one side of a cell."""
    side = max(1, int(FINEST / scale), int(np.ceil(np.sqrt(rows * columns / MOST_CELLS))))
    if scale * side > COARSEST:
        raise ValueError(Text("plan-picture-coarse", file=str(file), size=Figure(scale * side, 2)))
    return side


def _read(file: Path) -> NDArray[np.uint8]:
    """Return the grey values (rows, columns), transparent pixels as white."""
    try:
        if file.stat().st_size > MOST_PLAN_BYTES:
            raise ValueError(Text("plan-picture-large", file=str(file), most=MOST_PLAN_BYTES // 1_000_000))
        with Image.open(file, formats=FORMATS) as image:
            if image.width * image.height > MOST_PIXELS:
                raise ValueError(Text("plan-picture-pixels", file=str(file), most=MOST_PIXELS))
            return _grey(image)
    except FileNotFoundError as error:
        raise ValueError(Text("plan-file-missing", file=str(file))) from error
    except UnidentifiedImageError as error:
        raise ValueError(Text("plan-picture-no-picture", file=str(file))) from error
    except (Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        raise ValueError(Text("plan-picture-pixels", file=str(file), most=MOST_PIXELS)) from error
    except ValueError as error:
        if isinstance(text_of(error), Text):
            raise
        raise ValueError(Text("plan-picture-damaged", file=str(file))) from error
    except OSError as error:
        if error.strerror is None:
            raise ValueError(Text("plan-picture-damaged", file=str(file))) from error
        raise ValueError(Text("plan-picture-unreadable", file=str(file), reason=error.strerror)) from error
    except Exception as error:
        # Pillow may raise any exception for a damaged picture.
        raise ValueError(Text("plan-picture-damaged", file=str(file))) from error


def _grey(image: Image.Image) -> NDArray[np.uint8]:
    upright = ImageOps.exif_transpose(image)
    if upright.mode in {"RGBA", "LA", "PA"} or "transparency" in upright.info:
        drawn = upright.convert("RGBA")
        paper = Image.new("RGBA", drawn.size, "white")
        upright = Image.alpha_composite(paper, drawn)
    elif upright.mode.startswith("I"):  # 16 bits of grey
        return np.asarray(np.asarray(upright, dtype=np.float64) / 257.0).clip(0, 255).astype(np.uint8)
    return np.asarray(upright.convert("L"))
