"""The recordings and measures of a patient as one zip file, sent while it is made."""

from typing import Annotated

from fastapi import APIRouter, Query
from fastapi.responses import StreamingResponse

from app.api.deps import Db, Exporter, RowId, SettingsPart, SpreadPart
from app.api.package_download import CourseWord, Download
from app.features.exports.export_material import exported_material
from app.features.exports.forms import Form
from app.features.exports.service import export_steps

router = APIRouter(tags=["exports"])


@router.get("/patients/{patient_id}/export", response_class=StreamingResponse)
def export(
    patient_id: RowId,
    person: Exporter,
    download: Download,
    settings: SettingsPart,
    database: Db,
    spread: SpreadPart,
    *,
    form: Form,
    session: Annotated[int | None, Query(ge=1, le=2**31)] = None,
    course: CourseWord | None = None,
) -> StreamingResponse:
    """Return the export of the session with this number, without one of all sessions, as a zip file.

    With a word in `course`, `GET /exports?course=WORD` says meanwhile how far it is.

    A process of its own writes it, recording by recording; 409 without the patient's consent to sharing outside;
    507 without room on the clinic's disk, where its parts are made.

    For owners and clinicians. Each export is a row of the log: patient, session, form, number of runs. Without a new
    byte for 120 s it fails; a download that ends early has no zip directory and cannot be opened.
    """
    material = exported_material(
        database,
        patient_id,
        session,
        form,
        person.name,
        settings.runs,
        spread.for_patient(patient_id),
        place=settings.state,
    )
    recordings = 0 if form == "fhir" else len(material.runs)
    return download.sent(export_steps(material, form), recordings, form, person, course)
