"""Drives of the real chair: from arming to the end, the controller, the live picture."""

import time
from typing import Any

import pytest
from api.fake_clinic import WHERE, WORD, arm

from app.api.live.live_picture import ClinicLive
from app.faults import Fault, State
from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from app.session.real_drive import RealDriveFlow

ARMED, FAULT = 2, 3  # of a chair's telemetry


def test_a_drive_from_arming_to_its_end(ready: Any) -> None:
    digest = ready.good("GET", "/drives/summary")["parameters"]["hash"]
    with ready.screen():
        drive = arm(ready).json()
        assert (drive["ended"], drive["end"], drive["hash"]) == (None, None, digest)
        run = next(fields for do, fields in reversed(ready.process.calls) if do == "run")
        assert (run["kind"], run["meta"]) == ("drive", {"chair": "Blue", "key_id": 1, "hash": digest})
        assert ready.process.calls[-1] == ("arm", {"hash": digest})
        assert ready("POST", "/drives", json={"hash": digest, "screen": WORD}).status_code == 409
        assert ready("POST", "/trials", json=WHERE).status_code == 409
        assert ready("PUT", "/chairs/chosen", json={"id": None, "dynamics": "unicycle"}).status_code == 409
        assert ready("DELETE", "/session").status_code == 409
        ended = ready.good("POST", "/drives/current/end")
    assert (ended["id"], ended["end"], ended["distance"]) == (drive["id"], "by hand", 1.0)
    assert ended["ended"] > ended["started"]
    assert ready.good("GET", f"/drives?patient={ready.patient['id']}") == [ended]
    assert ready("POST", "/drives/current/end").status_code == 409
    assert ready("GET", "/drives?patient=99").status_code == 404
    what = [row.what for row in ready.log() if row.details.get("drive") == drive["id"]]
    assert what == ["armed", "drive ended"]


def test_an_arming_that_the_control_process_refuses_leaves_no_drive(ready: Any) -> None:
    ready.process.refuse["arm"] = "The chair does not answer."
    with ready.screen():
        answer = arm(ready)
    assert (answer.status_code, answer.json()["detail"]) == (409, "The chair does not answer.")
    assert ready.process.run == 0
    assert ready.good("GET", f"/drives?patient={ready.patient['id']}") == []
    assert not ready.parts[RealDriveFlow].running


def test_a_fault_that_nobody_clears_ends_the_drive_and_is_in_the_log(
    ready: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.session.run_watch.HALT_LIMIT", 0.5)
    with ready.screen():
        drive = arm(ready).json()
        ready.process.state, ready.process.fault = State.FAULT, Fault.CHAIR_SILENT
        drives_now = ready.until(f"/drives?patient={ready.patient['id']}", lambda rows: rows[-1]["ended"])
    assert drives_now[-1]["end"] == "fault"
    rows = [(row.what, row.details) for row in ready.log()]
    assert ("fault", {"fault": "chair_silent", "drive": drive["id"]}) in rows
    assert ("drive ended", {"drive": drive["id"], "end": "fault"}) in rows


def test_a_control_process_that_dies_ends_the_drive(ready: Any) -> None:
    with ready.screen():
        arm(ready)
        ready.process.die()
        drives_now = ready.until(f"/drives?patient={ready.patient['id']}", lambda rows: rows[-1]["ended"])
    assert drives_now[-1]["end"] == "fault"


def test_only_who_armed_goes_on_and_ends_and_anybody_stops(ready: Any) -> None:
    with ready.screen():
        arm(ready)
        with ready.as_person({}):
            assert ready.good("POST", "/control/stop")["state"] == "fault"
        with ready.as_person(ready.cookies_of("Other")):
            for path, body in (
                ("/control/clear", {"stops": 1}),
                ("/control/dial", {"share": 0.5}),
                ("/drives/current/end", None),
            ):
                assert "Somebody else" in ready.refused(409, "POST", path, json=body)
            assert ready.good("POST", "/control/stop")["state"] == "fault"
        assert ready("POST", "/control/clear", json={"stops": 1}).status_code == 409  # there was a second stop
        while not any(row.what == "stop" for row in ready.log()):
            time.sleep(0.01)
        assert ready.good("POST", "/control/clear", json={"stops": 2})["state"] == "armed"
        ready.good("POST", "/drives/current/end")
    assert [row.details["fault"] for row in ready.log() if row.what == "stop"] == ["stop_tablet"]


def test_the_live_picture_shows_what_the_chair_says(ready: Any) -> None:
    ready.process.says = {"chair_state": ARMED, "chair_age": 0.08, "battery": float("nan"), "stop_input": 0}
    ready.process.says |= {"driven_v": 0.3, "driven_omega": -0.1}
    picture = ready.parts[ClinicLive]._picture().model_dump()
    chair = {"kind": "udp", "state": "armed", "age": 0.08, "battery": None, "stop_input": False, "message": ""}
    assert picture["chair"] == {**chair, "v": 0.3, "omega": -0.1, "measured": False, "own_joystick": False}
    assert picture["drive"] is None
    with ready.screen():
        drive = arm(ready).json()
        while not (shown := ready.parts[ClinicLive]._picture().drive) or shown.t == 0.0:
            time.sleep(0.01)
        assert shown.id == drive["id"]
    ready.process.says = {"chair_state": FAULT, "chair_fault": Reason.OWN_JOYSTICK, "own_joystick": 1, "measured": 1}
    shown_chair = ready.parts[ClinicLive]._picture().chair
    assert (shown_chair.own_joystick, shown_chair.measured) == (True, True)
    assert str(shown_chair.message) == DESCRIPTIONS[Reason.OWN_JOYSTICK]
    ready.process.says = {"chair_state": FAULT, "chair_fault": Reason.STOP_INPUT}
    assert str(ready.parts[ClinicLive]._picture().chair.message) == DESCRIPTIONS[Reason.STOP_INPUT]
    ready.process.chair = "virtual"
    assert str(ready.parts[ClinicLive]._picture().chair.message) == "Blue is not open: choose it again."
