"""Drives of the real chair: what is read before arming, what refuses it, who may hold it, how it ends."""

import time
from typing import Any

import pytest
from fake_clinic import WORD, Clinic

from app.api.routes import drives
from app.faults import Fault, State
from app.hardware.chair.reasons import WORDS, Reason
from app.hardware.registry import NO_KEY
from app.speeds import Speeds
from app.store.people import add_person, sign_in, the_clinic
from app.store.tables import Parameters

SLOW = {**Speeds().model_dump(), "forward": 0.5}
ARMED, FAULT = 2, 3  # of a chair's telemetry


@pytest.fixture(autouse=True)
def _patient_with_this_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drives, "HEARD_WITHIN", 60.0)


@pytest.fixture
def calibrated(signed_in: Clinic) -> Any:
    signed_in.patient = signed_in.visit()  # type: ignore[attr-defined]
    signed_in.calibrate()
    plan = signed_in.good("GET", "/floorplans/apartment")
    signed_in.where = {  # type: ignore[attr-defined]
        "floorplan": plan["name"],
        "path": plan["paths"][0]["name"],
        "screen": WORD,
    }
    velocity(signed_in)
    return signed_in


@pytest.fixture
def ready(calibrated: Any) -> Any:
    """A chair that is chosen, and a set that was practised."""
    practise(calibrated)
    choose_chair(calibrated)
    return calibrated


def velocity(clinic: Any, **changed: Any) -> Any:
    now = clinic.good("GET", "/controls")["parameters"]
    names = ("gestures", "bindings", "mode_u1", "mode_u2", "cutoff", "speeds", "cruise_time", "title")
    wanted = {**{name: now[name] for name in names}, "mode_u1": "velocity", **changed}
    return clinic.good("PUT", "/controls", json=wanted)


def practise(clinic: Any) -> Any:
    clinic.good("POST", "/trials", json=clinic.where)
    return clinic.good("POST", "/trials/current/end", json={"reason": "by hand"})


def choose_chair(clinic: Any) -> Any:
    chair = {"name": "Blue", "host": "10.0.0.7", "port": 5354, "speeds": SLOW}
    chairs = clinic.good("POST", "/chairs", json=chair)["chairs"]
    return clinic.good("PUT", "/chairs/chosen", json={"id": chairs[-1]["id"], "dynamics": "unicycle"})


def arm(clinic: Any, **headers: str) -> Any:
    digest = clinic.good("GET", "/drives/summary")["parameters"]["hash"]
    return clinic("POST", "/drives", json={"hash": digest, "screen": WORD}, headers=headers)


def test_before_anybody_is_here_there_is_nothing_to_arm(signed_in: Clinic) -> None:
    summary = signed_in.good("GET", "/drives/summary")
    assert (summary["chair"], summary["parameters"], summary["speeds"]) == (None, None, None)
    assert summary["practised"] == {"trials": 0, "last": None}
    assert [sentence.split(":")[0] for sentence in summary["refusals"]] == [
        "Nobody is here",
        "The virtual chair is chosen",
    ]
    signed_in.visit()
    assert signed_in.good("GET", "/drives/summary")["refusals"][0].startswith("Nothing is calibrated yet")


def test_the_summary_is_what_would_apply(ready: Any) -> None:
    ready.good("POST", "/control/dial", json={"share": 0.5})
    ready.good("PUT", "/limits", json={**Speeds().model_dump(), "turn": 0.8})
    summary = ready.good("GET", "/drives/summary")
    assert summary["chair"]["name"] == "Blue"
    assert summary["parameters"]["mode_u1"] == "velocity"
    assert summary["parameters"]["cruise_time"] == 10.0
    assert (summary["speeds"]["forward"], summary["speeds"]["turn"]) == (0.25, 0.4)  # chair, clinic, half of both
    assert summary["practised"]["trials"] == 1
    assert summary["last_practised"]["hash"] == summary["parameters"]["hash"]
    assert (summary["differences"], summary["refusals"]) == ([], [])


