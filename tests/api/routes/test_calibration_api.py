"""The calibration of the open session, as its page goes through it."""

import threading
import time
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest
from api.fake_clinic import WHERE, Clinic
from api.fake_process import JOINTS, profile_for
from api.running_app import running

from app.calibration.script import calibration_script
from app.session.calibration import calibration_flow
from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.equipment.shirt import Equipment
from app.settings import Settings
from app.store.tables import CalibrationStep, PatientSession


def test_without_a_patient_there_is_nothing_to_calibrate(signed_in: Any) -> None:
    nothing = {"patient": None, "session": None, "has_profile": False, "consents_to_recording": False}
    assert signed_in.good("GET", "/session") == nothing | {"steps_done": [], "obstacle": None}
    assert "choose a patient" in signed_in.refused(409, "GET", "/calibration")


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


def test_the_wizard_goes_from_rest_to_a_saved_profile(in_session: Any) -> None:
    wizard = in_session.good("GET", "/calibration")
    assert [step["kind"] for step in wizard["steps"]] == ["rest", "free"] + ["prompt"] * 4 + ["result"]
    labels = ["Right elbow", "Left elbow", "Right shoulder", "Left shoulder"]
    assert [step["label"] for step in wizard["steps"]] == ["Rest", "Move freely", *labels, "Result"]
    assert (wizard["current"], wizard["result"], wizard["running"]) == ("rest", None, None)
    assert in_session("GET", "/controls").status_code == 409
    assert in_session("POST", "/calibration/accept").status_code == 409

    started = in_session.good("POST", "/calibration/steps/rest/start")
    assert started["running"] == {"step": "rest", "started_run": 1}
    assert started["steps"][0]["status"] == "running"
    assert in_session("POST", "/calibration/steps/free/start").status_code == 409
    assert in_session("DELETE", "/session").status_code == 409
    wizard = in_session.end_step()
    assert (wizard["current"], wizard["steps"][0]["status"]) == ("free", "done")
    assert in_session.good("GET", "/session")["steps_done"] == ["rest"]

    wizard = in_session.calibrate()
    assert [joint["name"] for joint in wizard["result"]["joints"]] == list(JOINTS)
    assert (wizard["current"], wizard["result"]["accepted"]) == ("result", True)
    assert {step["status"] for step in wizard["steps"]} == {"done"}
    assert in_session.good("GET", "/session")["has_profile"] is True
    assert in_session.process.parameters["profile"]["joints"][0]["name"] == "right_elbow"
    assert in_session("POST", "/calibration/accept").status_code == 409


def test_a_step_whose_signals_do_not_follow_the_cue_is_judged_as_it_ends(in_session: Any) -> None:
    advice = "The prompted movements point both ways (51 % of them one way): repeat them in time with the cue."
    in_session.readings["advice"] = {"prompt-right_elbow": advice}
    wizard = in_session.record("rest", "free", "prompt-right_elbow")
    judged = next(one for one in wizard["steps"] if one["id"] == "prompt-right_elbow")
    assert (judged["status"], judged["message"]) == ("done", advice)
    assert wizard["current"] == "prompt-right_elbow"  # nobody is made to move on
    in_session.readings["advice"] = {}
    wizard = in_session.record("prompt-right_elbow")
    judged = next(one for one in wizard["steps"] if one["id"] == "prompt-right_elbow")
    assert (judged["status"], judged["message"]) == ("done", "")


def test_the_words_of_the_steps_are_those_of_the_result(in_session: Any) -> None:
    def profile(layout: Any) -> Any:
        found = profile_for(layout)
        joints = tuple(
            joint.model_copy(update={"grade": "repeat", "reason": ("Repeat it larger.",)} if not number else {})
            for number, joint in enumerate(found.joints)
        )
        return found.model_copy(update={"joints": joints})

    in_session.readings["profile"] = profile
    wizard = in_session.calibrate()
    said = {step["joint"]: step["message"] for step in wizard["steps"] if step["kind"] == "prompt"}
    assert said == {joint: "Repeat it larger." if joint == JOINTS[0] else "" for joint in JOINTS}


def test_the_last_step_stays_shown_when_it_has_to_be_repeated_and_the_result_is_there(in_session: Any) -> None:
    steps = [step["id"] for step in in_session.good("GET", "/calibration")["steps"][:-1]]
    in_session.readings["advice"] = {steps[-1]: "Repeat it larger."}
    wizard = in_session.record(*steps)
    assert (wizard["current"], wizard["result"] is None) == (steps[-1], False)


def test_a_step_can_be_cancelled_repeated_and_fail_in_words(in_session: Any) -> None:
    in_session.good("POST", "/calibration/steps/rest/start")
    wizard = in_session.good("POST", "/calibration/steps/rest/cancel")
    assert (wizard["running"], wizard["steps"][0]["status"]) == (None, "waiting")
    assert in_session.process.run == 0
    assert in_session("POST", "/calibration/steps/rest/cancel").status_code == 409
    assert in_session("POST", "/calibration/steps/nonsense/start").status_code == 404
    in_session.readings["judge"] = "The shirt was silent for 2.0 seconds: repeat this step."
    wizard = in_session.record("rest")
    assert (wizard["steps"][0]["status"], wizard["current"]) == ("failed", "rest")
    assert "silent" in wizard["steps"][0]["message"]
    in_session.readings["judge"] = None
    in_session.calibrate()
    in_session.record("rest")
    wizard = in_session.until("/calibration", lambda c: c["result"] and not c["result"]["accepted"])
    assert [step["status"] for step in wizard["steps"]].count("done") == 7


