"""Driving before the prompted movements: from four other people on, with their consent, and when the owner wants it."""

from typing import Any

import pytest

from app.calibration.prior.features import KINDS

CHANNELS = 2  # of each joint of the test's shirt


def entry() -> dict[str, Any]:
    """Return what a patient adds: little, but of the right size."""
    size = KINDS * CHANNELS
    triangle = [0.0] * (size * (size + 1) // 2)
    moments = {"gram": triangle, "moment": [0.0] * size, "stroke_mean": [0.0] * size, "stroke_gram": triangle}
    joint = {"alive": [True] * CHANNELS, "logs": [0.0] * CHANNELS, "seconds": 30.0, "strokes": 3.0, "moments": moments}
    return {"recordings": 1, "joints": {"right_elbow": joint}}


def begin(clinic: Any, code: str) -> int:
    patient = clinic.good("POST", "/patients", json={"code": code, "pseudonym": "Heron"})
    clinic.good("POST", "/session", json={"patient_id": patient["id"]})
    return int(patient["id"])


def record(clinic: Any, *steps: str) -> Any:
    for step in steps:
        clinic.good("POST", f"/calibration/steps/{step}/start")
        clinic.process.run_t = 1000.0
        clinic.until("/calibration", lambda wizard: wizard["running"] is None)
    return clinic.good("GET", "/calibration")


@pytest.fixture
def four_others(signed_in: Any) -> list[int]:
    """Four patients whose accepted calibrations add to the clinic's prior."""
    signed_in.readings["entry"] = entry()
    patients = []
    for number in range(4):
        patients.append(begin(signed_in, f"P-{number}"))
        signed_in.calibrate()
        signed_in.good("DELETE", "/session")
    return patients


def test_with_four_others_a_new_patient_drives_after_rest_and_free_movement(
    signed_in: Any, four_others: list[int]
) -> None:
    begin(signed_in, "P-9")
    wizard = record(signed_in, "rest")
    assert (wizard["others"], wizard["may_drive_now"]) == (len(four_others), False)
    assert signed_in("POST", "/calibration/drive-now").status_code == 409
    assert record(signed_in, "free")["may_drive_now"] is True
    wizard = signed_in.good("POST", "/calibration/drive-now")
    steps, prior = signed_in.readings["fitted"]
    assert (steps, prior.people) == (["rest", "free"], 4)
    assert wizard["result"]["accepted"] is True
    assert signed_in.process.parameters["profile"]["joints"][0]["name"] == "right_elbow"
    assert signed_in.good("GET", "/session")["has_profile"] is True


def test_a_calibration_knows_others_and_not_the_patient(signed_in: Any, four_others: list[int]) -> None:
    signed_in.good("POST", "/session", json={"patient_id": four_others[0]})
    assert signed_in.good("GET", "/calibration")["others"] == 0  # three others are too few
    assert signed_in.good("GET", "/clinic-prior") == {"on": True, "people": 4, "needed": 4}


def test_switched_off_nothing_is_added_and_nobody_is_helped(signed_in: Any, four_others: list[int]) -> None:
    assert signed_in.good("PUT", "/clinic-prior", json={"on": False})["on"] is False
    begin(signed_in, "P-9")
    assert record(signed_in, "rest", "free")["may_drive_now"] is False
    signed_in.calibrate()
    assert signed_in.readings["fitted"][1] is None
    assert signed_in.good("PUT", "/clinic-prior", json={"on": True})["people"] == len(four_others)
    assert [row.what for row in signed_in.log()].count("prior switched") == 2


def test_a_deleted_patient_helps_nobody_and_one_who_is_brought_back_does(
    signed_in: Any, four_others: list[int]
) -> None:
    signed_in.good("DELETE", f"/patients/{four_others[0]}")
    assert signed_in.good("GET", "/clinic-prior")["people"] == 3
    signed_in.good("POST", f"/patients/{four_others[0]}/restore")
    assert signed_in.good("GET", "/clinic-prior")["people"] == 4


def test_a_fit_that_fails_says_why_and_nothing_is_accepted(signed_in: Any, four_others: list[int]) -> None:
    begin(signed_in, "P-9")
    record(signed_in, "rest", "free")
    signed_in.readings["fit"] = "No joint has a channel that can be used: check the shirt."
    refused = signed_in("POST", "/calibration/drive-now")
    assert (refused.status_code, refused.json()["detail"]) == (409, signed_in.readings["fit"])
    assert signed_in.good("GET", "/session")["has_profile"] is False
    assert len(four_others) == 4