def test_what_was_not_practised_is_not_armed_and_the_differences_are_said(ready: Any) -> None:
    faster = {**Speeds().model_dump(), "forward": 1.0}
    digest = velocity(ready, speeds=faster, cutoff=4.0)["hash"]
    summary = ready.good("GET", "/drives/summary")
    assert summary["differences"] == ["Tremor damping: 3.0 → 4.0 Hz.", "Forward speed: 0.80 → 1.00 m/s."]
    assert "never practised" in summary["refusals"][0]
    with ready.screen():
        assert arm(ready).status_code == 409
    assert "arm" not in [do for do, _ in ready.process.calls if do == "arm"][1:]
    ready.good("PUT", "/chairs/chosen", json={"id": None, "dynamics": "unicycle"})
    trial = practise(ready)
    summary = ready.good("GET", "/drives/summary")
    assert (summary["practised"]["trials"], summary["parameters"]["hash"]) == (1, digest)
    ready.good("POST", f"/trials/{trial['id']}/discard", json={"reason": "tired"})
    assert ready.good("GET", "/drives/summary")["practised"]["trials"] == 0


def test_a_hash_that_was_stored_by_an_older_program_counts_as_it_is_reckoned_now(ready: Any) -> None:
    with ready.client.app.state.people.database.transaction() as db:
        for row in db.query(Parameters):
            row.hash = "0" * 64
            row.settings = {name: value for name, value in row.settings.items() if name != "cruise_time"}
    summary = ready.good("GET", "/drives/summary")
    assert summary["practised"]["trials"] == 1
    assert summary["parameters"]["hash"] == ready.good("GET", "/controls")["hash"] != "0" * 64
    with ready.screen():
        assert arm(ready).status_code == 201
    assert ready.process.calls[-1] == ("arm", {"hash": summary["parameters"]["hash"]})


@pytest.mark.parametrize(
    ("says", "words"),
    [
        ({"chair_age": 0.5}, "does not answer"),
        ({"chair_age": float("nan")}, "does not answer"),
        ({"chair_age": float("inf")}, "does not answer"),
        ({"stop_input": 1}, "stop switch"),
        ({"chair_state": FAULT, "chair_fault": Reason.OUTPUT}, WORDS[Reason.OUTPUT]),
        ({"chair_state": FAULT, "chair_fault": 99}, "does not know"),
    ],
)
def test_a_chair_that_cannot_drive_is_not_armed(ready: Any, says: dict[str, Any], words: str) -> None:
    ready.process.says = says
    assert words in ready.good("GET", "/drives/summary")["refusals"][0]
    with ready.screen():
        answer = arm(ready)
    assert answer.status_code == 409
    assert words in answer.json()["detail"]
    assert ready.good("GET", f"/drives?patient={ready.patient['id']}") == []


def test_a_chosen_chair_that_is_not_open_is_not_taken_for_the_virtual_one(ready: Any) -> None:
    ready.process.chair = "virtual"
    assert ready.good("GET", "/drives/summary")["refusals"] == ["Blue is not open: choose it again."]
    assert ready("POST", "/trials", json=ready.where).status_code == 409


def test_acceleration_mode_needs_the_stop_switch(calibrated: Any) -> None:
    velocity(calibrated, mode_u1="acceleration")
    practise(calibrated)
    choose_chair(calibrated)
    assert "stop switch" in calibrated.good("GET", "/drives/summary")["refusals"][0]
    calibrated.process.switch_seen = True
    assert calibrated.good("GET", "/drives/summary")["refusals"] == []


def test_a_shirt_that_cannot_be_trusted_arms_no_real_chair_and_the_page_says_why(ready: Any) -> None:
    """Safety S29: in a demonstration, too."""
    ready.web.equipment.mistrust = NO_KEY
    assert ready.good("GET", "/drives/summary")["refusals"] == [NO_KEY]
    with ready.screen():
        answer = arm(ready)
    assert (answer.status_code, answer.json()["detail"]) == (409, NO_KEY)
    ready.process.mistrust = ""
    ready.good("PUT", "/equipment/shirt", json={"kind": "simulator"})
    assert ready.good("GET", "/drives/summary")["refusals"] == []


@pytest.mark.parametrize(
    "header", ["Forwarded", "X-Forwarded-For", "X-Forwarded-Proto", "Via", "X-Real-IP", "x-forwarded-host"]
)
def test_nobody_arms_from_outside(ready: Any, header: str) -> None:
    with ready.screen():
        answer = arm(ready, **{header: "127.0.0.1"})
        assert (answer.status_code, "in the building" in answer.json()["detail"]) == (403, True)
        assert arm(ready).status_code == 201
        ready.good("POST", "/control/stop")
        outside = ready("POST", "/control/clear", json={"stops": 1}, headers={header: "127.0.0.1"})
        assert outside.status_code == 403
        assert ready("POST", "/control/dial", json={"share": 0.5}, headers={header: "1"}).status_code == 403
        assert ready("POST", "/control/stop", headers={header: "127.0.0.1"}).status_code == 200
        assert ready.good("POST", "/control/clear", json={"stops": 2})["state"] == "armed"


