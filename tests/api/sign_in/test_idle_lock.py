"""The idle lock: after 10 min without an action, the server refuses all but Stop, sign-in, sign-out and unlocking."""

from collections.abc import Callable
from datetime import timedelta
from typing import Any

import pytest
from api.fake_clinic import BASE, Clinic, next_message
from api.pairing import closing
from api.people_of_clinic import OWNER, accepted, invited
from api.served_routes import requested, table
from api.test_roles import FOR_EVERYONE
from api.view.served_view import VIEW, serve_view
from starlette.websockets import WebSocketDisconnect

from app.api import sockets
from app.clock import utc_now
from app.session.open_session import SessionFlow
from app.store.access import sign_ins

ORIGIN = {"Origin": BASE}
PASSWORD = {"password": OWNER["password"]}

Later = Callable[[float], None]


@pytest.fixture
def later(monkeypatch: pytest.MonkeyPatch) -> Later:
    """Return a function that lets minutes pass on the clock of sign-ins."""
    passed = timedelta()

    def pass_minutes(minutes: float) -> None:
        nonlocal passed
        passed += timedelta(minutes=minutes)
        now = passed
        monkeypatch.setattr(sign_ins, "utc_now", lambda: utc_now() + now)

    monkeypatch.setattr(sockets, "CHECK_EVERY", 0.01)
    return pass_minutes


def test_every_route_but_those_for_everybody_answers_423(owned: Clinic, later: Later) -> None:
    later(10.1)
    app = owned.client.app
    routes = set(table(app))  # type: ignore[arg-type]
    in_order = sorted(routes, key=lambda name: name == "POST /auth/sign-out")  # which ends the sign-in: last
    refused = {name for name in in_order if requested(owned, name).status_code == 423}
    assert refused == routes - FOR_EVERYONE - {"POST /auth/unlock"}
    me = owned.good("POST", "/auth/sign-in", json={"name": "Ada", **PASSWORD})  # one of the routes has signed out
    assert me["locked"] is False


def test_a_locked_page_can_stop_and_be_unlocked_with_the_right_password_only(owned: Clinic, later: Later) -> None:
    later(9.9)
    assert owned("GET", "/patients").status_code == 200
    later(0.2)
    assert "locked" in owned.refused(423, "GET", "/patients")
    assert owned.good("GET", "/auth/me")["locked"] is True
    start = owned.good("GET", "/start")
    assert (start["me"]["name"], start["session"]) == ("Ada", None)
    assert (owned("POST", "/control/stop").status_code, owned.process.stops) == (200, 1)
    assert owned("POST", "/auth/unlock", json={"password": "nothing like it"}).status_code == 401
    assert owned("GET", "/patients").status_code == 423
    assert owned.good("POST", "/auth/unlock", json=PASSWORD)["locked"] is False
    assert owned("GET", "/patients").status_code == 200
    assert "unlocked" in [row.what for row in owned.log()[-2:]]  # who asked for the stop is logged after its answer


def test_an_action_keeps_it_open_and_looking_does_not(owned: Clinic, later: Later) -> None:
    for _ in range(3):
        later(6)
        owned("DELETE", "/replays/no-such-word")
    for _ in range(3):
        later(3)
        assert owned("GET", "/patients").status_code == 200
        owned("POST", "/replays/no-such-word/at", json={"t": 0.0})  # a replay plays on by itself
    later(3)
    assert owned("GET", "/patients").status_code == 423


def test_twelve_hours_end_the_sign_in_however_active_it_was(owned: Clinic, later: Later) -> None:
    for _ in range(79):
        later(9)
        owned("DELETE", "/replays/no-such-word")
    assert owned.good("GET", "/auth/me")["signed_in"] is True
    later(9.1)
    assert owned.good("GET", "/auth/me")["signed_in"] is False


def test_another_person_signs_in_on_a_locked_page(owned: Clinic, later: Later) -> None:
    accepted(owned, invited(owned, "Ben", "clinician"), "a quiet blue heron")
    later(11)
    me = owned.good("POST", "/auth/sign-in", json={"name": "Ben", "password": "a quiet blue heron"})
    assert (me["name"], me["locked"]) == ("Ben", False)
    assert owned.log()[-2].what == "sign-out"  # Ada's sign-in has ended


def test_the_live_socket_shows_nothing_of_a_patient_while_locked_and_stops(owned: Clinic, later: Later) -> None:
    session = owned.begin_session() and owned.good("GET", "/session")["session"]["id"]
    with owned.socket("/live") as socket:
        assert next_message(socket, lambda m: not m["hidden"])["session"] == session
        later(11)
        bare = next_message(socket, lambda m: m["hidden"])
        assert (bare["session"], bare["values"], bare["trial"], bare["run"]) == (None, None, None, None)
        before = owned.process.stops
        socket.send_json({"move": {"left_wrist": 1.0}})
        socket.send_json({"stop": True})
        next_message(socket, lambda m: m["stops"] > before)
        assert [do for do, _ in owned.process.told if do == "move"] == []
        owned.good("POST", "/auth/unlock", json=PASSWORD)
        assert next_message(socket, lambda m: not m["hidden"])["session"] == session
    with owned.as_person(dict(owned.client.cookies)), owned.socket("/live") as socket:
        later(11)
        next_message(socket, lambda m: m["hidden"])


def test_the_3d_view_ends_when_the_page_is_locked(owned: Clinic, later: Later, monkeypatch: pytest.MonkeyPatch) -> None:
    serve_view(monkeypatch)
    with owned.client.websocket_connect(**VIEW) as socket:
        later(11)
        assert closing(socket, most=1) == 4409
    with pytest.raises(WebSocketDisconnect), owned.client.websocket_connect(**VIEW):
        pass


def test_wrong_passwords_from_elsewhere_do_not_keep_a_page_locked(owned: Clinic, later: Later) -> None:
    """The browser is a known one of this person, also when it unlocks (C23)."""
    later(11)
    wrong = {"name": "Ada", "password": "nothing like it"}
    elsewhere = {"headers": {"Origin": BASE, "Cookie": ""}}
    tried = [owned.client.post("/api/v1/auth/sign-in", json=wrong, **elsewhere).status_code for _ in range(6)]
    assert tried == [401] * 5 + [429]
    assert owned.good("POST", "/auth/unlock", json=PASSWORD)["locked"] is False


def beyond(number: int) -> Callable[[Any], bool]:
    """Return whether a message has a later tick than this."""
    return lambda message: bool(message["tick"] > number)


def test_a_touch_of_the_page_counts_as_an_action(owned: Clinic, later: Later) -> None:
    with owned.socket("/live") as socket:
        for _ in range(3):
            later(6)
            socket.send_json({"acted": True})
            number = socket.receive_json()["tick"]
            next_message(socket, beyond(number + 1))
        assert owned("GET", "/patients").status_code == 200


def test_armed_or_recording_is_not_idle(owned: Clinic, later: Later, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(type(owned.parts[SessionFlow]), "recording", property(lambda _self: True))
    with owned.socket("/live") as socket:
        for _ in range(3):
            later(6)
            number = socket.receive_json()["tick"]
            next_message(socket, beyond(number + 4))
        assert owned("GET", "/patients").status_code == 200
        monkeypatch.setattr(type(owned.parts[SessionFlow]), "recording", property(lambda _self: False))
        later(10.5)
        next_message(socket, lambda m: m["hidden"])


def test_a_demonstration_never_locks(signed_in: Clinic, later: Later) -> None:
    later(11 * 60)
    assert signed_in("GET", "/patients").status_code == 200
