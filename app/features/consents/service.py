"""The consents of a patient, each off until it is given."""

from datetime import date

from sqlalchemy import ColumnElement, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.consents.tables import PatientConsent
from app.refusals import Conflict
from app.store.consent import Consent
from app.store.tables import Patient
from app.texts import Text


def consent_history(db: Session, patient_id: int) -> list[PatientConsent]:
    """Return every consent that a patient has given, also those withdrawn, the oldest first."""
    query = select(PatientConsent).where(PatientConsent.patient_id == patient_id)
    return list(db.scalars(query.order_by(PatientConsent.id)))


def give_consent(db: Session, patient_id: int, consent: Consent, day: date, person: str) -> bool:
    """Store that a patient consents since `day`, and return whether that is new; another day replaces the day before.

    Conflict for a day in the future.
    """
    now = utc_now()
    if day > now.astimezone().date():
        raise Conflict(Text("consents-future"))
    before = _in_force(db, patient_id, consent)
    if before is not None and before.given == day:
        return False
    if before is not None:
        before.withdrawn, before.withdrawn_by = now, person
        db.flush()
    db.add(
        PatientConsent(
            patient_id=patient_id,
            consent=consent,
            given=day,
            person=person,
            written=now,
            withdrawn=None,
            withdrawn_by=None,
        )
    )
    db.flush()
    return True


def withdraw_consent(db: Session, patient_id: int, consent: Consent, person: str) -> bool:
    """Store that a patient has withdrawn a consent, and return whether it was in force."""
    row = _in_force(db, patient_id, consent)
    if row is None:
        return False
    row.withdrawn, row.withdrawn_by = utc_now(), person
    db.flush()
    return True


def consented(consent: Consent) -> ColumnElement[bool]:
    """Return the condition that the patient of a query (`Patient`) has given a consent."""
    return (
        select(PatientConsent.id)
        .where(
            PatientConsent.patient_id == Patient.id,
            PatientConsent.consent == consent,
            PatientConsent.withdrawn.is_(None),
        )
        .exists()
    )


def _in_force(db: Session, patient_id: int, consent: Consent) -> PatientConsent | None:
    query = select(PatientConsent).where(PatientConsent.patient_id == patient_id, PatientConsent.consent == consent)
    return db.scalar(query.where(PatientConsent.withdrawn.is_(None)))
