"""How long records must be kept: the owner's setting, and deletion before that."""

from datetime import datetime
from typing import Final

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.refusals import Conflict
from app.store.access.visible_patients import WITH_DELETED, own_clinic_id
from app.store.keeping.keeping_tables import RecordKeeping
from app.store.keeping.passed_time import passed_now
from app.store.tables import Patient, PatientSession
from app.texts import Text

MOST_YEARS: Final = 100


def record_time(db: Session) -> int | None:
    """Return for how many years after the last session records must be kept; None: the owner has set nothing."""
    return db.scalar(select(RecordKeeping.years).where(RecordKeeping.clinic_id == own_clinic_id(db)))


def set_record_time(db: Session, years: int | None) -> None:
    """Set for how many years after the last session records must be kept; None: no longer than somebody wants."""
    db.merge(RecordKeeping(clinic_id=own_clinic_id(db), years=years))


def must_be_kept_until(db: Session, patient: Patient) -> datetime | None:
    """Return until when the records of a patient must be kept; None when that is over, or the owner set nothing."""
    years = db.scalar(select(RecordKeeping.years).where(RecordKeeping.clinic_id == patient.clinic_id))
    if not years:
        return None
    query = select(func.max(PatientSession.started)).where(PatientSession.patient_id == patient.id)
    last = db.scalar(query, execution_options=WITH_DELETED) or patient.created
    until = years_later(last, years)
    return until if until > passed_now(db) else None


def years_later(moment: datetime, years: int) -> datetime:
    """Return the same day some years later; 1 March for a 29 February that this year does not have."""
    try:
        return moment.replace(year=moment.year + years)
    except ValueError:
        return moment.replace(year=moment.year + years, month=3, day=1)


def require_reason(db: Session, patient: Patient, reason: str) -> None:
    """Refuse a deletion without a reason while the records must be kept."""
    until = must_be_kept_until(db, patient)
    if until is not None and not reason:
        raise Conflict(Text("store-records-kept-reason", code=patient.code, until=until.date()))
