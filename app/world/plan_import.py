"""Makes a floor plan of a file from elsewhere: a ROS map, a DXF drawing or a picture.

`python -m app.world.plan_import` does it for the web process, in a process of its own: foreign files may take long,
and whatever they do to their reader must not keep a moving chair waiting.
"""

import json
import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import Annotated, Any, Final, Literal

from pydantic import Field, ValidationError

from app.quantities import Document, Name, Title
from app.sentences import one_sentence
from app.world.draft import Draft
from app.world.dxf_import import import_dxf
from app.world.image_import import THRESHOLD, import_image
from app.world.map_import import draft_of_map
from app.world.occupancy import read_occupancy_map

MAPS: Final = (".yaml", ".yml")
IMAGES: Final = (".png", ".jpg", ".jpeg")
DRAWINGS: Final = (".dxf",)
SUFFIXES: Final = (*MAPS, *IMAGES, *DRAWINGS)
MOST_MEMORY: Final = 3_000_000_000  # bytes
LONGEST: Final = 60  # s of computing
NICE: Final = 10

Scale = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=1000)]


class Options(Document):
    """What a file does not say about itself."""

    unit: Literal["mm", "cm", "m", "inch", "foot"] | None = None
    layers: Annotated[tuple[str, ...], Field(max_length=1000)] | None = None
    metres_per_pixel: Scale | None = None
    width: Scale | None = None  # m, of the whole picture
    threshold: Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, lt=1)] = THRESHOLD
    title: Title | None = None
    name: Name | None = None


def import_plan(file: Path, options: Options, image: Path | None = None) -> Draft:
    """Return what a file proposes; `image` is read instead of the one that a ROS map names.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    suffix = file.suffix.lower()
    if suffix in DRAWINGS:
        return import_dxf(file, options.unit, options.layers, options.title, options.name)
    if suffix in IMAGES:
        return import_image(
            file, options.metres_per_pixel, options.width, options.threshold, options.title, options.name
        )
    if suffix in MAPS:
        return draft_of_map(read_occupancy_map(file, image), file, options.title, options.name)
    raise ValueError(f"{file}: this is no {', '.join(SUFFIXES)} file, name another")


def answer(question: dict[str, Any]) -> dict[str, Any]:
    """Return `{"draft": ...}` or `{"problem": sentence}` for `{"file", "image", "options"}`."""
    file, image = Path(question["file"]), question["image"]
    try:
        options = Options.model_validate_json(json.dumps(question["options"]))
    except ValidationError as error:
        return {"problem": one_sentence(error, "the import")}
    try:
        draft = import_plan(file, options, None if image is None else Path(image))
    except ValueError as error:
        return {"problem": str(error).replace(f"{file.parent}/", "")}
    except MemoryError:
        return {"problem": f"{file.name}: this needs too much memory, make it smaller"}
    return {"draft": draft._asdict()}


def main() -> None:
    """Answer one question from standard input on standard output."""
    import resource  # noqa: PLC0415  (not on every system on which the command line runs)

    os.nice(NICE)
    with suppress(ValueError, OSError):  # some systems do not limit memory
        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST + 1))
    json.dump(answer(json.load(sys.stdin)), sys.stdout)


if __name__ == "__main__":
    main()
