"""The live socket: its messages, who may open it, when it is closed."""

from typing import Any

import numpy as np
import pytest
from api.fake_clinic import next_message
from api.pairing import closing
from starlette.websockets import WebSocketDisconnect

from app.api.live.live_picture import lamps
from building import make_layout


def test_the_newest_tick_twenty_times_a_second(signed_in: Any) -> None:
    with signed_in.socket("/live") as socket:
        first, second = socket.receive_json(), socket.receive_json()
        assert second["tick"] > first["tick"]
        assert (first["state"], first["fault"], first["control"]) == ("disarmed", None, "alive")
        assert (first["values"][:3], len(first["values"])) == ([None, 0.5, None], 8)
        assert (first["run"], first["trial"]) == (None, None)
        assert first["shirt"]["alive"] is True
        quality = next_message(socket, lambda m: "quality" in m)
        assert len(quality["quality"]) == len(quality["noise"]) == 8


def test_news_names_what_changed_and_whom_it_concerns(signed_in: Any) -> None:
    with signed_in.socket("/live") as socket:
        socket.receive_json()
        signed_in.begin_session()
        here = signed_in.good("GET", "/session")
        patient, session = here["patient"]["id"], here["session"]["id"]
        told = {"what": "session", "patient": patient, "session": session, "trial": None}
        assert next_message(socket, lambda m: "news" in m)["news"] == told
        signed_in.good("DELETE", "/session")
        assert next_message(socket, lambda m: "news" in m)["news"] == told  # of the session that has ended


@pytest.mark.parametrize("origin", [None, "http://evil.example"])
def test_another_origin_opens_no_socket(signed_in: Any, origin: str | None) -> None:
    with pytest.raises(WebSocketDisconnect), signed_in.socket("/live", origin):
        pass


def test_sign_out_closes_the_socket(signed_in: Any) -> None:
    with signed_in.socket("/live") as socket:
        socket.receive_json()
        signed_in.good("POST", "/auth/sign-out")
        assert closing(socket) == 4401


def test_stop_and_the_visitors_movement_go_down_and_nonsense_does_not(signed_in: Any) -> None:
    with signed_in.socket("/live") as socket:
        for text in ("{", "[]", '{"move": {"right_elbow": NaN}}', '{"move": {"right_elbow": 2}}', '{"unknown": 1}'):
            socket.send_text(text)
        socket.send_json({"move": {"right_elbow": 0.7}})
        for roll in (99.0, 0.0):
            socket.send_json({"look": {"yaw": 0.5, "pitch": -0.25, "roll": roll}})
        socket.send_json({"stop": True})
        next_message(socket, lambda m: m["state"] == "fault")
    told = [(do, fields) for do, fields in signed_in.process.told if do in {"move", "look"}]
    look = {"yaw": 0.5, "pitch": -0.25, "roll": 0.0}
    assert told == [("move", {"joints": {"right_elbow": 0.7}}), ("look", look)]


def test_a_stop_counts_whatever_else_the_message_says(signed_in: Any) -> None:
    with signed_in.socket("/live") as socket:
        socket.send_json({"move": {"right_elbow": 2}, "unknown": 1, "stop": True})
        next_message(socket, lambda m: m["state"] == "fault", most=40)


def test_a_trial_shows_where_it_stands(calibrated: Any) -> None:
    with calibrated.socket("/live") as socket:
        calibrated.start_trial()
        message = next_message(socket, lambda m: m.get("trial") is not None)
        assert message["trial"]["length"] > 5
        told = (message["run"]["kind"], message["stops"], message["dial"], message["chair"], message["drive"])
        assert told == ("drive", 0, 1.0, None, None)


def test_without_a_control_process_the_chair_is_shown_standing(signed_in: Any) -> None:
    with signed_in.socket("/live") as socket:
        socket.receive_json()
        signed_in.process.silent = True
        message = next_message(socket, lambda m: m["control"] != "alive")
        assert (message["v"], message["omega"], message["state"]) == (0.0, 0.0, "fault")
        assert message["fault"]["name"] == "control_lost"
        signed_in.process.die()
        assert next_message(socket, lambda m: m["control"] == "alive")["state"] == "disarmed"


def test_a_channel_that_its_neighbours_stand_in_for_has_a_lamp_of_its_own():
    layout = make_layout(8)
    frames = np.random.default_rng(1).normal(size=(100, 8))
    frames[:, 3] = np.nan
    assert lamps(layout, frames, 100.0, ["c5"])[3] == "nan"
    shown = lamps(layout, frames, 100.0, ["c5"], estimated=1 << 3 | 1 << 5)
    assert [shown[3], shown[5]] == ["estimated", "unused"]
    assert "estimated" not in shown[:3]


def test_a_sensor_at_rest_has_no_lamp_of_a_broken_one_where_its_value_may_stay_constant():
    layout = make_layout(8)
    frames = np.random.default_rng(1).normal(size=(100, 8))
    frames[:, [2, 3]] = 0.5
    resting = [channel.model_copy(update={"liveness": "arrival"}) for channel in layout.channels[:3]]
    layout = layout.model_copy(update={"channels": (*resting, *layout.channels[3:])})
    assert lamps(layout, frames, 100.0, [])[2:4] == ["good", "flat"]
    frames[:, 2] = np.nan
    assert lamps(layout, frames, 100.0, [])[2] == "nan"
