"""Imports a ROS map, a DXF drawing or a picture as the draft of a floor plan."""

import json
from pathlib import Path
from typing import TypedDict

from pydantic import ValidationError

from app.json_values import JsonObject
from app.sentences import one_sentence
from app.texts import Text, reader_language, to_document
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
    raise ValueError(Text("plan-file-of-no-kind", file=str(file), kinds=", ".join(SUFFIXES)))


class PlanQuestion(TypedDict):
    """A file to import, the image of a ROS map where it lies elsewhere, and the document of its options.

    The titles in the plan are in `language`.
    """

    file: str
    image: str | None
    options: JsonObject
    language: str


def answer(question: PlanQuestion) -> dict[str, object]:
    """Return the fields of a draft of a file; called by `app.isolated_reader`.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    file, image = Path(question["file"]), question["image"]
    try:
        options = Options.model_validate_json(json.dumps(question["options"]))
    except ValidationError as error:
        raise ValueError(one_sentence(error, Text("plan-the-import"))) from error
    try:
        with reader_language(question["language"]):
            draft = import_plan(file, options, None if image is None else Path(image))
    except MemoryError as error:
        raise ValueError(Text("plan-file-memory", file=file.name)) from error
    return draft._asdict() | {"messages": [to_document(message) for message in draft.messages]}
