"""The archive of a patient: sent while it is made, or received in pieces and imported by a process of its own."""

import asyncio
from collections.abc import Iterator
from contextlib import closing, contextmanager
from functools import partial
from pathlib import Path
from typing import Annotated, BinaryIO, Literal

from fastapi import APIRouter, Depends, Request
from fastapi.concurrency import contextmanager_in_threadpool
from fastapi.responses import StreamingResponse

from app.api.deps import Db, Exporter, Owner, RowId, SettingsPart, SpreadPart
from app.api.foreign_files import refusal
from app.api.package_download import CourseWord, Download
from app.api.page_session import OF_CLINIC, any_session
from app.api.parts import part
from app.api.sign_in.identity import SignedInPerson
from app.computing_process import ComputingProcess
from app.disk_room import ROOM_TO_RECORD
from app.features.archive.archive_import import Imported, import_apart
from app.features.archive.service import archive_material, archive_room
from app.features.registration import report_for_archive
from app.quantities import Document
from app.refusals import NO_ROOM, DiskFull
from app.settings import Settings
from app.store.files.disk_watch import disk_room
from app.store.files.temporary_folders import bytes_in, temporary_folder

router = APIRouter(tags=["exports"])

PIECE = 1 << 20  # bytes
ZIP = {"requestBody": {"required": True, "content": {"application/zip": {"schema": {"type": "string"}}}}}
FILE, RECORDINGS = "archive.zip", "recordings"  # in the folder of an import

Step = Literal["send", "unpack"]


class ImportCourse:
    """An import under way: first its file arrives, then its recordings are checked and unpacked."""

    def __init__(self, folder: Path, total: int) -> None:
        self.file, self.recordings = folder / FILE, folder / RECORDINGS
        self.step: Step = "send"
        self._folder = folder
        self._sent = total  # bytes that the browser announced; 0: none
        self._unpacked = 0  # bytes, the most that were seen: at the end the recordings are moved to their place

    def begin_to_unpack(self) -> None:
        """Note that the whole file is here."""
        self.step = "unpack"

    def moved(self) -> int:
        """Return a number that changes while the import goes on."""
        return bytes_in(self._folder)

    def bytes(self) -> tuple[int, int]:
        """Return how many bytes of this step are done, and of how many; 0 of 0 while that is not known."""
        size = self.file.stat().st_size if self.file.exists() else 0
        if self.step == "send":
            return min(size, self._sent), self._sent
        self._unpacked = max(self._unpacked, bytes_in(self.recordings))
        return min(self._unpacked, size), size


class ImportCourses:
    """The imports under way, one for each person: the newest."""

    def __init__(self) -> None:
        self._of: dict[int, ImportCourse] = {}

    @contextmanager
    def begun(self, person_id: int, folder: Path, total: int) -> Iterator[ImportCourse]:
        """Keep the course of an import of `total` bytes in `folder` as long as it goes on."""
        course = self._of[person_id] = ImportCourse(folder, total)
        try:
            yield course
        finally:
            if self._of.get(person_id) is course:
                del self._of[person_id]

    def of(self, person_id: int) -> ImportCourse | None:
        """Return the course of a person's import, None when there is none."""
        return self._of.get(person_id)


class ArchiveRoomView(Document):
    """The recordings of an archive; `message`: why there is no room for them, empty when there is."""

    bytes: int
    message: str


@router.get("/patients/{patient_id}/archive", response_class=StreamingResponse)
def archive(
    patient_id: RowId,
    person: Exporter,
    download: Download,
    settings: SettingsPart,
    database: Db,
    spread: SpreadPart,
    course: CourseWord | None = None,
) -> StreamingResponse:
    """Return everything of a patient as one zip file, which another clinic can import; with the report of the course.

    409 without the patient's consent to sharing outside, or while a session of the patient is open; 507 without room
    on the clinic's disk, where it is made.

    For owners and clinicians.
    """
    material = archive_material(database, patient_id, person.name, settings.runs, settings.state)
    spreads_of = spread.for_patient(patient_id)
    make_report = report_for_archive(database, settings, patient_id, spreads_of)
    return download.sent(material.steps(make_report), len(material.folders), "archive", person, course)


@router.get("/patients/{patient_id}/archive/room")
def room(patient_id: RowId, _person: Exporter, settings: SettingsPart, database: Db) -> ArchiveRoomView:
    """Return how large the recordings of a patient's archive are, and whether the clinic's disk has room for them."""
    room_needed = archive_room(database, patient_id, settings.runs, settings.state)
    return ArchiveRoomView(bytes=room_needed.bytes, message=str(room_needed.message or ""))


ImportsPart = Annotated[ImportCourses, Depends(part(ImportCourses))]


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
def import_course(person: Owner, imports: ImportsPart) -> ImportCourseView | None:
    """Return how far the import is that the person who asks has begun, null when there is none."""
    course = imports.of(person.person_id)
    if course is None:
        return None
    done, total = course.bytes()
    return ImportCourseView(step=course.step, done=done, total=total)


@router.post("/archives", openapi_extra=ZIP)
@any_session(OF_CLINIC)
async def bring_archive(
    request: Request, person: Owner, settings: SettingsPart, imports: ImportsPart, replace: bool = False
) -> ImportedView:
    """Import the archive of a patient, the body of the request; a wrong one changes nothing.

    409 when the patient is in the clinic already; `replace` puts the archive's patient in the place of that one, of
    whom first an archive is kept for 30 days. 409, too, when the code or the recordings are those of another patient,
    and when the patient cannot be replaced: while a session is open, as part of an incident, or when sessions that were
    held here must be kept. 507 when there is no room.

    For owners: a file of at most 8 GB. 422: no archive, damaged, or other rows.
    """
    async with contextmanager_in_threadpool(temporary_folder(settings.state, "import")) as folder:
        announced = request.headers.get("content-length", "")
        total = int(announced) if announced.isdecimal() else 0
        with imports.begun(person.person_id, folder, total) as course:
            with course.file.open("xb") as opened:
                waiting = bytearray()
                async for piece in request.stream():
                    waiting += piece
                    if len(waiting) >= PIECE:
                        await asyncio.to_thread(_write, opened, waiting, folder)
                        waiting = bytearray()
                await asyncio.to_thread(_write, opened, waiting, folder)
            course.begin_to_unpack()
            imported = await asyncio.to_thread(_import, course, person, settings, replace)
    return ImportedView(**imported._asdict())


def _write(opened: BinaryIO, content: bytearray, folder: Path) -> None:
    if disk_room(folder).free < ROOM_TO_RECORD:
        raise DiskFull(NO_ROOM)
    opened.write(content)


def _import(course: ImportCourse, person: SignedInPerson, settings: Settings, replace: bool) -> Imported:
    """Import a file; it may take as long as it goes on unpacking recordings."""
    given = settings.database, person.clinic_id, course.file, person.name, settings.runs, course.recordings
    shelf = settings.replaced if replace else None
    try:
        with closing(ComputingProcess()) as computing:
            return computing.ask_while(course.moved, partial(import_apart, *given, shelf))
    except ValueError as error:
        raise refusal(error, [f"{course.file}: "]) from error
