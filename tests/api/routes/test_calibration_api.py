"""The calibration of the open session, as its page goes through it."""

import threading
import time
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from api.fake_clinic import JOINTS, WORD, Clinic, profile_for
from api.running_app import running

from app.calibration.script import calibration_script
from app.session.calibration import calibration_flow
from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.equipment.shirt import Equipment
from app.settings import Settings
from app.store.tables import CalibrationStep, PatientSession


def test_without_a_patient_there_is_nothing_to_calibrate(signed_in: Any) -> None:
    assert signed_in.good("GET", "/session") == {
        "patient": None,
        "session": None,
        "has_profile": False,
        "consents_to_recording": False,
        "steps_done": [],
        "obstacle": None,
    }
    answer = signed_in("GET", "/calibration")
    assert answer.status_code == 409
    assert "choose a patient" in answer.json()["detail"]


def test_to_look_at_the_calibration_begins_none(in_session: Any) -> None:
    """GET wrote the script of a session and a row for each step."""
    database = in_session.database
    session_id = in_session.good("GET", "/session")["session"]["id"]

    def stored() -> Any:
        with database.transaction() as db:
            session = db.get_one(PatientSession, session_id)
            return session.script, session.current_step, len(db.query(CalibrationStep).all())

    before = stored()
    shown = in_session.good("GET", "/calibration")
    assert {step["status"] for step in shown["steps"]} == {"waiting"}
    assert shown["current"] == shown["steps"][0]["id"]
    assert stored() == before == (None, None, 0)
    in_session.good("POST", "/calibration/go", json={"step": shown["steps"][1]["id"]})
    assert in_session.good("GET", "/calibration")["current"] == shown["steps"][1]["id"]
    assert stored()[2] == len(shown["steps"])


def test_the_wizard_goes_from_rest_to_a_saved_profile(signed_in: Any) -> None:
    signed_in.begin_session()
    wizard = signed_in.good("GET", "/calibration")
    assert [step["kind"] for step in wizard["steps"]] == ["rest", "free"] + ["prompt"] * 4 + ["result"]
    labels = ["Right elbow", "Left elbow", "Right shoulder", "Left shoulder"]
    assert [step["label"] for step in wizard["steps"]] == ["Rest", "Move freely", *labels, "Result"]
    assert (wizard["current"], wizard["result"], wizard["running"]) == ("rest", None, None)
    assert signed_in("GET", "/controls").status_code == 409
    assert signed_in("POST", "/calibration/accept").status_code == 409

    started = signed_in.good("POST", "/calibration/steps/rest/start")
    assert started["running"] == {"step": "rest", "started_run": 1}
    assert started["steps"][0]["status"] == "running"
    assert signed_in("POST", "/calibration/steps/free/start").status_code == 409
    assert signed_in("DELETE", "/session").status_code == 409
    signed_in.process.run_t = 1000.0
    wizard = signed_in.until("/calibration", lambda c: c["current"] == "free")
    assert wizard["steps"][0]["status"] == "done"
    assert signed_in.good("GET", "/session")["steps_done"] == ["rest"]

    wizard = signed_in.calibrate()
    assert [joint["name"] for joint in wizard["result"]["joints"]] == list(JOINTS)
    assert wizard["result"]["accepted"] is True
    assert wizard["current"] == "result"
    assert {step["status"] for step in wizard["steps"]} == {"done"}
    assert signed_in.good("GET", "/session")["has_profile"] is True
    assert signed_in.process.parameters["profile"]["joints"][0]["name"] == "right_elbow"
    assert signed_in("POST", "/calibration/accept").status_code == 409


def test_a_step_whose_signals_do_not_follow_the_cue_is_judged_as_it_ends(signed_in: Any) -> None:
    advice = "The prompted movements point both ways (51 % of them one way): repeat them in time with the cue."
    signed_in.begin_session()
    signed_in.readings["advice"] = {"prompt-right_elbow": advice}
    for step in ("rest", "free", "prompt-right_elbow"):
        signed_in.good("POST", f"/calibration/steps/{step}/start")
        signed_in.process.run_t += 1000.0
        signed_in.until("/calibration", lambda c: c["running"] is None)
    wizard = signed_in.good("GET", "/calibration")
    judged = next(one for one in wizard["steps"] if one["id"] == "prompt-right_elbow")
    assert (judged["status"], judged["message"]) == ("done", advice)
    assert wizard["current"] == "prompt-right_elbow"  # nobody is made to move on
    signed_in.readings["advice"] = {}
    signed_in.good("POST", "/calibration/steps/prompt-right_elbow/start")
    signed_in.process.run_t += 1000.0
    wizard = signed_in.until("/calibration", lambda c: c["running"] is None)
    judged = next(one for one in wizard["steps"] if one["id"] == "prompt-right_elbow")
    assert (judged["status"], judged["message"]) == ("done", "")