def test_a_step_whose_recording_is_being_checked_is_over_once_its_cancel_is_answered(
    in_session: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whoever is told that nothing is left to cancel can end the session."""
    checking, checked = threading.Event(), threading.Event()

    def check(_folder: Any, _duration: float) -> None:
        checking.set()
        checked.wait()

    monkeypatch.setattr(calibration_flow, "check_recording", check)
    in_session.good("POST", "/calibration/steps/rest/start")
    in_session.process.run_t = 1000.0
    checking.wait()
    with ThreadPoolExecutor(1) as other:
        cancelled = other.submit(in_session, "POST", "/calibration/steps/rest/cancel")
        try:
            assert "Wait for its end" in in_session.refused(409, "DELETE", "/session")
            assert not cancelled.done()
        finally:
            checked.set()
        assert cancelled.result().status_code == 409
    assert in_session.good("GET", "/calibration")["steps"][0]["status"] == "done"
    assert in_session.good("DELETE", "/session")["patient"] is None


@pytest.mark.parametrize("looked_at", [None, "prompt-right_shoulder"])
def test_after_a_step_out_of_order_no_other_one_is_shown(in_session: Any, looked_at: str | None) -> None:
    """The page starts by itself only an unfinished step that is shown: nobody is made to move unasked."""
    in_session.good("POST", "/calibration/steps/prompt-left_elbow/start")
    if looked_at is not None:
        in_session.good("POST", "/calibration/go", json={"step": looked_at})
    wizard = in_session.end_step()
    assert [step["id"] for step in wizard["steps"] if step["status"] == "done"] == ["prompt-left_elbow"]
    assert wizard["current"] == "prompt-left_elbow"
    assert in_session.record("rest")["current"] == "free"  # the first one that was missing
    assert in_session.record("rest")["current"] == "rest"  # a repetition


def test_a_step_that_ends_while_it_is_looked_at_is_shown_as_running_or_as_ended(
    in_session: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    in_session.good("POST", "/calibration/steps/rest/start")
    script = calibration_script
    calls: list[Any] = []

    def end_the_step_first(layout: Any) -> Any:
        is_first = not calls
        calls.append(layout)
        in_session.process.run_t = 1000.0
        while is_first and in_session.parts[CalibrationFlow].running:
            time.sleep(0.01)
        return script(layout)

    monkeypatch.setattr(calibration_flow, "calibration_script", end_the_step_first)
    wizard = in_session.good("GET", "/calibration")
    assert (wizard["running"] is None) == (wizard["steps"][0]["status"] != "running")


def test_a_movement_that_a_body_cannot_make_is_skipped(in_session: Any) -> None:
    assert in_session("POST", "/calibration/steps/rest/skip").status_code == 409
    assert in_session("POST", "/calibration/steps/nonsense/skip").status_code == 404
    in_session.record("rest", "free", "prompt-right_elbow")
    for joint in ("left_elbow", "right_shoulder", "left_shoulder"):
        wizard = in_session.good("POST", f"/calibration/steps/prompt-{joint}/skip")
    assert [step["status"] for step in wizard["steps"]] == ["done"] * 3 + ["skipped"] * 3 + ["done"]
    assert (wizard["current"], wizard["running"]) == ("result", None)
    assert wizard["result"] is not None


def test_a_fit_that_fails_says_why(in_session: Any) -> None:
    in_session.readings["fit"] = "No joint moved: repeat the free movement."
    in_session.record(*(step["id"] for step in in_session.good("GET", "/calibration")["steps"][:-1]))
    wizard = in_session.until("/calibration", lambda c: c["steps"][-1]["status"] == "failed")
    assert wizard["steps"][-1]["message"] == "No joint moved: repeat the free movement."
    assert wizard["result"] is None


def test_a_step_fails_in_words_when_the_control_process_dies_and_the_next_one_is_loaded_again(in_session: Any) -> None:
    in_session.calibrate()
    in_session.good("POST", "/calibration/steps/rest/start")
    in_session.process.die()
    wizard = in_session.until("/calibration", lambda c: c["running"] is None)
    assert wizard["steps"][0]["status"] == "failed"
    assert "repeat" in wizard["steps"][0]["message"]
    in_session.until("/equipment", lambda e: e["status"]["control"] == "alive")
    assert len(in_session.processes) == 2
    assert [do for do, _ in in_session.process.calls[:5]] == ["limits", "chair", "shirt", "body", "parameters"]
    assert in_session.process.parameters["profile"]["joints"]


def test_a_restart_of_the_web_process_comes_back_to_the_same_step(settings: Settings, in_session: Any) -> None:
    in_session.record("rest")
    in_session.good("POST", "/calibration/go", json={"step": "prompt-left_elbow"})
    before = in_session.good("GET", "/calibration")
    token = in_session.client.cookies["bodydrive_sign_in"]
    for again in running(settings):
        again.client.cookies["bodydrive_sign_in"] = token
        assert again.good("GET", "/calibration") == before


def test_another_shirt_does_not_drive_with_this_calibration(in_session: Clinic) -> None:
    in_session.calibrate()
    in_session.parts[Equipment].sample_rate = 250.0
    obstacle = in_session.good("GET", "/controls")["obstacle"]
    assert ("calibrate again" in obstacle["message"], obstacle["page"]) == (True, "calibrate")
    assert in_session.good("GET", "/controls/obstacle") == obstacle  # for the Drive page, before anybody starts a trial
    assert in_session.refused(409, "POST", "/trials", json=WHERE) == obstacle["message"]
