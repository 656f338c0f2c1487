"""Layouts that a clinic makes by hand: what the feature gives to the rest of the program."""

from typing import Final

from app.features.layouts.tables import ClinicLayout
from app.features.registration import Feature

FEATURE: Final = Feature(
    tables=(ClinicLayout,),
    routes=("routes",),
    not_archived={"clinic_layout": "a layout of this clinic; a calibration, which goes along, has its own copy"},
)
