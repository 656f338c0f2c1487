"""The screen socket: who may open it, and the heartbeat's report of the screen that drives."""

import time
from typing import Any

import pytest
from api.fake_clinic import WHERE, WORD
from api.pairing import closing
from starlette.websockets import WebSocketDisconnect

from app.api.live import screens
from app.api.live.screens import VIRTUAL_SILENCE_LIMIT
from app.session.control_link import ControlLink, ScreenSign
from app.session.real_drive import RealDriveFlow
from app.session.trial import TrialFlow


def saying(visible: bool = True, silence: float = 0.0, word: str = WORD) -> dict[str, Any]:
    return {"screen": word, "visible": visible, "silence": silence}


def next_beats(clinic: Any, since: int = -1) -> list[Any]:
    """Return the screen reports of the heartbeats after the first `since` messages, or from now on; at least one."""
    since = len(clinic.process.told) if since < 0 else since
    while True:
        told = list(clinic.process.told)[since:]
        heard = [(fields["screen_age"], fields["screen"]) for do, fields in told if do == "heartbeat"]
        if heard:
            return heard
        time.sleep(0.001)


def until_told(clinic: Any, wanted: str | None) -> None:
    """Wait for a heartbeat with this view of the screen; None: without a screen."""
    while (None if (beat := next_beats(clinic)[-1])[0] is None else beat[1]) != wanted:
        pass


@pytest.mark.parametrize("origin", [None, "http://evil.example"])
def test_another_origin_opens_no_socket(signed_in: Any, origin: str | None) -> None:
    with pytest.raises(WebSocketDisconnect), signed_in.socket("/screen", origin):
        pass


def test_the_age_goes_down_with_each_word_and_is_null_without_a_trial(calibrated: Any) -> None:
    with calibrated.screen() as socket:
        assert next_beats(calibrated)[-1] == (None, "in view")
        calibrated.start_trial()
        socket.send_json(saying())
        assert next_beats(calibrated)[-1][0] is not None


def test_hiding_standing_still_and_closing_are_told_apart_with_the_very_message(
    calibrated: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    beats: list[str] = []

    def tells_at_once(view: str | None) -> None:
        while not beats:
            time.sleep(0.001)
        until_told(calibrated, view)
        assert len(beats) == 1  # saying it again is no news
        beats.clear()

    with calibrated.screen() as socket:
        calibrated.start_trial()
        monkeypatch.setattr(calibrated.parts[ControlLink], "beat", lambda: beats.append("now"))
        for _ in range(2):
            socket.send_json(saying(visible=False))
        tells_at_once("hidden")
        socket.send_json(saying(silence=VIRTUAL_SILENCE_LIMIT))
        until_told(calibrated, "in view")  # nobody sits in the virtual chair: a slow screen may draw for so long
        for silence in (3.1, 3.2):
            socket.send_json(saying(silence=silence))
        tells_at_once("slow")
        socket.send_json(saying())
        until_told(calibrated, "in view")
    tells_at_once(None)


def test_a_page_that_stands_still_counts_less_long_on_a_real_chair(calibrated: Any) -> None:
    with calibrated.screen() as socket:
        calibrated.start_trial()
        socket.send_json(saying(silence=1.1))
        until_told(calibrated, "in view")
        trials, drives = calibrated.parts[TrialFlow], calibrated.parts[RealDriveFlow]
        drives.current, trials.current = trials.current, None
        until_told(calibrated, "slow")
        trials.current, drives.current = drives.current, None


def test_a_second_socket_with_the_same_word_does_not_keep_the_chair_driving(calibrated: Any) -> None:
    with calibrated.screen():
        calibrated.start_trial()
        since = len(calibrated.process.told)
        with calibrated.socket("/screen") as second:
            second.send_json(saying())
            assert closing(second, most=1) == 4409
        # The first one is silent, and the gate is told so.
        while (beats := next_beats(calibrated, since))[-1][0] < 0.31:
            time.sleep(0.01)
        assert [age for age, _ in beats] == sorted(age for age, _ in beats)
    until_told(calibrated, None)
    with calibrated.screen():  # loaded again: the first is closed
        until_told(calibrated, "in view")


def test_a_socket_that_is_dead_but_open_gives_way_long_after_the_chair_stopped(
    calibrated: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(screens, "LINK_LIMIT", 0.4)
    with calibrated.screen() as dead:
        calibrated.start_trial()
        while next_beats(calibrated)[-1][0] <= 0.4:
            time.sleep(0.01)
        with calibrated.socket("/screen") as second:
            second.send_json(saying())
            while next_beats(calibrated)[-1][0] > 0.4:
                time.sleep(0.001)
            dead.send_json(saying(visible=False))  # it comes back, too late
            assert closing(dead, most=1) == 4409
            assert next_beats(calibrated)[-1][1] == "in view"


def test_a_beat_out_of_turn_reaches_the_control_process(calibrated: Any) -> None:
    calibrated.parts[ControlLink].follow_screen(lambda: ScreenSign(0.125, "hidden"))
    calibrated.parts[ControlLink].beat()
    assert (0.125, "hidden") in next_beats(calibrated)


def test_another_screen_of_the_same_person_does_not_stand_in(calibrated: Any) -> None:
    with calibrated.screen("another-screen") as other:
        calibrated.start_trial()
        other.send_json(saying(word="another-screen"))
        assert {age for age, _ in next_beats(calibrated)} == {None}


JUNK = (
    *("{", "[]", "null", "1", "[" * 200, " " * 5000),
    '{"screen": "x", "visible": true, "silence": 0}',
    '{"screen": "the-screen-of-the-tests", "visible": true}',
    '{"screen": "the-screen-of-the-tests", "visible": true, "silence": NaN}',
    '{"screen": "the-screen-of-the-tests", "visible": true, "silence": -1}',
)


def test_what_cannot_be_read_is_silence(calibrated: Any) -> None:
    with calibrated.screen() as socket:
        calibrated.start_trial()
        for junk in JUNK:
            socket.send_json(saying(visible=False))
            until_told(calibrated, "hidden")
            since = len(calibrated.process.told)
            socket.send_text(junk)
            socket.send_json(saying(word="another-screen"))  # after it the junk has been read
            until_told(calibrated, None)
            beats = next_beats(calibrated, since)
            assert all(view != "in view" for age, view in beats if age is not None), junk


def test_what_is_no_text_closes_the_socket(signed_in: Any) -> None:
    with signed_in.socket("/screen") as socket:
        socket.send_bytes(b"\x00")
        assert closing(socket, most=1) == 1003


def test_a_trial_needs_the_word_of_its_screen(calibrated: Any) -> None:
    for screen in (None, "a b"):
        assert calibrated("POST", "/trials", json={**WHERE, "screen": screen}).status_code == 422
    assert calibrated("POST", "/trials", json={name: WHERE[name] for name in ("floorplan", "path")}).status_code == 422
