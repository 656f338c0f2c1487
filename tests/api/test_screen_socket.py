"""The screen socket: who may open it, and what the control process hears of the screen that drives."""

import time
from typing import Any

import pytest
from fake_clinic import BASE, WORD
from starlette.websockets import WebSocketDisconnect

URL = f"{BASE.replace('http', 'ws')}/api/v1/screen"
ORIGIN = {"Origin": BASE}


def next_ages(clinic: Any, since: int) -> list[float | None]:
    """Return the screen's age in the heartbeats after the first `since` messages, at least one."""
    while True:
        heard = [fields["screen_age"] for do, fields in list(clinic.link.told)[since:] if do == "heartbeat"]
        if heard:
            return heard
        time.sleep(0.001)


@pytest.fixture
def driving(signed_in: Any) -> Any:
    signed_in.visit()
    signed_in.calibrate()
    plan = signed_in.good("GET", "/floorplans/apartment")
    signed_in.start = lambda: signed_in.good(
        "POST", "/trials", json={"floorplan": plan["name"], "path": plan["paths"][0]["name"], "screen": WORD}
    )
    return signed_in


@pytest.mark.parametrize("headers", [{}, {"Origin": "http://evil.example"}])
def test_another_origin_opens_no_socket(signed_in: Any, headers: dict[str, str]) -> None:
    with pytest.raises(WebSocketDisconnect), signed_in.client.websocket_connect(URL, headers=headers):
        pass


def test_nobody_signed_in_opens_no_socket(clinic: Any) -> None:
    with pytest.raises(WebSocketDisconnect), clinic.client.websocket_connect(URL, headers=ORIGIN):
        pass


def test_the_age_goes_down_with_each_word_and_is_null_without_a_trial(driving: Any) -> None:
    with driving.screen() as socket:
        assert next_ages(driving, len(driving.link.told))[-1] is None
        driving.start()
        socket.send_json({"screen": WORD, "visible": True})
        assert next_ages(driving, len(driving.link.told))[-1] is not None


def test_hiding_and_closing_are_told_with_the_very_message(driving: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    with driving.screen() as socket:
        driving.start()
        beats: list[str] = []
        monkeypatch.setattr(driving.flows.control, "beat", lambda: beats.append("now"))
        socket.send_json({"screen": WORD, "visible": False})
        while not beats:
            time.sleep(0.001)
        assert next_ages(driving, len(driving.link.told))[-1] is None
        socket.send_json({"screen": WORD, "visible": False})
        socket.send_json({"screen": WORD, "visible": True})
        while next_ages(driving, len(driving.link.told))[-1] is None:
            pass
        assert len(beats) == 1  # saying it again is no news
    while len(beats) < 2:
        time.sleep(0.001)
    assert next_ages(driving, len(driving.link.told))[-1] is None


def test_a_beat_out_of_turn_reaches_the_control_process(driving: Any) -> None:
    driving.flows.control.screen_age = lambda: 0.125
    driving.flows.control.beat()
    assert 0.125 in next_ages(driving, len(driving.link.told))


def test_another_screen_of_the_same_person_does_not_stand_in(driving: Any) -> None:
    with driving.screen("another-screen") as other:
        driving.start()
        other.send_json({"screen": "another-screen", "visible": True})
        assert set(next_ages(driving, len(driving.link.told))) == {None}


@pytest.mark.parametrize("junk", ["{", "[]", "null", "1", '{"screen": "x", "visible": true}', "[" * 200, " " * 5000])
def test_what_cannot_be_read_is_silence(driving: Any, junk: str) -> None:
    with driving.screen() as socket:
        driving.start()
        socket.send_text(junk)
        socket.send_json({"screen": WORD, "visible": False})
        while any(age is not None for age in next_ages(driving, len(driving.link.told))):
            pass


def test_what_is_no_text_closes_the_socket(signed_in: Any) -> None:
    with signed_in.client.websocket_connect(URL, headers=ORIGIN) as socket:
        socket.send_bytes(b"\x00")
        with pytest.raises(WebSocketDisconnect) as closed:
            socket.receive_text()
    assert closed.value.code == 1003


def test_a_trial_needs_the_word_of_its_screen(driving: Any) -> None:
    plan = driving.good("GET", "/floorplans/apartment")
    where = {"floorplan": plan["name"], "path": plan["paths"][0]["name"]}
    assert driving("POST", "/trials", json=where).status_code == 422
    assert driving("POST", "/trials", json={**where, "screen": "a b"}).status_code == 422
