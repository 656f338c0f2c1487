"""Driving before the prompted movements: from four other people on, with their consent, and when the owner wants it."""

from typing import Any

from features.prior.calibrated_others import OTHERS


def test_with_four_others_a_new_patient_drives_after_rest_and_free_movement(with_others: Any) -> None:
    with_others.begin_session("P-9")
    wizard = with_others.record("rest")
    assert (wizard["others"], wizard["may_drive_now"]) == (len(OTHERS), False)
    assert with_others("POST", "/calibration/drive-now").status_code == 409
    assert with_others.record("free")["may_drive_now"] is True
    wizard = with_others.good("POST", "/calibration/drive-now")
    steps, prior = with_others.readings["fitted"]
    assert (steps, prior.people) == (["rest", "free"], 4)
    assert wizard["result"]["accepted"] is True
    assert with_others.process.parameters["profile"]["joints"][0]["name"] == "right_elbow"
    assert with_others.good("GET", "/session")["has_profile"] is True


def test_a_calibration_knows_others_and_not_the_patient(with_others: Any) -> None:
    with_others.open_session(OTHERS[0])
    assert with_others.good("GET", "/calibration")["others"] == 0  # three others are too few
    assert with_others.good("GET", "/clinic-prior") == {"on": True, "people": 4, "needed": 4}


def test_switched_off_nothing_is_added_and_nobody_is_helped(with_others: Any) -> None:
    assert with_others.good("PUT", "/clinic-prior", json={"on": False})["on"] is False
    with_others.begin_session("P-9")
    assert with_others.record("rest", "free")["may_drive_now"] is False
    with_others.calibrate()
    assert with_others.readings["fitted"][1] is None
    assert with_others.good("PUT", "/clinic-prior", json={"on": True})["people"] == len(OTHERS)
    assert [row.what for row in with_others.log()].count("prior switched") == 2


def test_a_deleted_patient_helps_nobody_and_one_who_is_brought_back_does(with_others: Any) -> None:
    with_others.good("DELETE", f"/patients/{OTHERS[0]}")
    assert with_others.good("GET", "/clinic-prior")["people"] == 3
    with_others.good("POST", f"/patients/{OTHERS[0]}/restore")
    assert with_others.good("GET", "/clinic-prior")["people"] == 4


def test_a_fit_that_fails_says_why_and_nothing_is_accepted(with_others: Any) -> None:
    with_others.begin_session("P-9")
    with_others.record("rest", "free")
    with_others.readings["fit"] = "No joint has a channel that can be used: check the shirt."
    assert with_others.refused(409, "POST", "/calibration/drive-now") == with_others.readings["fit"]
    assert with_others.good("GET", "/session")["has_profile"] is False