def test_a_screen_that_was_not_heard_does_not_arm(ready: Any) -> None:
    answer = arm(ready)
    assert (answer.status_code, "in view" in answer.json()["detail"]) == (409, True)
    with ready.screen("another-screen"):
        assert arm(ready).status_code == 409


def test_the_hash_that_was_read_is_the_one_that_is_armed(ready: Any) -> None:
    with ready.screen():
        answer = ready("POST", "/drives", json={"hash": "0" * 64, "screen": WORD})
    assert (answer.status_code, "changed meanwhile" in answer.json()["detail"]) == (409, True)


def test_a_drive_from_arming_to_its_end(ready: Any) -> None:
    digest = ready.good("GET", "/drives/summary")["parameters"]["hash"]
    with ready.screen():
        drive = arm(ready).json()
        assert (drive["ended"], drive["end"], drive["hash"]) == (None, None, digest)
        run = next(fields for do, fields in reversed(ready.process.calls) if do == "run")
        assert (run["kind"], run["meta"]) == ("drive", {"chair": "Blue", "key_id": 1, "hash": digest})
        assert ready.process.calls[-1] == ("arm", {"hash": digest})
        assert ready("POST", "/drives", json={"hash": digest, "screen": WORD}).status_code == 409
        assert ready("POST", "/trials", json=ready.where).status_code == 409
        assert ready("PUT", "/chairs/chosen", json={"id": None, "dynamics": "unicycle"}).status_code == 409
        assert ready("DELETE", "/visit").status_code == 409
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
    assert not ready.web.real.running


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
    database = ready.client.app.state.people.database
    with database.transaction() as db:
        other = sign_in(db, add_person(db, the_clinic(db), "Other", "clinician", None), "test")
    with ready.screen():
        arm(ready)
        mine = ready.client.cookies["bodydrive_session"]
        ready.client.cookies.clear()
        assert ready.good("POST", "/control/stop")["state"] == "fault"
        ready.client.cookies["bodydrive_session"] = other
        for path, body in (
            ("/control/clear", {"stops": 1}),
            ("/control/dial", {"share": 0.5}),
            ("/drives/current/end", None),
        ):
            answer = ready("POST", path, json=body)
            assert (answer.status_code, "Somebody else" in answer.json()["detail"]) == (409, True), path
        assert ready.good("POST", "/control/stop")["state"] == "fault"
        ready.client.cookies.clear()
        ready.client.cookies["bodydrive_session"] = mine
        assert ready("POST", "/control/clear", json={"stops": 1}).status_code == 409  # there was a second stop
        while not any(row.what == "stop" for row in ready.log()):
            time.sleep(0.01)
        assert ready.good("POST", "/control/clear", json={"stops": 2})["state"] == "armed"
        ready.good("POST", "/drives/current/end")
    assert [row.details["fault"] for row in ready.log() if row.what == "stop"] == ["stop_tablet"]


def test_the_live_picture_shows_what_the_chair_says(ready: Any) -> None:
    ready.process.says = {
        "chair_state": ARMED,
        "chair_age": 0.08,
        "battery": float("nan"),
        "driven_v": 0.3,
        "driven_omega": -0.1,
        "stop_input": 0,
    }
    picture = ready.web.live._picture()
    assert picture["chair"] == {
        "kind": "udp",
        "state": "armed",
        "age": 0.08,
        "battery": None,
        "stop_input": False,
        "v": 0.3,
        "omega": -0.1,
        "words": "",
    }
    assert picture["drive"] is None
    with ready.screen():
        drive = arm(ready).json()
        while not (shown := ready.web.live._picture()["drive"]) or shown["t"] == 0.0:
            time.sleep(0.01)
        assert shown["id"] == drive["id"]
    ready.process.says = {"chair_state": FAULT, "chair_fault": Reason.STOP_INPUT}
    assert ready.web.live._picture()["chair"]["words"] == WORDS[Reason.STOP_INPUT]
    ready.process.chair = "virtual"
    assert ready.web.live._picture()["chair"]["words"] == "Blue is not open: choose it again."
