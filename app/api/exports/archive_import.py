"""The archive of a patient of another clinic: received in pieces, and imported by a process of its own."""

import asyncio
from contextlib import closing
from functools import partial
from pathlib import Path
from typing import BinaryIO

from fastapi import APIRouter, Request
from fastapi.concurrency import contextmanager_in_threadpool

from app.api.deps import Owner, People, PeopleParts
from app.api.exports.import_courses import ImportCourse, Step
from app.api.foreign_files import refusal
from app.api.sign_in.identity import SignedInPerson
from app.computing_process import ComputingProcess
from app.disk_room import ROOM_TO_RECORD
from app.exports.archive.imported_archive import Imported, import_apart
from app.quantities import Document
from app.refusals import NO_ROOM, DiskFull
from app.store.files.disk_watch import disk_room
from app.store.files.passing_folder import passing_folder

router = APIRouter(tags=["exports"])

PIECE = 1 << 20  # bytes
ZIP = {"requestBody": {"required": True, "content": {"application/zip": {"schema": {"type": "string"}}}}}


class ImportedView(Document):
    """The patient of an archive, and what came in; not new: imported before by the same archive, or replaced."""

    patient_id: int
    code: str
    is_new: bool
    sessions: int
    trials: int  # finished and kept
    kept: str  # the archive of a replaced patient as it was, in the folder `replaced`; empty: nobody was replaced


class ImportCourseView(Document):
    """How far an import is: bytes of this step; 0 of 0 while that is not known."""

    step: Step
    done: int
    total: int


@router.get("/archives")
def import_course(who: Owner, parts: PeopleParts) -> ImportCourseView | None:
    """Return how far the import is that the person who asks has begun, null when there is none."""
    course = parts.imports.of(who.person_id)
    if course is None:
        return None
    done, total = course.bytes()
    return ImportCourseView(step=course.step, done=done, total=total)


@router.post("/archives", openapi_extra=ZIP)
async def bring_archive(request: Request, who: Owner, parts: PeopleParts, replace: bool = False) -> ImportedView:
    """Import the archive of a patient, the body of the request; a wrong one changes nothing.

    409 when the patient is in the clinic already; `replace` puts the archive's patient in the place of that one, of
    whom first an archive is kept for 30 days. 409, too, when the code or the recordings are those of another patient,
    and when the patient cannot be replaced: while a session is open, as part of an incident, or when sessions that were
    held here must be kept. 507 when there is no room.
    """
    async with contextmanager_in_threadpool(passing_folder(parts.settings.state, "import")) as folder:
        announced = request.headers.get("content-length", "")
        total = int(announced) if announced.isdecimal() else 0
        with parts.imports.begun(who.person_id, folder, total) as course:
            with course.file.open("xb") as opened:
                waiting = bytearray()
                async for piece in request.stream():
                    waiting += piece
                    if len(waiting) >= PIECE:
                        await asyncio.to_thread(_write, opened, waiting, folder)
                        waiting = bytearray()
                await asyncio.to_thread(_write, opened, waiting, folder)
            course.begin_to_unpack()
            imported = await asyncio.to_thread(_import, course, who, parts, replace)
    return ImportedView(**imported._asdict())


def _write(opened: BinaryIO, content: bytearray, folder: Path) -> None:
    if disk_room(folder).free < ROOM_TO_RECORD:
        raise DiskFull(NO_ROOM)
    opened.write(content)


def _import(course: ImportCourse, who: SignedInPerson, parts: People, replace: bool) -> Imported:
    """Import a file; it may take as long as it goes on unpacking recordings."""
    settings = parts.settings
    given = settings.database, who.clinic_id, course.file, who.name, settings.runs, course.recordings
    shelf = settings.replaced if replace else None
    try:
        with closing(ComputingProcess()) as computing:
            return computing.ask_while(course.moved, partial(import_apart, *given, shelf))
    except ValueError as error:
        raise refusal(error, [f"{course.file}: "]) from error
