"""Make floor plans from uploaded files, in an isolated process."""

import asyncio
import json
import shutil
import tempfile
from pathlib import Path
from typing import Any

from fastapi import HTTPException, UploadFile

from app.api.foreign_files import OneAtATime, read_or_refuse
from app.api.routes.signal_uploads import harmless_name
from app.texts import Text, current_language, from_document
from app.world.imports.file_limits import MOST_MAP_BYTES, MOST_PLAN_BYTES
from app.world.imports.options import IMAGES, MAPS, SUFFIXES

PICTURES = (*IMAGES, ".pgm")
READER = "app.world.imports.plan_files"


async def draft_of_uploads(files: list[UploadFile], options: str, readings: OneAtATime) -> dict[str, Any]:
    """Return the draft's document, messages and layers.

    Raises
    ------
    HTTPException
        With one sentence: 413, 415 or 422 for the files, 503 when reading takes too long.
    """
    try:
        import_options = json.loads(options)
    except (ValueError, RecursionError) as error:
        raise HTTPException(422, Text("api-options-not-json")) from error
    folder = Path(await asyncio.to_thread(tempfile.mkdtemp, prefix="bodydrive-import-"))
    try:
        stored = [await asyncio.to_thread(_keep, folder, number, file) for number, file in enumerate(files)]
        plan, image = _plan_and_image(stored)
        question = {
            "file": str(plan),
            "image": None if image is None else str(image),
            "options": import_options,
            "language": current_language(),
        }
        draft = await readings.run(read_or_refuse, READER, question, [f"{file.parent}/" for file in stored])
        return draft | {"messages": [str(from_document(message)) for message in draft["messages"]]}
    finally:
        await asyncio.to_thread(shutil.rmtree, folder, ignore_errors=True)


def _keep(folder: Path, number: int, file: UploadFile) -> Path:
    """Write an uploaded file into a folder of its own, because two may have the same name."""
    name = harmless_name(file.filename or "")
    suffix = Path(name).suffix
    if suffix not in (*SUFFIXES, *PICTURES):
        raise HTTPException(415, Text("api-wrong-plan-file", name=name, endings=", ".join((*SUFFIXES, ".pgm"))))
    content = file.file.read(MOST_PLAN_BYTES + 1)
    if suffix in MAPS and len(content) > MOST_MAP_BYTES:
        raise HTTPException(413, Text("api-map-too-large", name=name))
    if len(content) > MOST_PLAN_BYTES:
        raise HTTPException(413, Text("api-plan-too-large", name=name, megabytes=MOST_PLAN_BYTES // 1_000_000))
    own_folder = folder / str(number)
    own_folder.mkdir()
    (own_folder / name).write_bytes(content)
    return own_folder / name


def _plan_and_image(files: list[Path]) -> tuple[Path, Path | None]:
    """Return the file of the plan, and the image of a ROS map."""
    maps = [file for file in files if file.suffix in MAPS]
    others = [file for file in files if file.suffix not in MAPS]
    if len(maps) == 1 and len(others) == 1 and others[0].suffix in PICTURES:
        return maps[0], others[0]
    if maps:
        raise HTTPException(422, Text("api-map-incomplete"))
    if len(others) != 1:
        raise HTTPException(422, Text("api-one-plan-at-a-time"))
    if others[0].suffix == ".pgm":
        raise HTTPException(422, Text("api-map-picture-alone"))
    return others[0], None
