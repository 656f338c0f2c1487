"""Everything of a patient as one zip file, sent while it is made."""

from fastapi import APIRouter
from fastapi.responses import StreamingResponse

from app.api.deps import Exporter, PeopleParts, RowId
from app.api.exports.sent_packages import CourseWord, sent
from app.api.parts import Web
from app.exports.archive.archive_making import archive_material
from app.exports.archive.archive_room import archive_room
from app.features.registration import report_for_archive
from app.quantities import Document

router = APIRouter(tags=["exports"])


class ArchiveRoomView(Document):
    """The recordings of an archive; `words`: why there is no room for them, empty when there is."""

    bytes: int
    words: str


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
    spreads_of = web.spread.for_patient(who.clinic_id, patient_id)
    make_report = report_for_archive(parts.database, settings, who.clinic_id, patient_id, spreads_of)
    return sent(material.steps(make_report), len(material.folders), "archive", parts, who, course)


@router.get("/patients/{patient_id}/archive/room")
def room(patient_id: RowId, who: Exporter, parts: PeopleParts) -> ArchiveRoomView:
    """Return how large the recordings of a patient's archive are, and whether the clinic's disk has room for them."""
    settings = parts.settings
    found = archive_room(parts.database, who.clinic_id, patient_id, settings.runs, settings.state)
    return ArchiveRoomView(**found._asdict())
