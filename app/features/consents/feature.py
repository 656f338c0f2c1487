"""Consents: what the feature gives to the rest of the program."""

from typing import Final

from app.features.consents.service import consented
from app.features.consents.tables import PatientConsent
from app.features.registration import ArchivedTable, Feature
from app.quantities import Line
from app.store.consent import Consent

FEATURE: Final = Feature(
    tables=(PatientConsent,),
    routes=("routes",),
    archived=(
        ArchivedTable(
            PatientConsent,
            by="patient_id",
            forms={"consent": Consent, "person": Line, "withdrawn_by": Line},
        ),
    ),
    of_incidents=(PatientConsent,),
    consented=consented,
)
