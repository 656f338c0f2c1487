"""Nobody drives blind: a trial begins and continues only while every screen for driving has a picture (S24)."""

import time
from typing import Any

import pytest
from api.fake_clinic import WORD, until
from api.pairing import code_of, pair
from clinic_rows import plan_at

from app.api.live.driving_screen import DrivingScreen
from app.api.live.screen_pictures import ScreenPictures
from app.api.live.screens import Screen
from app.api.patient_screen import patient_socket
from app.session.trial import TrialFlow

PLACE = plan_at("follow_me.easy")  # somebody walks ahead
WHERE = {"floorplan": PLACE.name, "path": PLACE.paths[0].name, "screen": WORD, "picture": "view"}


@pytest.fixture
def ready(calibrated: Any) -> Any:
    assert pair(calibrated, code_of(calibrated)).status_code == 200
    return calibrated


def until_state(clinic: Any, state: str) -> Any:
    """Wait until the state is this one, and return the fault."""
    while (tick := clinic.process.since(0)[-1], clinic.process.state.name.lower())[1] != state:
        time.sleep(0.002)
    return int(tick["fault"]) and clinic.process.fault.name


def says(socket: Any, picture: str) -> None:
    socket.send_json({"screen": WORD, "visible": True, "silence": 0.0, "picture": picture})


def until_said(clinic: Any, refused: bool) -> None:
    """Wait until the server has received the reports of the screens."""
    said = clinic.parts[ScreenPictures]._screens
    until(lambda: any(picture == "none" for _, picture in said.values()) is refused)


def test_a_screen_without_a_picture_starts_no_trial(ready: Any) -> None:
    assert "drives blind" in ready.refused(409, "POST", "/trials", json={**WHERE, "picture": "none"})
    with ready.screen() as socket:
        says(socket, "none")
        until_said(ready, True)
        for picture in ("view", "plan", None):  # what the screen itself says counts more than the request
            assert ready("POST", "/trials", json={**WHERE, "picture": picture}).status_code == 409
        assert ready.good("GET", "/trials?patient=1") == []
        says(socket, "plan")
        until_said(ready, False)
        ready.start_trial(**{**WHERE, "picture": "plan"})
    armed = next(row for row in ready.log() if row.what == "armed")
    assert armed.details["picture"] == "plan"
    assert ready("POST", "/trials", json={**WHERE, "picture": "eye"}).status_code == 422


def test_what_a_dead_socket_said_last_does_not_count_when_another_speaks_for_the_screen(ready: Any) -> None:
    pictures = ready.parts[ScreenPictures]
    screen = Screen(1, WORD)
    ready.client.portal.call(pictures.of_screen, screen, "none", "dead")
    assert pictures.refusal(screen)
    ready.client.portal.call(pictures.of_screen, screen, "view", "alive")
    assert pictures.refusal(screen) is None
    ready.client.portal.call(pictures.of_screen, Screen(1, "another-screen"), "none", "other")
    ready.client.portal.call(pictures.forget, "dead")
    assert pictures.refusal(screen) is None
    ready.client.portal.call(pictures.forget, "other")
    ready.client.portal.call(pictures.of_screen, screen, "none", "alive")
    assert pictures.refusal(screen)


def test_a_picture_lost_in_a_trial_halts_it_until_there_is_one_again(ready: Any) -> None:
    with ready.screen() as socket, ready.screen("of-somebody-who-looks") as other:
        says(socket, "view")
        ready.start_trial(**WHERE)
        other.send_json({"screen": "of-somebody-who-looks", "visible": True, "silence": 0.0, "picture": "none"})
        until_said(ready, True)
        assert until_state(ready, "armed") == 0  # a screen that only looks stops nobody
        says(socket, "none")
        assert until_state(ready, "fault") == "PICTURE_LOST"
        assert "drawn plan" in ready.refused(409, "POST", "/control/clear", json={"stops": ready.process.stops})
        stops = ready.process.stops
        says(socket, "none")
        says(socket, "plan")
        trial = ready.parts[TrialFlow].current
        until(lambda: not ready.parts[ScreenPictures].refusal(Screen(trial.person_id, trial.screen)))
        assert ready.process.stops == stops  # what stands is not stopped again
        assert ready.good("POST", "/control/clear", json={"stops": stops})["state"] == "armed"


def test_a_late_picture_halts_nothing_and_is_told_as_a_slow_screen(ready: Any) -> None:
    with ready.screen() as socket:
        says(socket, "view")
        ready.start_trial(**WHERE)
        assert ready.parts[DrivingScreen].sign().view == "in view"
        says(socket, "late")
        until(lambda: ready.parts[DrivingScreen].sign().view == "slow")
        assert ready.process.state.name == "ARMED"  # the control process pauses it
        ready.good("POST", "/control/stop")
        assert "no picture" in ready.refused(409, "POST", "/control/clear", json={"stops": ready.process.stops})
        says(socket, "view")
        until(lambda: ready.parts[DrivingScreen].sign().view == "in view")
        assert ready.good("POST", "/control/clear", json={"stops": ready.process.stops})["state"] == "armed"
        ready.end_trial()
        says(socket, "late")
        until(lambda: ready.parts[ScreenPictures].is_late(Screen(1, WORD)))
        assert ready("POST", "/trials", json=WHERE).status_code == 409


