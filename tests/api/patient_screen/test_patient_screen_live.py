"""The live socket of the patient's screen: its messages, and that it carries out no command."""

from typing import Any

import pytest
from api.fake_clinic import WORD, Clinic, next_message
from api.pairing import closing

from app.api.live.screens import Screens
from app.api.patient_screen import patient_socket
from app.api.patient_screen.patient_picture import PatientPicture
from app.store.patient_screens import ScreenSettings


def test_it_tells_of_nobody(paired: Clinic) -> None:
    with paired.socket("/patient/live") as socket:
        text = socket.receive_text()
    for word in ("P-1", "Heron", "patient_id", "values", "score", "Demo"):
        assert word not in text


def test_a_trial_is_shown_with_what_to_do_and_how_it_ended(paired: Clinic) -> None:
    paired.calibrate()
    path = paired.good("GET", "/floorplans/apartment")["paths"][0]
    with paired.socket("/patient/live") as socket:
        assert socket.receive_json()["trial"] is None
        paired.start_trial()
        message = next_message(socket, lambda m: m["trial"] is not None)
        trial = message["trial"]
        assert set(trial) == {"id", "t", "done", "length", "stage", "stages", "instruction", "target", "movers"}
        assert trial["instruction"] == path["instruction"]
        assert len(trial["target"]) == 2
        assert message["drives"] is True
        paired.good("POST", "/control/stop")
        message = next_message(socket, lambda m: m["fault"] is not None)
        assert message["fault"] == {"name": "stop_tablet", "message": "Stop was pressed on a clinician's page."}
        assert message["waits"] == {"for": "clinician", "message": "We wait for your clinician to look and to go on."}
        paired.good("POST", "/trials/current/end", json={})
        assert next_message(socket, lambda m: m["trial"] is None)["over"] == {"id": trial["id"], "end": "by hand"}


def test_a_prompt_of_the_calibration_is_a_cue(paired: Clinic) -> None:
    process = paired.process
    since = process.since
    step = next(step for step in paired.good("GET", "/calibration")["steps"] if step["joint"] == "right_elbow")

    def cued(number: int) -> Any:
        ticks = since(number)
        ticks["cue"] = 1 if process.run else -1
        return ticks

    process.since = cued  # type: ignore[assignment,method-assign]
    with paired.socket("/patient/live") as socket:
        assert socket.receive_json()["cue"] is None
        paired.good("POST", f"/calibration/steps/{step['id']}/start")
        process.run_t = step["cues"][1]["start"] + 0.25
        cue = next_message(socket, lambda m: m["cue"] is not None and m["cue"]["t"] >= 0)["cue"]
        move = {"index": 1, "kind": "move", "movement": "Bend your right elbow", "next": "return"}
        assert cue == {**move, "t": 0.25, "length": 1.0}
        paired.good("POST", f"/calibration/steps/{step['id']}/cancel")


def test_what_the_clinician_asks_for_is_shown_and_kept_for_the_session(paired: Clinic) -> None:
    wishes = {"arrow": True, "sounds": False, "large": True, "plan": False, "language": None}
    with paired.socket("/patient/live") as socket:
        asked = {"arrow": False, "sounds": False, "large": False, "plan": False, "language": None}
        assert socket.receive_json()["asks"] == asked
        assert paired.good("POST", "/patient-screen/settings", json=wishes)["settings"] == wishes
        next_message(socket, lambda m: m["asks"] == wishes)
    paired.parts[PatientPicture].settings = ScreenSettings()  # as after a restart
    with paired.socket("/patient/live") as socket:
        assert socket.receive_json()["asks"] == wishes
    assert paired("POST", "/patient-screen/settings", json={"arrow": "yes"}).status_code == 422
    paired.open_session(paired.add_patient("P-2"))
    assert paired.good("GET", "/patient-screen")["settings"]["arrow"] is False


def test_nothing_it_says_is_acted_on_and_a_flood_is_cut_off(screen: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    before = len(screen.process.calls)
    with screen.socket("/patient/live") as socket:
        for message in ({"stop": True}, {"move": {"right_elbow": 1}}, {"look": {"yaw": 1}}):
            socket.send_json(message)
        socket.send_bytes(b"\x00" * 100)
        for _ in range(5):
            assert socket.receive_json()["state"] == "disarmed"
        for _ in range(patient_socket.FLOOD):
            socket.send_text("x")
        assert closing(socket) == 1008
    assert "stop" not in [do for do, _ in screen.process.calls[before:]]
    assert [do for do, _ in screen.process.told if do in {"move", "look"}] == []
    monkeypatch.setattr(patient_socket, "WITHIN", -1.0)
    with screen.socket("/patient/live") as socket:
        for _ in range(2 * patient_socket.FLOOD):
            socket.send_text("x")  # slow enough to be no flood
        for _ in range(3):
            socket.receive_json()


def test_it_is_not_the_screen_that_must_stay_in_view(screen: Clinic) -> None:
    with screen.socket("/patient/live") as socket:
        socket.send_json({"screen": WORD, "visible": True, "silence": 0.0})
        socket.receive_json()
        assert screen.parts[Screens]._signs == {}
