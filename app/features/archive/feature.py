"""Archives of patients: what the feature gives to the rest of the program."""

from typing import Final

from app.features.registration import Feature

FEATURE: Final = Feature(
    routes=("routes",),
    without_session={"POST /archives": "It belongs to the clinic and to no patient."},
)
