"""Makes a report for somebody: writes it into the log, and puts the log's new head into it."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import NamedTuple

from app.features.reports.composition import report_file
from app.features.reports.document import Form
from app.features.reports.material import ReportMaterial, report_material
from app.refusals import Conflict
from app.scoring.verdict.spread import SpreadsOf
from app.settings import Settings
from app.store.consent import require_consent
from app.store.database import Database
from app.store.log import write_log
from app.store.log_chain import HeadFile
from app.store.patients import find_patient, sessions_of
from app.texts import Text


class Subject(NamedTuple):
    """Whose report: of one session by its number, or of the whole course (None)."""

    patient_id: int
    session: int | None


def exported_material(
    database: Database,
    settings: Settings,
    subject: Subject,
    form: Form,
    person: str,
    spreads_of: SpreadsOf,
    *,
    for_patient: bool = False,
) -> ReportMaterial:
    """Return what a report is made from, as a row of the log says that `person` took it out of the clinic.

    The head of the log in it is that after this row. A report `for_patient` says so, and needs no consent.

    Raises
    ------
    NotFound
        As `report_material` does.
    Conflict
        When the report is for somebody else, and the patient has not consented to sharing outside the clinic.
    """
    if not for_patient:
        _require_consent(database, subject)
    material = report_material(database, *subject, settings, spreads_of)
    of_session = {} if material.session_id is None else {"session": material.session_id}
    with database.transaction(closing=True) as db:
        details = {"patient": material.patient_id, "form": form, "for_patient": for_patient, **of_session}
        write_log(db, person, "report exported", **details)
    return replace(material, head=HeadFile(settings.database).read(), for_patient=for_patient)


def _require_consent(database: Database, subject: Subject) -> None:
    with database.reading() as db:
        patient = find_patient(db, subject.patient_id)
        try:
            require_consent(db, patient.id, "sharing")
        except Conflict as refusal:
            raise Conflict(Text("report-needs-consent", refusal=refusal)) from refusal


def report_of_archive(
    database: Database, settings: Settings, patient_id: int, spreads_of: SpreadsOf
) -> Callable[[], bytes] | None:
    """Return what makes the report of a patient's course as HTML for an archive; None for a patient without a session.

    The log has a row for the archive: this adds none.
    """
    with database.reading() as db:
        if not sessions_of(db, patient_id):
            return None
    material = report_material(database, patient_id, None, settings, spreads_of)
    return partial(report_file, replace(material, head=HeadFile(settings.database).read()), "html", "a4")