def test_the_words_of_the_steps_are_those_of_the_result(signed_in: Any) -> None:
    def profile(layout: Any) -> Any:
        found = profile_for(layout)
        joints = tuple(
            joint.model_copy(update={"grade": "repeat", "reason": "Repeat it larger."} if not number else {})
            for number, joint in enumerate(found.joints)
        )
        return found.model_copy(update={"joints": joints})

    signed_in.begin_session()
    signed_in.readings["profile"] = profile
    wizard = signed_in.calibrate()
    said = {step["joint"]: step["message"] for step in wizard["steps"] if step["kind"] == "prompt"}
    assert said == {joint: "Repeat it larger." if joint == JOINTS[0] else "" for joint in JOINTS}


def test_the_last_step_stays_shown_when_it_has_to_be_repeated_and_the_result_is_there(signed_in: Any) -> None:
    signed_in.begin_session()
    steps = [step["id"] for step in signed_in.good("GET", "/calibration")["steps"][:-1]]
    signed_in.readings["advice"] = {steps[-1]: "Repeat it larger."}
    for step in steps:
        signed_in.good("POST", f"/calibration/steps/{step}/start")
        signed_in.process.run_t += 1000.0
        signed_in.until("/calibration", lambda c: c["running"] is None)
    wizard = signed_in.good("GET", "/calibration")
    assert wizard["current"] == steps[-1]
    assert wizard["result"] is not None


def test_a_step_can_be_cancelled_repeated_and_fail_in_words(signed_in: Any) -> None:
    signed_in.begin_session()
    signed_in.good("POST", "/calibration/steps/rest/start")
    wizard = signed_in.good("POST", "/calibration/steps/rest/cancel")
    assert (wizard["running"], wizard["steps"][0]["status"]) == (None, "waiting")
    assert signed_in.process.run == 0
    assert signed_in("POST", "/calibration/steps/rest/cancel").status_code == 409
    assert signed_in("POST", "/calibration/steps/nonsense/start").status_code == 404
    signed_in.readings["judge"] = "The shirt was silent for 2.0 seconds: repeat this step."
    signed_in.good("POST", "/calibration/steps/rest/start")
    signed_in.process.run_t = 1000.0
    wizard = signed_in.until("/calibration", lambda c: c["running"] is None)
    assert (wizard["steps"][0]["status"], wizard["current"]) == ("failed", "rest")
    assert "silent" in wizard["steps"][0]["message"]
    signed_in.readings["judge"] = None
    signed_in.calibrate()
    signed_in.good("POST", "/calibration/steps/rest/start")
    signed_in.process.run_t = 1000.0
    wizard = signed_in.until(
        "/calibration", lambda c: c["running"] is None and c["result"] and not c["result"]["accepted"]
    )
    assert [step["status"] for step in wizard["steps"]].count("done") == 7


