"""The controls, as their page asks for them."""

from typing import Any

from api.fake_clinic import Clinic
from sqlalchemy import select

from app.session.open_session import SessionFlow
from app.store.tables import ParameterSet


def test_controls_are_set_undone_named_and_never_half(signed_in: Any) -> None:
    signed_in.begin_session()
    signed_in.calibrate()
    controls = signed_in.good("GET", "/controls")
    parameters = controls["parameters"]
    assert (controls["can_undo"], controls["can_redo"], controls["saved"]) == (False, False, ["Standard"])
    kept = ("gestures", "bindings", "mode_u1", "mode_u2", "cutoff", "speeds", "title")
    body = {name: parameters[name] for name in kept}
    bad = signed_in("PUT", "/controls", json={**body, "bindings": [{"control": "u1+", "gestures": ["nobody"]}]})
    assert (bad.status_code, "nobody" in bad.json()["detail"]) == (422, True)
    assert signed_in("PUT", "/controls", json={**body, "cutoff": 900.0}).status_code == 422
    assert signed_in.good("GET", "/controls")["hash"] == controls["hash"]
    for cruise_time in (0.5, 10.5, None, "3"):
        assert signed_in("PUT", "/controls", json={**body, "turn_cruise_time": cruise_time}).status_code == 422
    no_brake = [{"control": "u1+", "gestures": ["right_elbow"]}]
    obstacle = signed_in.good("PUT", "/controls", json={**body, "bindings": no_brake})["obstacle"]
    assert ("bind a movement" in obstacle["message"], obstacle["page"]) == (True, "controls")
    assert signed_in.good("POST", "/controls/undo")["obstacle"] is None
    assert signed_in.good("PUT", "/controls", json={**body, "cutoff": 5.0, "title": "Brisk"})["can_undo"] is True
    assert signed_in.process.parameters["cutoff"] == 5.0
    undone = signed_in.good("POST", "/controls/undo")
    assert (undone["hash"], undone["can_redo"]) == (controls["hash"], True)
    assert signed_in.process.parameters["cutoff"] == 3.0
    assert signed_in.good("POST", "/controls/redo")["parameters"]["title"] == "Brisk"
    assert signed_in("POST", "/controls/redo").status_code == 409
    assert signed_in.good("POST", "/controls/load", json={"title": "Standard"})["parameters"]["cutoff"] == 3.0
    assert signed_in("POST", "/controls/load", json={"title": "Nowhere"}).status_code == 404
    suggested = signed_in.good("POST", "/controls/suggest")
    assert suggested["parameters"]["bindings"] == suggested["suggested"]["bindings"]


def test_the_gestures_are_those_of_the_calibration_and_one_suggestion_is_everywhere(signed_in: Clinic) -> None:
    signed_in.begin_session()
    assert "Nothing is calibrated yet" in signed_in.refused(409, "GET", "/calibration/gestures")
    signed_in.calibrate()
    found = signed_in.good("GET", "/calibration/gestures")
    assert found["source"] == "profile"  # the runs of these tests are not on disk, and it says so
    assert "recordings" in found["message"]
    scores = [one["score"] for one in found["gestures"]]
    assert scores == sorted(scores, reverse=True)
    suggested = signed_in.good("POST", "/controls/suggest")
    assert suggested["parameters"]["bindings"] == found["suggestion"]["bindings"] == suggested["suggested"]["bindings"]
    assert suggested["parameters"]["gestures"] == found["suggestion"]["gestures"]


WITH_A_JOINER = "\U0001f469\u200d\U0001f9bd slow"  # a woman in a wheelchair: names of before could hold any character


def change_saved(clinic: Any, **settings: Any) -> None:
    clinic.good("GET", "/controls")
    with clinic.database.transaction() as db:
        for row in db.scalars(select(ParameterSet)):
            row.settings = {**row.settings, **settings}


def test_a_title_that_could_not_be_typed_any_more_is_still_read(calibrated: Any) -> None:
    change_saved(calibrated, title=WITH_A_JOINER)
    controls = calibrated.good("GET", "/controls")
    assert controls["parameters"]["title"] == WITH_A_JOINER
    calibrated.good("PUT", "/equipment/unused", json={"channels": []})


def test_a_set_that_cannot_be_read_is_a_sentence_and_keeps_nobody_from_anything_else(calibrated: Any) -> None:
    change_saved(calibrated, of_another_program=1)
    assert "another version" in calibrated.refused(409, "GET", "/controls")
    calibrated.good("PUT", "/equipment/unused", json={"channels": []})
    session = calibrated.parts[SessionFlow]
    calibrated.client.portal.call(session.session_changed)  # as at the start of the program
    assert session.loaded is None
