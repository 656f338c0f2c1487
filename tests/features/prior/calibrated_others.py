"""Patients whose accepted calibrations add to the clinic's prior, and a profile that other people taught."""

from typing import Any

from api.fake_clinic import Clinic
from api.fake_process import profile_for

from app.calibration.linear_map import KINDS
from app.layout import Channel, ShirtLayout
from building import taught_by_others

OTHERS = (1, 2, 3, 4)  # their ids
CHANNELS = 2  # of each joint of the test's shirt


def entry() -> dict[str, Any]:
    """Return what a patient adds: little, but of the right size."""
    size = KINDS * CHANNELS
    triangle = [0.0] * (size * (size + 1) // 2)
    moments = {"gram": triangle, "moment": [0.0] * size, "stroke_mean": [0.0] * size, "stroke_gram": triangle}
    joint = {"alive": [True] * CHANNELS, "logs": [0.0] * CHANNELS, "seconds": 30.0, "strokes": 3.0, "moments": moments}
    return {"recordings": 1, "joints": {"right_elbow": joint}}


def calibrate_others(clinic: Clinic) -> None:
    """Calibrate four patients, one after the other."""
    clinic.readings["entry"] = entry()
    for patient in OTHERS:
        assert clinic.begin_session(f"P-{patient}")["id"] == patient
        clinic.calibrate()
        clinic.good("DELETE", "/session")


def profile_with_ring(layout: ShirtLayout, **sits: Any) -> Any:
    """Return a profile whose right elbow drives by other people, with a ring of five sensors that sits in a way."""
    cuff = [Channel(name=f"cuff_{i}", joint="right_elbow", ring="cuff", place=i) for i in range(5)]
    others = [channel for channel in layout.channels if channel.joint != "right_elbow"]
    ringed = ShirtLayout(name=layout.name, channels=(*cuff, *others), joints=layout.joints)
    return taught_by_others(profile_for(ringed), 3, ["right_elbow"], **sits)
