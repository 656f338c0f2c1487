"""A patient who comes again rests and moves freely; then the earlier calibration drives, fitted to the shirt."""

from pathlib import Path
from typing import Any

import pytest
from api import fake_process


@pytest.fixture
def again(calibrated: Any) -> Any:
    """A calibrated patient's second session."""
    calibrated.good("DELETE", "/session")
    calibrated.open_session(calibrated.patient["id"])
    return calibrated


def test_the_earlier_calibration_is_fitted_after_rest_and_free_movement(again: Any) -> None:
    before = again.good("GET", "/controls")
    wizard = again.good("GET", "/calibration")
    assert (wizard["earlier"]["version"], wizard["may_fit_earlier"]) == (1, False)
    assert again("POST", "/calibration/fit-earlier").status_code == 409
    assert again.record("rest", "free")["may_fit_earlier"] is True
    again.good("POST", "/calibration/fit-earlier")
    assert again.readings["fitted"] == ["rest", "free"]
    assert set(again.process.parameters["profile"]["high"]) == {1.5}  # it drives at once
    newest, first = again.good("GET", f"/patients/{again.patient['id']}/maps")
    assert (newest["version"], newest["origin"], newest["parent"]) == (2, "donning", 1)
    assert newest["difference"]["joints"]["right_elbow"] == {"range_moved": True}
    assert first["origin"] == "calibration"
    after = again.good("GET", "/controls")
    assert after["parameters"]["gestures"] == before["parameters"]["gestures"]
    row = next(row for row in again.log() if row.what == "calibration fitted to the shirt")
    assert row.details["version"] == 2
    assert again.good("GET", "/adaptation")["back_to"] == 1


@pytest.fixture
def rings_since(calibrated_state: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The layout of the shirt names a ring, which it did not when the patient was calibrated."""
    channels = tuple(
        one.model_copy(update={"ring": "cuff"}) if one.joint == "right_elbow" else one
        for one in fake_process.LAYOUT.channels
    )
    monkeypatch.setattr(fake_process, "LAYOUT", fake_process.LAYOUT.model_copy(update={"channels": channels}))


@pytest.mark.usefixtures("rings_since")
def test_a_calibration_from_before_the_layout_had_rings_still_fits(again: Any) -> None:
    assert again.process.parameters["profile"]["layout"] != fake_process.LAYOUT.model_dump(mode="json")
    assert again.good("GET", "/calibration")["earlier"]["version"] == 1
    again.record("rest", "free")
    again.good("POST", "/calibration/fit-earlier")
    assert again.good("GET", "/adaptation")["back_to"] == 1


def test_controls_that_a_clinician_set_are_kept(again: Any) -> None:
    again.set_controls(cutoff=2.0)
    again.record("rest", "free")
    again.good("POST", "/calibration/fit-earlier")
    assert again.good("GET", "/controls")["parameters"]["cutoff"] == 2.0


def test_a_shirt_that_sits_otherwise_is_one_sentence_and_nothing_changes(again: Any) -> None:
    again.record("rest", "free")
    again.readings["fit"] = "At the right elbow the shirt is turned: turn it back."
    assert again.refused(409, "POST", "/calibration/fit-earlier") == again.readings["fit"]
    assert len(again.good("GET", f"/patients/{again.patient['id']}/maps")) == 1


def test_a_new_calibration_takes_its_place(again: Any) -> None:
    again.calibrate()
    wizard = again.good("GET", "/calibration")
    assert (wizard["earlier"], wizard["may_fit_earlier"]) == (None, False)
    assert again("POST", "/calibration/fit-earlier").status_code == 409


def test_somebody_new_has_no_earlier_calibration(in_session: Any) -> None:
    assert in_session.record("rest", "free")["earlier"] is None
    assert in_session("POST", "/calibration/fit-earlier").status_code == 409
