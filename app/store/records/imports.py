"""Where rows came from: the archive that a patient was imported from, its clinic, and who imported it."""

from dataclasses import dataclass
from datetime import UTC, datetime

from sqlalchemy import or_, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict
from app.store.records.import_tables import ImportedSession, PatientImport
from app.store.records.patient_rows import Rows
from app.store.tables import Clinic, Patient, PatientSession, Run

CODE_TAKEN = (
    "The code '{code}' belongs to another patient of this clinic, and nothing was imported: give that patient another "
    "code, then import again."
)
RUNS_HERE = "Recordings of this archive are in this clinic already, and nothing was imported: their patient is here."


@dataclass(frozen=True, slots=True)
class Origin:
    """Where an imported session was held, and who imported it when."""

    clinic: str
    person: str
    at: datetime


def clinic_name(db: Session, clinic_id: int) -> str:
    """Return the name of a clinic."""
    return db.get_one(Clinic, clinic_id).name


def earlier_import(db: Session, clinic_id: int, archive: str) -> Patient | None:
    """Return the patient that an archive brought, None when it was not imported here."""
    query = select(Patient).join(PatientImport, PatientImport.patient_id == Patient.id)
    return db.scalar(query.where(PatientImport.archive == archive, Patient.clinic_id == clinic_id))


def origin_of(db: Session, session_id: int) -> PatientImport | None:
    """Return where a session came from, None when it was held in this clinic."""
    query = select(PatientImport).join(ImportedSession, ImportedSession.import_id == PatientImport.id)
    return db.scalar(query.where(ImportedSession.session_id == session_id))


def origins_of(db: Session, patient_id: int) -> dict[int, Origin]:
    """Return where each imported session of a patient came from, by session; sessions held here are not in it."""
    query = (
        select(ImportedSession.session_id, PatientImport)
        .join(PatientImport, PatientImport.id == ImportedSession.import_id)
        .where(PatientImport.patient_id == patient_id)
    )
    return {session: Origin(row.clinic, row.person, row.at) for session, row in db.execute(query)}


def patient_of_rows(db: Session, clinic_id: int, rows: Rows) -> Patient | None:
    """Return the patient of an archive's rows who is in the clinic already, None when there is none.

    A patient is known again by the moment at which the first clinic added the patient.
    """
    try:
        created = datetime.fromisoformat(rows["patient"][0]["created"]).astimezone(UTC)
    except (TypeError, ValueError, OverflowError):
        return None  # no date: the check of the rows says so when they are added
    return db.scalar(select(Patient).where(Patient.created == created, Patient.clinic_id == clinic_id).limit(1))


def runs_here(db: Session, patient_id: int) -> frozenset[str]:
    """Return the recordings of a patient."""
    query = select(Run.id).join(PatientSession, PatientSession.id == Run.session_id)
    return frozenset(db.scalars(query.where(PatientSession.patient_id == patient_id)))


def require_new(db: Session, clinic_id: int, rows: Rows) -> None:
    """Raise Conflict when the clinic has the patient's code or one of the recordings already."""
    require_no_runs(db, [row["id"] for row in rows["run"]])
    code = rows["patient"][0]["code"]
    if db.scalar(select(Patient.id).where(Patient.clinic_id == clinic_id, Patient.code == code)) is not None:
        raise Conflict(CODE_TAKEN.format(code=code))


def note_import(db: Session, patient_id: int, archive: str, clinic: str, person: str) -> None:
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
