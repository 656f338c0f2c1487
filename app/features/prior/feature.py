"""The clinic's own prior: what the feature gives to the rest of the program."""

from typing import TYPE_CHECKING, Final

from sqlalchemy.orm import Session

from app.features.prior.entries import remove_entries
from app.features.prior.tables import PriorEntry, PriorSwitch
from app.features.registration import Feature
from app.store.consent import Consent

if TYPE_CHECKING:
    from app.session.calibration.garment import OthersPrior
    from app.store.database import Database


def prior(database: "Database") -> "OthersPrior":
    """Return what is known of other people in this clinic."""
    from app.features.prior.service import ClinicPrior

    return ClinicPrior(database)


def consent_withdrawn(db: Session, patient_id: int, consent: Consent) -> None:
    """Take out what a patient has added who no longer consents to the use for others."""
    if consent == "clinic_prior":
        remove_entries(db, patient_id)


FEATURE: Final = Feature(
    tables=(PriorEntry, PriorSwitch),
    routes=("routes",),
    not_archived={
        "prior_entry": "computed from accepted calibrations, which go along; another clinic asks for its own consent",
        "prior_switch": "a setting of this clinic's owner",
    },
    prior=prior,
    consent_withdrawn=consent_withdrawn,
)
