"""Imports a ROS map, a DXF drawing or a picture as the draft of a floor plan."""

import json
from pathlib import Path
from typing import TypedDict

from pydantic import ValidationError

from app.json_values import JsonObject
from app.sentences import one_sentence
from app.world.imports.draft import Draft
from app.world.imports.dxf import import_dxf
from app.world.imports.image import import_image
from app.world.imports.map_draft import draft_of_map
from app.world.imports.options import DRAWINGS, IMAGES, MAPS, SUFFIXES, Options
from app.world.imports.ros_map import read_occupancy_map


def import_plan(file: Path, options: Options, image: Path | None = None) -> Draft:
    """Return the draft made from a file; `image` is read instead of the one that a ROS map names.

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
            file,
            options.metres_per_pixel,
            options.width,
            options.threshold,
            options.title,
            options.name,
            outside=options.outside,
        )
    if suffix in MAPS:
        occupancy = read_occupancy_map(file, image)
        return draft_of_map(occupancy, file, options.title, options.name, outside=options.outside)
    raise ValueError(f"{file}: this is no {', '.join(SUFFIXES)} file, name another")


class PlanQuestion(TypedDict):
    """A file to import, the image of a ROS map where it lies elsewhere, and the document of its options."""

    file: str
    image: str | None
    options: JsonObject


def answer(question: PlanQuestion) -> dict[str, object]:
    """Return the fields of a draft of a file; called by `app.isolated_reader`.

    Raises
    ------
    ValueError
        One sentence that names the file without its folder, and what to do.
    """
    file, image = Path(question["file"]), question["image"]
    try:
        options = Options.model_validate_json(json.dumps(question["options"]))
    except ValidationError as error:
        raise ValueError(one_sentence(error, "the import")) from error
    try:
        return import_plan(file, options, None if image is None else Path(image))._asdict()
    except ValueError as error:
        raise ValueError(str(error).replace(f"{file.parent}/", "")) from error
    except MemoryError as error:
        raise ValueError(f"{file.name}: this needs too much memory, make it smaller") from error
