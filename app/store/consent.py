"""What a patient must have consented to: recording, use for other patients of the clinic, sharing outside.

A feature keeps the consents (`app/features/consents/`). Without one nobody has consented to anything.
"""

from typing import Final, Literal, get_args

from sqlalchemy import ColumnElement, false, or_, select
from sqlalchemy.orm import Session

from app.features.registration import features
from app.refusals import Conflict
from app.store.tables import Patient
from app.texts import Text

Consent = Literal["recording", "clinic_prior", "sharing"]
CONSENTS: Final[tuple[Consent, ...]] = get_args(Consent)


def consented(consent: Consent) -> ColumnElement[bool]:
    """Return the condition that the patient of a query (`Patient`) has given a consent that is in force."""
    return or_(
        false(), *(feature.consented(consent) for feature in features().values() if feature.consented is not None)
    )


def has_consented(db: Session, patient_id: int, consent: Consent) -> bool:
    """Return whether a patient has given a consent that is in force."""
    return db.scalar(select(Patient.id).where(Patient.id == patient_id, consented(consent))) is not None


def require_consent(db: Session, patient_id: int, consent: Consent) -> None:
    """Raise Conflict when a patient has not given a consent, or has withdrawn it."""
    if not has_consented(db, patient_id, consent):
        raise Conflict(Text("store-no-consent", code=db.get_one(Patient, patient_id).code, consent=consent))
