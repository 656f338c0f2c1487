"""The report of a session, or of a patient's course of sessions, as a file."""

from typing import Annotated

from fastapi import APIRouter, Query, Response

from app.api.deps import ComputingPart, Db, Exporter, RowId, SettingsPart, SpreadPart
from app.features.reports.composition import file_name, report_file
from app.features.reports.document import Form
from app.features.reports.rendering import MEDIA_TYPES
from app.features.reports.service import Subject, exported_material
from app.texts import LANGUAGES, current_language

router = APIRouter(tags=["reports"])


@router.get("/patients/{patient_id}/report", response_class=Response)
def report(
    patient_id: RowId,
    person: Exporter,
    *,
    settings: SettingsPart,
    database: Db,
    computing: ComputingPart,
    spread: SpreadPart,
    form: Form = "pdf",
    session: Annotated[int | None, Query(ge=1, le=2**31)] = None,
    letter: bool = False,
    for_patient: bool = False,
    language: Annotated[str | None, Query(pattern=f"^({'|'.join(LANGUAGES)})$")] = None,
) -> Response:
    """Return the report of the session with this number, without one of all sessions, on A4 or Letter paper.

    It is in the language of the request, unless `language` is given.

    409 without the patient's consent to sharing outside, unless it is a copy for the patient.

    For owners and clinicians. The file's name holds the patient's id only. The report prints the head of the log with
    its own row, `report exported`.
    """
    spreads_of = spread.for_patient(patient_id)
    subject = Subject(patient_id, session)
    material = exported_material(database, settings, subject, form, person.name, spreads_of, for_patient=for_patient)
    content = computing.ask(
        report_file, material, form, "us-letter" if letter else "a4", language or current_language()
    )
    disposition = f'attachment; filename="{file_name(material, form)}"'
    return Response(content, media_type=MEDIA_TYPES[form], headers={"Content-Disposition": disposition})
