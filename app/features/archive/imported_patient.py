"""The patient of an archive in this clinic: who is here already, what forbids the import, and the replacement."""

from datetime import UTC, datetime
from typing import Final

from sqlalchemy import or_, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.archive.patient_rows import Rows
from app.refusals import Conflict
from app.store.keeping.incidents import incident_of
from app.store.keeping.keeping_tables import PatientFile
from app.store.keeping.last_ids import store_last_ids
from app.store.keeping.owned_rows import erase_rows, forget_in_lists, rows_of_patient, sqlite_connection
from app.store.keeping.record_time import must_be_kept_until
from app.store.origins import ImportedSession, PatientImport
from app.store.schema import metadata
from app.store.tables import Patient, PatientSession, Run

CODE_TAKEN: Final = (
    "The code '{code}' belongs to another patient of this clinic, and nothing was imported: give that patient another "
    "code, then import again."
)
RUNS_HERE: Final = (
    "Recordings of this archive are in this clinic already, and nothing was imported: their patient is here."
)
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


def earlier_import(db: Session, archive: str) -> Patient | None:
    """Return the patient that an archive brought, None when it was not imported here."""
    query = select(Patient).join(PatientImport, PatientImport.patient_id == Patient.id)
    return db.scalar(query.where(PatientImport.archive == archive))


def patient_of_rows(db: Session, rows: Rows) -> Patient | None:
    """Return the patient of an archive's rows who is in the clinic already, None when there is none.

    A patient is known again by the moment at which the first clinic added the patient.
    """
    try:
        created = datetime.fromisoformat(rows["patient"][0]["created"]).astimezone(UTC)
    except (TypeError, ValueError, OverflowError):
        return None  # no date: the check of the rows says so when they are added
    return db.scalar(select(Patient).where(Patient.created == created).limit(1))


def runs_here(db: Session, patient_id: int) -> frozenset[str]:
    """Return the recordings of a patient."""
    query = select(Run.id).join(PatientSession, PatientSession.id == Run.session_id)
    return frozenset(db.scalars(query.where(PatientSession.patient_id == patient_id)))


def require_new(db: Session, rows: Rows) -> None:
    """Raise Conflict when the clinic has the patient's code or one of the recordings already."""
    require_no_runs(db, [row["id"] for row in rows["run"]])
    code = rows["patient"][0]["code"]
    if db.scalar(select(Patient.id).where(Patient.code == code)) is not None:
        raise Conflict(CODE_TAKEN.format(code=code))


def store_import(db: Session, patient_id: int, archive: str, clinic: str, person: str) -> None:
    """Store that all sessions of a patient came with an archive of `clinic`."""
    row = PatientImport(patient_id=patient_id, archive=archive, clinic=clinic, person=person, at=utc_now())
    db.add(row)
    db.flush()
    for session in db.scalars(select(PatientSession.id).where(PatientSession.patient_id == patient_id)).all():
        db.add(ImportedSession(session_id=session, import_id=row.id))
    db.flush()


def require_no_runs(db: Session, ids: list[str]) -> None:
    """Raise Conflict when one of these recordings is in the clinic."""
    here = select(Run.id).where(or_(Run.id.in_(ids), Run.folder.in_(ids))).limit(1)
    if db.scalar(here) is not None:
        raise Conflict(RUNS_HERE)


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
    connection = sqlite_connection(db)
    tables = metadata()
    rows = rows_of_patient(connection, tables, patient_id)
    store_last_ids(connection, tables, rows)
    erase_rows(connection, tables, rows)
    forget_in_lists(connection, patient_id)
    db.expunge_all()
    return uploads
