"""3D objects that people bring, to be drawn instead of boxes."""

import asyncio
import tempfile
from functools import lru_cache
from pathlib import Path

from fastapi import APIRouter, HTTPException, UploadFile

from app.api.deps import Clinician, PeopleParts
from app.api.flows import FlowParts
from app.api.uploads import harmless_name
from app.files import write_atomically
from app.quantities import Document
from app.scene.glb import MOST_BYTES
from app.scene.models import read_model
from app.session.store_log import write_log

SUFFIX = ".glb"
MOST_MODELS = 200

router = APIRouter(prefix="/models", tags=["floor plans"])


class ModelView(Document):
    """An object by the name that a box gives, and how large it is."""

    name: str
    bytes: int
    size: tuple[float, float, float]  # m: length, width, height
    faces: int


@lru_cache(maxsize=MOST_MODELS)
def _looked_at(file: Path, _changed_at: int) -> ModelView:
    model = read_model(file)
    length, width, height = (round(side, 3) for side in model.size)
    return ModelView(name=file.stem, bytes=file.stat().st_size, size=(length, width, height), faces=model.faces)


def _listed(folder: Path) -> list[ModelView]:
    found = []
    for file in sorted(folder.glob(f"*{SUFFIX}")):
        try:
            found.append(_looked_at(file, file.stat().st_mtime_ns))
        except (ValueError, OSError):
            continue  # it is not drawn either
    return found


def _keep(folder: Path, file: UploadFile) -> str:
    """Store an object, whole or not at all, and return its name."""
    safe = harmless_name(file.filename or "")
    if Path(safe).suffix != SUFFIX:
        raise HTTPException(415, f"'{safe}' is no GLB file: export the object as glTF binary (.glb).")
    content = file.file.read(MOST_BYTES + 1)
    if len(content) > MOST_BYTES:
        raise HTTPException(413, f"'{safe}' is larger than {MOST_BYTES // 1_000_000} MB: make the object simpler.")
    name = Path(safe).stem
    standing = [one.stem.lower() for one in folder.glob(f"*{SUFFIX}")]
    if name.lower() in standing:
        raise HTTPException(409, f"There is an object '{name}' already: rename the file, then add it again.")
    if len(standing) >= MOST_MODELS:
        raise HTTPException(409, f"There are {MOST_MODELS} objects already: delete some in the folder 'models'.")
    with tempfile.TemporaryDirectory(prefix="bodydrive-model-") as apart:
        tried = Path(apart) / safe
        tried.write_bytes(content)
        try:
            read_model(tried)
        except ValueError as error:
            raise HTTPException(422, f"{error}.") from error
    write_atomically(folder / safe, content)
    return name


@router.get("")
def list_models(_who: Clinician, parts: PeopleParts) -> list[ModelView]:
    """List the objects that can be given to a box."""
    return _listed(parts.settings.models)


@router.post("", status_code=201)
async def bring_model(file: UploadFile, who: Clinician, parts: PeopleParts, flows: FlowParts) -> list[ModelView]:
    """Take in an object, and list them all."""
    folder = parts.settings.models

    def keep() -> list[ModelView]:
        name = _keep(folder, file)
        with parts.database.transaction() as db:
            write_log(db, who.name, "object added", model=name)
        return _listed(folder)

    async with flows.visit.undisturbed("add an object"):
        return await asyncio.to_thread(keep)