def test_a_step_whose_recording_is_being_checked_is_over_once_its_cancel_is_answered(
    signed_in: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whoever is told that nothing is left to cancel can end the session."""
    checking, checked = threading.Event(), threading.Event()

    def check(_folder: Any, _duration: float) -> None:
        checking.set()
        checked.wait()

    monkeypatch.setattr(calibration_flow, "check_recording", check)
    signed_in.begin_session()
    signed_in.good("POST", "/calibration/steps/rest/start")
    signed_in.process.run_t = 1000.0
    checking.wait()
    with ThreadPoolExecutor(1) as other:
        cancelled = other.submit(signed_in, "POST", "/calibration/steps/rest/cancel")
        try:
            refused = signed_in("DELETE", "/session")
            assert (refused.status_code, "wait for its end" in refused.json()["detail"]) == (409, True)
            assert not cancelled.done()
        finally:
            checked.set()
        assert cancelled.result().status_code == 409
    assert signed_in.good("GET", "/calibration")["steps"][0]["status"] == "done"
    assert signed_in.good("DELETE", "/session")["patient"] is None


@pytest.mark.parametrize("looked_at", [None, "prompt-right_shoulder"])
def test_after_a_step_out_of_order_no_other_one_is_shown(signed_in: Any, looked_at: str | None) -> None:
    """The page starts by itself only an unfinished step that is shown: nobody is made to move unasked."""
    signed_in.begin_session()
    signed_in.good("POST", "/calibration/steps/prompt-left_elbow/start")
    if looked_at is not None:
        signed_in.good("POST", "/calibration/go", json={"step": looked_at})
    signed_in.process.run_t = 1000.0
    wizard = signed_in.until("/calibration", lambda c: c["running"] is None)
    assert [step["id"] for step in wizard["steps"] if step["status"] == "done"] == ["prompt-left_elbow"]
    assert wizard["current"] == "prompt-left_elbow"
    signed_in.good("POST", "/calibration/steps/rest/start")  # the first one that was missing
    signed_in.process.run_t = 1000.0
    assert signed_in.until("/calibration", lambda c: c["running"] is None)["current"] == "free"
    signed_in.good("POST", "/calibration/steps/rest/start")  # a repetition
    signed_in.process.run_t = 1000.0
    assert signed_in.until("/calibration", lambda c: c["running"] is None)["current"] == "rest"


def test_a_step_that_ends_while_it_is_looked_at_is_shown_as_running_or_as_ended(
    signed_in: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    signed_in.begin_session()
    signed_in.good("POST", "/calibration/steps/rest/start")
    script = calibration_script
    calls: list[Any] = []

    def end_the_step_first(layout: Any) -> Any:
        is_first = not calls
        calls.append(layout)
        signed_in.process.run_t = 1000.0
        while is_first and signed_in.parts[CalibrationFlow].running:
            time.sleep(0.01)
        return script(layout)

    monkeypatch.setattr(calibration_flow, "calibration_script", end_the_step_first)
    wizard = signed_in.good("GET", "/calibration")
    assert (wizard["running"] is None) == (wizard["steps"][0]["status"] != "running")


def test_a_movement_that_a_body_cannot_make_is_skipped(signed_in: Any) -> None:
    signed_in.begin_session()
    assert signed_in("POST", "/calibration/steps/rest/skip").status_code == 409
    assert signed_in("POST", "/calibration/steps/nonsense/skip").status_code == 404
    for step in ("rest", "free", "prompt-right_elbow"):
        signed_in.good("POST", f"/calibration/steps/{step}/start")
        signed_in.process.run_t = 1000.0
        signed_in.until("/calibration", lambda c: c["running"] is None)
    for joint in ("left_elbow", "right_shoulder", "left_shoulder"):
        wizard = signed_in.good("POST", f"/calibration/steps/prompt-{joint}/skip")
    assert [step["status"] for step in wizard["steps"]] == ["done"] * 3 + ["skipped"] * 3 + ["done"]
    assert (wizard["current"], wizard["running"]) == ("result", None)
    assert wizard["result"] is not None


def test_a_fit_that_fails_says_why(signed_in: Any) -> None:
    signed_in.begin_session()
    signed_in.readings["fit"] = "No joint moved: repeat the free movement."
    for step in signed_in.good("GET", "/calibration")["steps"][:-1]:
        signed_in.good("POST", f"/calibration/steps/{step['id']}/start")
        signed_in.process.run_t = 1000.0
        signed_in.until("/calibration", lambda c: c["running"] is None)
    wizard = signed_in.until("/calibration", lambda c: c["steps"][-1]["status"] == "failed")
    assert wizard["steps"][-1]["message"] == "No joint moved: repeat the free movement."
    assert wizard["result"] is None


def test_a_step_fails_in_words_when_the_control_process_dies_and_the_next_one_is_loaded_again(signed_in: Any) -> None:
    signed_in.begin_session()
    signed_in.calibrate()
    signed_in.good("POST", "/calibration/steps/rest/start")
    signed_in.process.die()
    wizard = signed_in.until("/calibration", lambda c: c["running"] is None)
    assert wizard["steps"][0]["status"] == "failed"
    assert "repeat" in wizard["steps"][0]["message"]
    signed_in.until("/equipment", lambda e: e["status"]["control"] == "alive")
    assert len(signed_in.processes) == 2
    assert [do for do, _ in signed_in.process.calls[:5]] == ["limits", "chair", "shirt", "body", "parameters"]
    assert signed_in.process.parameters["profile"]["joints"]


def test_a_restart_of_the_web_process_comes_back_to_the_same_step(settings: Settings, signed_in: Any) -> None:
    signed_in.begin_session()
    signed_in.good("POST", "/calibration/steps/rest/start")
    signed_in.process.run_t = 1000.0
    signed_in.until("/calibration", lambda c: c["current"] == "free")
    signed_in.good("POST", "/calibration/go", json={"step": "prompt-left_elbow"})
    before = signed_in.good("GET", "/calibration")
    token = signed_in.client.cookies["bodydrive_sign_in"]
    for again in running(settings):
        again.client.cookies["bodydrive_sign_in"] = token
        assert again.good("GET", "/calibration") == before


def test_another_shirt_does_not_drive_with_this_calibration(signed_in: Clinic) -> None:
    signed_in.begin_session()
    signed_in.calibrate()
    worn = signed_in.parts[Equipment]
    worn.sample_rate = 250.0
    obstacle = signed_in.good("GET", "/controls")["obstacle"]
    assert ("calibrate again" in obstacle["message"], obstacle["page"]) == (True, "calibrate")
    assert signed_in.good("GET", "/controls/obstacle") == obstacle  # for the Drive page, before anybody starts a trial
    plan = signed_in.good("GET", "/floorplans/apartment")
    answer = signed_in(
        "POST", "/trials", json={"floorplan": plan["name"], "path": plan["paths"][0]["name"], "screen": WORD}
    )
    assert (answer.status_code, answer.json()["detail"]) == (409, obstacle["message"])
