"""The archive of a patient of another clinic: received in pieces, and imported by a process of its own."""

import asyncio
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import BinaryIO

from fastapi import APIRouter, Request
from fastapi.concurrency import contextmanager_in_threadpool

from app.api.deps import Owner, People, PeopleParts
from app.api.exports.export_file import bytes_in
from app.api.foreign_files import refusal
from app.api.sign_in.identity import SignedInPerson
from app.computing_process import ComputingProcess
from app.disk_room import ROOM_TO_RECORD
from app.exports.archive import Imported, import_apart
from app.quantities import Document
from app.refusals import NO_ROOM, DiskFull
from app.store.files.disk_watch import disk_room
from app.store.files.passing_folder import passing_folder

router = APIRouter(tags=["exports"])

PIECE = 1 << 20  # bytes
ZIP = {"requestBody": {"required": True, "content": {"application/zip": {"schema": {"type": "string"}}}}}


class ImportedView(Document):
    """The patient of an archive; not new: the archive was imported before, and nothing was changed."""

    patient_id: int
    code: str
    is_new: bool


@router.post("/archives", openapi_extra=ZIP)
async def bring_archive(request: Request, who: Owner, parts: PeopleParts) -> ImportedView:
    """Import the archive of a patient, the body of the request; a wrong one changes nothing.

    409 when the clinic has the patient's code or recordings already, 507 when there is no room.
    """
    async with contextmanager_in_threadpool(passing_folder(parts.settings.state, "import")) as folder:
        file = folder / "archive.zip"
        with file.open("xb") as opened:
            waiting = bytearray()
            async for piece in request.stream():
                waiting += piece
                if len(waiting) >= PIECE:
                    await asyncio.to_thread(_write, opened, waiting, folder)
                    waiting = bytearray()
            await asyncio.to_thread(_write, opened, waiting, folder)
        imported = await asyncio.to_thread(_import, file, who, parts)
    return ImportedView(**imported._asdict())


def _write(opened: BinaryIO, content: bytearray, folder: Path) -> None:
    if disk_room(folder).free < ROOM_TO_RECORD:
        raise DiskFull(NO_ROOM)
    opened.write(content)


def _import(file: Path, who: SignedInPerson, parts: People) -> Imported:
    """Import a file; it may take as long as it goes on unpacking recordings."""
    settings = parts.settings
    question = partial(import_apart, settings.database, who.clinic_id, file, who.name, settings.runs)
    try:
        with closing(ComputingProcess()) as computing:
            return computing.ask_while(lambda: sum(map(bytes_in, settings.state.glob(".import-*"))), question)
    except ValueError as error:
        raise refusal(error, [f"{file}: "]) from error
