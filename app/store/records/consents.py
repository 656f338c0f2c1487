"""The consents of a patient: recording, use for the clinic's prior, sharing outside. Each is off until it is given."""

from dataclasses import dataclass
from datetime import date
from typing import Literal

from sqlalchemy import ColumnElement, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict
from app.store.records.record_tables import PatientConsent
from app.store.tables import Patient

Consent = Literal["recording", "clinic_prior", "sharing"]
CONSENTS: tuple[Consent, ...] = ("recording", "clinic_prior", "sharing")

NEEDED: dict[str, str] = {
    "recording": "{code} has not consented to recording: ask, and enter the date on the page of consents. Practice "
    "with the simulated shirt needs no consent.",
    "clinic_prior": "{code} has not consented to the use for other patients of the clinic: ask, and enter the date "
    "on the page of consents.",
    "sharing": "{code} has not consented to sharing outside the clinic: ask, and enter the date on the page of "
    "consents.",
}


@dataclass(frozen=True, slots=True)
class Consents:
    """The day on which each consent was given; None: not given, or withdrawn."""

    recording: date | None = None
    clinic_prior: date | None = None
    sharing: date | None = None


def consents_of(db: Session, patient_id: int) -> Consents:
    """Return the consents of a patient that are in force."""
    query = select(PatientConsent).where(PatientConsent.patient_id == patient_id)
    rows = db.scalars(query.where(PatientConsent.withdrawn.is_(None)))
    return Consents(**{row.consent: row.given for row in rows})


def consent_history(db: Session, patient_id: int) -> list[PatientConsent]:
    """Return every consent that a patient has given, also those withdrawn, the oldest first."""
    query = select(PatientConsent).where(PatientConsent.patient_id == patient_id)
    return list(db.scalars(query.order_by(PatientConsent.id)))


def require_consent(database: Session, patient_id: int, consent: Consent) -> None:
    """Raise Conflict when a patient has not given a consent, or has withdrawn it."""
    if getattr(consents_of(database, patient_id), consent) is None:
        raise Conflict(NEEDED[consent].format(code=database.get_one(Patient, patient_id).code))


def give_consent(db: Session, patient_id: int, consent: Consent, day: date, person: str) -> bool:
    """Store that a patient consents since `day`, and return whether that is new; another day replaces the day before.

    Conflict for a day in the future.
    """
    now = utc_now()
    if day > now.astimezone().date():
        raise Conflict("A consent is given today or was given before: choose a day that is not in the future.")
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


def has_consented(consent: Consent) -> ColumnElement[bool]:
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
