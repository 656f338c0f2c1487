"""Makes a report for somebody: writes it into the log, and puts the log's new head into it."""

from dataclasses import replace
from typing import NamedTuple

from app.reports.document import Form
from app.reports.material import ReportMaterial, SpreadsOf, report_material
from app.settings import Settings
from app.store.database import Database
from app.store.log import write_log
from app.store.log_chain import HeadFile


class Subject(NamedTuple):
    """Whose report: of one session by its number, or of the whole course (None)."""

    clinic_id: int
    patient_id: int
    session: int | None


def exported_material(
    database: Database,
    settings: Settings,
    subject: Subject,
    form: Form,
    person: str,
    spreads_of: SpreadsOf,
) -> ReportMaterial:
    """Return what a report is made from, as a row of the log says that `person` took it out of the clinic.

    The head of the log in it is that after this row. Raises NotFound as `report_material` does.
    """
    material = report_material(database, *subject, settings.runs, spreads_of)
    of_session = {} if material.session_id is None else {"session": material.session_id}
    with database.transaction(closing=True) as db:
        write_log(db, person, "report exported", patient=material.patient_id, form=form, **of_session)
    return replace(material, head=HeadFile(settings.database).read())
