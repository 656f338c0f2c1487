"""Uploaded 3D objects, drawn in place of boxes."""

import shutil
import tempfile
from functools import lru_cache
from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, HTTPException, Query, UploadFile

from app.api.deps import Clinician, Db, ReadingsPart, ReplacedFilesPart, SettingsPart
from app.api.foreign_files import refusal
from app.api.page_session import OF_CLINIC, any_session
from app.api.routes.signal_uploads import harmless_name
from app.quantities import Document
from app.scene.models.objects import MOST_BYTES, read_isolated_into, stored_model
from app.store.database import Database
from app.store.files.name_conflicts import SameName, log_details
from app.store.files.replacements import ReplacedFiles
from app.store.log import write_log
from app.texts import Text

SUFFIX = ".glb"
MOST_MODELS = 200

router = APIRouter(prefix="/models", tags=["floor plans"])


class ModelView(Document):
    """An object by its name, with its size."""

    name: str
    bytes: int
    size: tuple[float, float, float]  # m: length, width, height
    faces: int


@lru_cache(maxsize=MOST_MODELS)
def _model_view(file: Path, _changed_at: int) -> ModelView:
    model = stored_model(file)
    length, width, height = (round(side, 3) for side in model.size)
    return ModelView(name=file.stem, bytes=file.stat().st_size, size=(length, width, height), faces=model.faces)


def _list(folder: Path) -> list[ModelView]:
    models = []
    for file in sorted(folder.glob(f"*{SUFFIX}")):
        try:
            models.append(_model_view(file, file.stat().st_mtime_ns))
        except (ValueError, OSError):
            continue  # unreadable: not drawn either
    return models


def _keep(
    folder: Path, shelf: ReplacedFiles, file: UploadFile, same_name: SameName, metres_per_unit: float | None
) -> str:
    """Store an object atomically, and return its name."""
    safe = harmless_name(file.filename or "")
    if Path(safe).suffix != SUFFIX:
        raise HTTPException(415, Text("api-no-glb", name=safe))
    if (file.size or 0) > MOST_BYTES:
        raise HTTPException(413, Text("api-glb-too-large", name=safe, megabytes=MOST_BYTES // 1_000_000))
    shelf.check_name("model", safe, same_name)
    if len(list(folder.glob(f"*{SUFFIX}"))) >= MOST_MODELS:
        raise HTTPException(409, Text("api-too-many-objects", count=MOST_MODELS))
    with tempfile.TemporaryDirectory(prefix="bodydrive-model-") as apart:
        tried = Path(apart) / safe
        with tried.open("wb") as opened:
            shutil.copyfileobj(file.file, opened)
        try:
            read_isolated_into(folder, tried, metres_per_unit)
        except ValueError as error:
            raise refusal(error) from error
        return Path(shelf.put("model", safe, tried.read_bytes(), same_name)).stem


@router.get("")
def list_models(_person: Clinician, settings: SettingsPart) -> list[ModelView]:
    """List the objects that a box can show."""
    return _list(settings.models)


@router.post("", status_code=201)
@any_session(OF_CLINIC)
async def bring_model(
    file: UploadFile,
    person: Clinician,
    settings: SettingsPart,
    database: Db,
    replaced: ReplacedFilesPart,
    readings: ReadingsPart,
    same_name: SameName = "ask",
    metres_per_unit: Annotated[float | None, Query(ge=1e-6, le=1000, allow_inf_nan=False)] = None,
) -> list[ModelView]:
    """Store an object and return the list of all; `same_name`: what to do when its name is taken.

    An improbable size is asked about unless `metres_per_unit` says how long one unit of the file is; the object is
    stored in metres.

    A GLB of at most 20 MB and 100,000 faces, with PNG or JPEG pictures of at most 16 million pixels each.
    """

    def keep() -> list[ModelView]:
        name = _keep(settings.models, replaced, file, same_name, metres_per_unit)
        _log(database, person.name, name, same_name)
        return _list(settings.models)

    return await readings.run(keep)


def _log(database: Database, person: str, name: str, same_name: SameName) -> None:
    with database.transaction() as db:
        write_log(db, person, "object added", model=name, **log_details(same_name))