def test_going_on_between_two_words_of_a_screen_halts_again(ready: Any) -> None:
    with ready.screen() as socket:
        ready.start_trial(**WHERE)
        says(socket, "none")
        assert until_state(ready, "fault") == "PICTURE_LOST"
        ready.process.state = type(ready.process.state).ARMED
        says(socket, "none")
        assert until_state(ready, "fault") == "PICTURE_LOST"


def test_the_patients_screen_tells_the_clinicians_page_and_halts_too(ready: Any) -> None:
    def shown() -> Any:
        return ready.good("GET", "/patient-screen")["screens"][0]["picture"]

    def shows(socket: Any, picture: str) -> None:
        socket.send_json({"picture": picture})
        until(lambda: shown() == picture)

    with ready.socket("/patient/live") as socket:
        for junk in ('{"picture": "eye"}', "{", '{"picture": "none", "screen": 1}', "x" * 400):
            socket.send_text(junk)
        assert shown() is None
        shows(socket, "none")
        assert "patient's screen" in ready.refused(409, "POST", "/trials", json=WHERE)
        shows(socket, "plan")
        ready.start_trial(**WHERE)
        socket.send_json({"picture": "none"})
        assert until_state(ready, "fault") == "PICTURE_LOST"
        shows(socket, "view")
        ready.good("POST", "/control/clear", json={"stops": ready.process.stops})
    assert until_state(ready, "fault") == "PICTURE_LOST"  # it is gone, and the patient sees nothing any more
    assert "out of reach" in ready.refused(409, "POST", "/control/clear", json={"stops": ready.process.stops})
    assert ready.process.state.name == "FAULT"
    with ready.socket("/patient/live") as socket:
        shows(socket, "view")
        assert ready.good("POST", "/control/clear", json={"stops": ready.process.stops})["state"] == "armed"


def test_a_screen_that_was_unpaired_or_left_in_an_earlier_trial_holds_nothing(ready: Any) -> None:
    screen = ready.good("GET", "/patient-screen")["screens"][0]["id"]

    def loses_screen() -> Any:
        ready.start_trial(**WHERE)
        with ready.socket("/patient/live") as socket:
            socket.send_json({"picture": "view"})
            until(lambda: ready.parts[ScreenPictures].patients() == {screen: "view"})
        assert until_state(ready, "fault") == "PICTURE_LOST"
        return {"stops": ready.process.stops}

    seen = loses_screen()
    ready.good("POST", "/trials/current/end", json={"reason": "by hand", **seen})
    ready.start_trial(**WHERE)  # without that screen
    ready.good("POST", "/control/stop")
    assert ready.good("POST", "/control/clear", json={"stops": ready.process.stops})["state"] == "armed"
    ready.end_trial()
    seen = loses_screen()
    assert ready("POST", "/control/clear", json=seen).status_code == 409
    ready.good("DELETE", f"/patient-screen/{screen}")
    assert ready.good("POST", "/control/clear", json=seen)["state"] == "armed"


def test_a_patients_screen_that_falls_silent_halts_the_trial(ready: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(patient_socket, "PATIENT_SCREEN_SILENCE", 0.2)
    with ready.socket("/patient/live") as socket:
        ready.start_trial(**WHERE)
        socket.send_json({"picture": "view"})  # and nothing after it
        assert until_state(ready, "fault") == "PICTURE_LOST"  # though the socket is open


def test_a_patients_screen_that_falls_silent_is_out_of_reach(ready: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A page that the browser has put aside keeps its socket, and the clinician's header called it connected."""
    monkeypatch.setattr(patient_socket, "PATIENT_SCREEN_SILENCE", 0.2)
    with ready.socket("/patient/live") as socket:
        socket.send_json({"picture": "plan"})  # and nothing after it
        ready.until("/patient-screen", lambda now: now["screens"][0]["picture"] == "plan")
        ready.until("/patient-screen", lambda now: not now["screens"][0]["connected"])


def test_the_patients_page_is_given_what_it_needs_to_draw_the_plan(ready: Any) -> None:
    assert ready.good("GET", "/view/patient/plan") is None
    trial = ready.start_trial(**WHERE)
    shown = ready.good("GET", "/view/patient/plan")
    assert shown == {"trial": trial["id"], "floorplan": PLACE.model_dump(mode="json"), "path": WHERE["path"]}
    ready.process.says = {"scene_t": 4.0}
    with ready.socket("/patient/live") as socket:
        started = [[*PLACE.movers[0].points[0]]]
        while (movers := socket.receive_json()["trial"]["movers"]) == started or movers[0][:2] == started[0]:
            pass
    gone, _ = PLACE.movers[0].way(4.0)
    assert movers[0][:2] == pytest.approx(PLACE.movers[0].line.point_at(gone), abs=1e-3)
