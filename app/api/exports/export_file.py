"""The recordings and measures of a patient, or everything as an archive, as one zip file, sent while it is made."""

from collections.abc import Iterator
from contextlib import AbstractContextManager, closing
from functools import partial
from pathlib import Path
from typing import Annotated

from fastapi import APIRouter, Query
from fastapi.responses import StreamingResponse

from app.api.deps import Exporter, People, PeopleParts, RowId
from app.api.exports.export_courses import ExportCourse, State
from app.api.parts import Web, WebParts
from app.api.sign_in.identity import SignedInPerson
from app.clock import utc_now
from app.computing_process import ComputingProcess
from app.exports.archive.archive_making import archive_material
from app.exports.archive.archive_room import archive_room
from app.exports.export_material import exported_material
from app.exports.forms import Form
from app.exports.package import Step, export_steps
from app.quantities import Document
from app.reports.material import SpreadsOf
from app.reports.report_making import report_of_archive
from app.scoring.verdict.spread import Spread
from app.session.clinic_spread import Task
from app.source import SourceGroup
from app.store.files.passing_folder import bytes_in, passing_folder

router = APIRouter(tags=["exports"])

CHUNK = 1 << 18  # bytes


CourseWord = Annotated[str, Query(pattern=r"^[0-9a-z-]{8,40}$")]


class ExportCourseView(Document):
    """How far an export is: recordings that are packed, of how many, and bytes that are sent."""

    packed: int
    recordings: int
    sent: int
    state: State


class ArchiveRoomView(Document):
    """The recordings of an archive; `words`: why there is no room for them, empty when there is."""

    bytes: int
    words: str


@router.get("/exports")
def export_course(course: CourseWord, who: Exporter, parts: PeopleParts) -> ExportCourseView | None:
    """Return how far an export of the person who asks is, by the word that it was begun with; null when none has it."""
    found = parts.exports.of(who.person_id, course)
    if found is None:
        return None
    return ExportCourseView(packed=found.packed, recordings=found.recordings, sent=found.sent, state=found.state)


@router.get("/patients/{patient_id}/export", response_class=StreamingResponse)
def export(
    patient_id: RowId,
    who: Exporter,
    parts: PeopleParts,
    web: Web,
    form: Form,
    session: Annotated[int | None, Query(ge=1, le=2**31)] = None,
    course: CourseWord | None = None,
) -> StreamingResponse:
    """Return the export of the session with this number, without one of all sessions, as a zip file.

    With a word in `course`, `GET /exports?course=WORD` says meanwhile how far it is.

    A process of its own writes it, recording by recording; 409 without the patient's consent to sharing outside;
    507 without room on the clinic's disk, where its parts are made.
    """
    settings, spreads_of = parts.settings, _spreads(web, who.clinic_id, patient_id)
    material = exported_material(
        parts.database,
        who.clinic_id,
        patient_id,
        session,
        form,
        who.name,
        settings.runs,
        spreads_of,
        place=settings.state,
    )
    recordings = 0 if form == "fhir" else len(material.runs)
    return _sent(export_steps(material, form), recordings, form, parts, who, course)


@router.get("/patients/{patient_id}/archive", response_class=StreamingResponse)
def archive(
    patient_id: RowId, who: Exporter, parts: PeopleParts, web: Web, course: CourseWord | None = None
) -> StreamingResponse:
    """Return everything of a patient as one zip file, which another clinic can import; with the report of the course.

    409 without the patient's consent to sharing outside, or while a session of the patient is open; 507 without room
    on the clinic's disk, where it is made.
    """
    settings = parts.settings
    material = archive_material(parts.database, who.clinic_id, patient_id, who.name, settings.runs, settings.state)
    spreads_of = _spreads(web, who.clinic_id, patient_id)
    make_report = report_of_archive(parts.database, settings, who.clinic_id, patient_id, spreads_of)
    return _sent(material.steps(make_report), len(material.folders), "archive", parts, who, course)


@router.get("/patients/{patient_id}/archive/room")
def room(patient_id: RowId, who: Exporter, parts: PeopleParts) -> ArchiveRoomView:
    """Return how large the recordings of a patient's archive are, and whether the clinic's disk has room for them."""
    settings = parts.settings
    found = archive_room(parts.database, who.clinic_id, patient_id, settings.runs, settings.state)
    return ArchiveRoomView(**found._asdict())


def _spreads(web: WebParts, clinic_id: int, patient_id: int) -> SpreadsOf:
    def spreads_of(floorplan: str, path: str, group: SourceGroup) -> dict[str, Spread]:
        return web.spread.of_others(Task(clinic_id, floorplan, path, group), patient_id)

    return spreads_of


def _sent(
    steps: list[Step], recordings: int, form: str, parts: People, who: SignedInPerson, course: str | None
) -> StreamingResponse:
    """Answer with the zip file of these steps; the first packs no recording, the next ones one each."""
    name = f"bodydrive-{form}-{utc_now():%Y%m%dT%H%M%SZ}.zip"
    headers = {"Content-Disposition": f'attachment; filename="{name}"'}
    begun = parts.exports.begun(who.person_id, course, recordings)
    return StreamingResponse(
        _content(steps, parts.settings.state, begun), media_type="application/zip", headers=headers
    )


def _content(steps: list[Step], state: Path, begun: AbstractContextManager[ExportCourse]) -> Iterator[bytes]:
    """Yield the zip file as far as it is final, after each step; its parts lie in a folder that is removed.

    The steps have a process of their own: the computing process of the clinic stays free for trials.
    """
    with begun as course, passing_folder(state, "export") as folder, closing(ComputingProcess()) as computing:
        package = folder / "export.zip"
        for number, step in enumerate(steps):
            final = computing.ask_while(partial(bytes_in, folder), partial(step, package))
            course.packed = min(number, course.recordings)
            yield from _between(package, course, final)
        yield from _between(package, course, package.stat().st_size)


def _between(file: Path, course: ExportCourse, end: int) -> Iterator[bytes]:
    """Yield what was not sent yet of a file, up to a byte."""
    with file.open("rb") as opened:
        opened.seek(course.sent)
        while course.sent < end and (content := opened.read(min(CHUNK, end - course.sent))):
            course.sent += len(content)
            yield content
