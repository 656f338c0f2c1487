"""Replace a patient by what an archive has: what stands against it, and how the rows that are here go."""

from typing import Any, Final

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.refusals import Conflict
from app.store.keeping.incidents import incident_of
from app.store.keeping.keeping_tables import PatientFile
from app.store.keeping.last_ids import note_last_ids
from app.store.keeping.owned_rows import erase_rows, forget_in_lists, rows_of_patient
from app.store.keeping.record_time import must_be_kept_until
from app.store.records.import_tables import ImportedSession
from app.store.records.imports import require_no_runs, runs_here
from app.store.records.patient_rows import Rows
from app.store.schema import metadata
from app.store.tables import Patient, PatientSession

HERE: Final = "{code} is in this clinic already, and nothing was imported: replace that patient, or leave it as it is."
GOES_ON: Final = "A session of {code} is open here, and nothing was imported: end it first, then import again."
INCIDENT: Final = (
    "{code} is part of the incident of {made:%Y-%m-%d} and must not be replaced: an owner lifts the mark of the "
    "incident first."
)
KEPT: Final = (
    "Sessions of {code} were held in this clinic, and their records must be kept until {until:%Y-%m-%d}: the patient "
    "cannot be replaced, and nothing was imported."
)


class PatientHere(Conflict):
    """The patient of an archive is in the clinic already: a person chooses whether it is replaced."""


def require_replaceable(db: Session, patient: Patient, rows: Rows) -> None:
    """Raise Conflict when a patient cannot be replaced by these rows of an archive."""
    own = runs_here(db, patient.id)
    require_no_runs(db, [row["id"] for row in rows["run"] if row["id"] not in own])
    of_patient = select(PatientSession.id).where(PatientSession.patient_id == patient.id)
    if db.scalar(of_patient.where(PatientSession.ended.is_(None)).limit(1)) is not None:
        raise Conflict(GOES_ON.format(code=patient.code))
    incident = incident_of(db, patient.id)
    if incident is not None:
        raise Conflict(INCIDENT.format(code=patient.code, made=incident.made))
    until = must_be_kept_until(db, patient)
    imported = select(ImportedSession.session_id)
    if until is not None and db.scalar(of_patient.where(PatientSession.id.not_in(imported)).limit(1)) is not None:
        raise Conflict(KEPT.format(code=patient.code, until=until))


def remove_replaced_rows(db: Session, patient_id: int) -> list[PatientFile]:
    """Remove all rows of a patient; return what says which uploads are theirs, for the patient who takes the place.

    No tombstone is made: the person is still a patient.
    """
    query = select(PatientFile).where(PatientFile.patient_id == patient_id)
    uploads = [PatientFile(name=row.name, current=row.current) for row in db.scalars(query)]
    connection: Any = db.connection().connection.driver_connection
    tables = metadata()
    rows = rows_of_patient(connection, tables, patient_id)
    note_last_ids(connection, tables, rows)
    erase_rows(connection, tables, rows)
    forget_in_lists(connection, patient_id)
    db.expunge_all()
    return uploads
