"""Patients whose accepted calibrations add to the clinic's prior, and steps of the calibration of one more."""

from typing import Any

from api.fake_clinic import Clinic

from app.calibration.linear_map import KINDS

OTHERS = (1, 2, 3, 4)  # their ids
CHANNELS = 2  # of each joint of the test's shirt


def entry() -> dict[str, Any]:
    """Return what a patient adds: little, but of the right size."""
    size = KINDS * CHANNELS
    triangle = [0.0] * (size * (size + 1) // 2)
    moments = {"gram": triangle, "moment": [0.0] * size, "stroke_mean": [0.0] * size, "stroke_gram": triangle}
    joint = {"alive": [True] * CHANNELS, "logs": [0.0] * CHANNELS, "seconds": 30.0, "strokes": 3.0, "moments": moments}
    return {"recordings": 1, "joints": {"right_elbow": joint}}


def begin(clinic: Clinic, code: str) -> int:
    patient = clinic.good("POST", "/patients", json={"code": code, "pseudonym": "Heron"})
    clinic.open_session(patient["id"])
    return int(patient["id"])


def record(clinic: Clinic, *steps: str) -> Any:
    for step in steps:
        clinic.record(step)
    return clinic.good("GET", "/calibration")


def calibrate_others(clinic: Clinic) -> None:
    """Calibrate four patients, one after the other."""
    clinic.readings["entry"] = entry()
    for patient in OTHERS:
        assert begin(clinic, f"P-{patient}") == patient
        clinic.calibrate()
        clinic.good("DELETE", "/session")
