"""The camera's socket: who may be the camera, one at a time, and that only samples of bounded number and size pass."""

import time
from typing import Any

import pytest
from api.fake_clinic import Clinic
from api.pairing import closing
from starlette.websockets import WebSocketDisconnect

from app.api.live import camera_socket, page_samples
from app.api.live.camera_socket import CAMERA_SILENCE, ActiveCamera
from app.messages import LONGEST_SAMPLE

SAMPLE = bytes(range(100))
IN_USE, UNWANTED, NOT_A_SAMPLE, TOO_MANY = 4409, 4410, 1003, 1008


@pytest.fixture
def filmed(paired: Clinic) -> Clinic:
    """A browser that is signed in and the patient's screen as well; the shirt in use is the camera."""
    paired.good("PUT", "/equipment/shirt", json={"kind": "camera"})
    return paired


def passed_on(clinic: Clinic) -> list[dict[str, Any]]:
    return [fields for do, fields in list(clinic.process.told) if do == "sample"]


def until_passed_on(clinic: Clinic, count: int) -> list[dict[str, Any]]:
    while len(passed_on(clinic)) < count:
        time.sleep(0.001)
    return passed_on(clinic)


def test_the_samples_of_a_clinician_s_page_reach_the_control_process(filmed: Clinic) -> None:
    with filmed.socket("/camera") as socket:
        for i in range(3):
            socket.send_bytes(SAMPLE[i:])
        samples = until_passed_on(filmed, 3)
    assert [bytes.fromhex(sample["message"]) for sample in samples] == [SAMPLE, SAMPLE[1:], SAMPLE[2:]]
    assert {sample["page"] for sample in samples} == {1}
    times = [sample["received"] for sample in samples]
    assert times == sorted(times)


def test_the_patient_s_screen_may_be_the_camera(filmed: Clinic) -> None:
    with filmed.socket("/patient/live") as socket:
        assert socket.receive_json()["camera"] is True
    filmed.client.cookies.delete("bodydrive_sign_in")
    with filmed.socket("/camera") as socket:
        socket.send_bytes(SAMPLE)
        until_passed_on(filmed, 1)


def test_a_screen_is_told_when_the_shirt_is_no_camera(paired: Clinic) -> None:
    with paired.socket("/patient/live") as socket:
        assert socket.receive_json()["camera"] is False


@pytest.mark.parametrize("origin", [None, "http://evil.example"])
def test_another_origin_opens_no_socket(filmed: Clinic, origin: str | None) -> None:
    with pytest.raises(WebSocketDisconnect), filmed.socket("/camera", origin):
        pass


def test_a_reviewer_is_no_camera(filmed: Clinic) -> None:
    filmed.client.cookies.delete("bodydrive_screen")
    cookies = filmed.cookies_of("Rita", "reviewer")
    filmed.client.cookies.delete("bodydrive_sign_in")
    for name, value in cookies.items():
        filmed.client.cookies.set(name, value)
    with filmed.socket("/camera") as socket:
        socket.send_bytes(SAMPLE)
        time.sleep(0.05)
        assert passed_on(filmed) == []


def test_another_shirt_wants_no_samples(paired: Clinic) -> None:
    with paired.socket("/camera") as socket:
        socket.send_bytes(SAMPLE)
        assert closing(socket) == UNWANTED
    assert passed_on(paired) == []


@pytest.mark.parametrize("sample", [b"", bytes(LONGEST_SAMPLE + 1), bytes(5_000_000)], ids=len)
def test_what_is_too_short_or_too_long_closes_the_socket(filmed: Clinic, sample: bytes) -> None:
    with filmed.socket("/camera") as socket:
        socket.send_bytes(sample)
        assert closing(socket) == NOT_A_SAMPLE
    assert passed_on(filmed) == []


def test_text_is_no_sample(filmed: Clinic) -> None:
    with filmed.socket("/camera") as socket:
        socket.send_text('{"stop": true}')
        assert closing(socket) == NOT_A_SAMPLE


def test_a_flood_closes_the_socket(filmed: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(camera_socket, "FLOOD", 20)
    monkeypatch.setattr(page_samples, "monotonic", lambda: 100.0)
    with filmed.socket("/camera") as socket:
        for _ in range(21):
            socket.send_bytes(SAMPLE)
        assert closing(socket) == TOO_MANY
    assert len(until_passed_on(filmed, 20)) == 20


def test_a_second_page_is_no_camera_while_the_first_sends(filmed: Clinic) -> None:
    with filmed.socket("/camera") as first:
        first.send_bytes(SAMPLE)
        until_passed_on(filmed, 1)
        with filmed.socket("/camera") as second:
            second.send_bytes(SAMPLE)
            assert closing(second) == IN_USE
        first.send_bytes(SAMPLE)
        assert {sample["page"] for sample in until_passed_on(filmed, 2)} == {1}
    with filmed.socket("/camera") as third:  # the first one has ended
        third.send_bytes(SAMPLE)
        assert until_passed_on(filmed, 3)[-1]["page"] == 2


def test_a_silent_page_gives_way_and_comes_back_as_another() -> None:
    active, first, second = ActiveCamera(), object(), object()
    assert [active.number(first, 10.0), active.number(first, 11.9)] == [1, 1]
    assert active.number(second, 11.9 + 0.99 * CAMERA_SILENCE) is None
    assert active.number(second, 11.9 + CAMERA_SILENCE) == 2
    assert active.number(first, 14.0) is None
    active.forget(first)  # it was the camera before, and is none now
    assert active.number(first, 14.1) is None
    active.forget(second)
    assert active.number(first, 14.2) == 3


def test_the_camera_ends_with_the_sign_in(filmed: Clinic) -> None:
    filmed.client.cookies.delete("bodydrive_screen")
    with filmed.socket("/camera") as socket:
        socket.send_bytes(SAMPLE)
        until_passed_on(filmed, 1)
        filmed.good("POST", "/auth/sign-out")
        assert closing(socket) == 4401
