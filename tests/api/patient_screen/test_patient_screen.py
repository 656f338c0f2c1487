"""The patient's screen: paired once by a code, opened by its own cookie, closed with the session."""

from datetime import timedelta
from typing import Any

import pytest
from api.fake_clinic import BASE, Clinic, sentence_of
from api.pairing import closing, code_of, only, pair
from api.served_routes import filled, table
from api.test_roles import FOR_EVERYONE, FOR_PATIENTS_SCREENS
from starlette.websockets import WebSocketDisconnect

from app.api import sockets
from app.clock import monotonic, utc_now
from app.scene.client_messages import SUBPROTOCOL
from app.session import screen_codes
from app.store import patient_screens as store_patient_screens
from app.store.tables import PatientScreen

ORIGIN = {"Origin": BASE}
WS = BASE.replace("http", "ws")


def test_a_code_pairs_one_screen_with_a_cookie_of_its_own(in_session: Clinic) -> None:
    offered = in_session.good("POST", "/patient-screen/pairing")
    assert offered["url"] == f"{BASE}/patient.html#pair={offered['code']}"
    assert offered["qr"].startswith("<svg")
    assert "only this machine" in offered["message"].lower()
    assert len(offered["code"]) == 8  # 40 bits, five to a letter
    answer = pair(in_session, offered["code"])
    assert answer.json() == {"state": "paired"}
    cookie = answer.headers["set-cookie"]
    assert cookie.startswith("bodydrive_screen=")
    assert {"httponly", "samesite=lax", "max-age=43200"} <= {part.strip().lower() for part in cookie.split(";")}
    assert "used" in sentence_of(pair(in_session, offered["code"]), 409)
    (shown,) = in_session.good("GET", "/patient-screen")["screens"]
    assert (shown["number"], shown["connected"]) == (1, False)
    token = answer.cookies["bodydrive_screen"]
    for file in in_session.settings.state.glob("bodydrive.sqlite*"):
        assert token.encode() not in file.read_bytes()
    entry = in_session.log()[-1]
    assert (entry.person, entry.what) == ("Demo clinician", "patient's screen paired")


def test_nobody_pairs_without_a_session(signed_in: Clinic) -> None:
    assert signed_in("POST", "/patient-screen/pairing").status_code == 409
    assert signed_in.good("GET", "/patient-screen")["screens"] == []
    signed_in.begin_session()
    code = code_of(signed_in)
    signed_in.good("DELETE", "/session")
    assert pair(signed_in, code).status_code == 409
    assert "bodydrive_screen" not in signed_in.client.cookies


def test_only_the_newest_code_pairs_and_not_for_long(in_session: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    first, second = code_of(in_session), code_of(in_session)
    assert first != second
    assert pair(in_session, first).status_code == 409
    now = monotonic()
    monkeypatch.setattr(screen_codes, "monotonic", lambda: now + 601.0)
    assert pair(in_session, second).status_code == 409


def test_a_code_may_be_typed_as_people_type(in_session: Clinic) -> None:
    code = code_of(in_session)
    typed = f" {code[:4].lower()}-{code[4:].replace('0', 'o').replace('1', 'l')} "
    assert pair(in_session, typed).status_code == 200


def test_guesses_are_slowed_down_and_a_right_code_has_to_wait_with_them(in_session: Clinic) -> None:
    code = code_of(in_session)
    answers = [pair(in_session, f"guess-{i}").status_code for i in range(12)]
    assert answers == [409] * 10 + [429] * 2
    assert pair(in_session, code).status_code == 429


def test_its_cookie_opens_no_other_route(screen: Clinic) -> None:
    """Request every route: the patient's screen may use those for everyone, and no other."""
    wrong = []
    for name in table(screen.client.app):  # type: ignore[arg-type]
        if name in FOR_EVERYONE:
            continue
        method, path = name.split()
        prefix = "" if path == "/view/{role}/" or path.startswith("/view/replay/") else "/api/v1"
        for role in ("clinician", "patient") if "{role}" in path else ("",):
            url = f"{prefix}{filled(path, role=role, word='w' * 32)}"
            opens = name in FOR_PATIENTS_SCREENS and role == "patient"
            for body in (None, dict[str, str]()):
                status = screen.client.request(method, url, headers=ORIGIN, json=body).status_code
                if status != (200 if opens else 401):
                    wrong.append((method, url, status))
    assert wrong == []


def test_its_cookie_opens_its_own_sockets_and_no_other(screen: Clinic) -> None:
    with screen.socket("/patient/live") as socket:
        assert socket.receive_json()["state"] == "disarmed"
    for path in ("/api/v1/live", "/api/v1/screen", "/view/clinician", "/view/patient"):
        opening = screen.client.websocket_connect(f"{WS}{path}", [SUBPROTOCOL], headers=ORIGIN)
        with pytest.raises(WebSocketDisconnect) as closed, opening as socket:
            socket.receive_text()
        # 4409: let in, and told that there is no 3D view here
        assert closed.value.code == (4409 if path == "/view/patient" else 4401), path


@pytest.mark.parametrize("origin", [None, "http://evil.example"])
def test_another_origin_opens_no_socket_and_pairs_nothing(screen: Clinic, origin: str | None) -> None:
    with pytest.raises(WebSocketDisconnect), screen.socket("/patient/live", origin):
        pass
    headers = {} if origin is None else {"Origin": origin}
    assert screen.client.post("/api/v1/patient-screen/pair", json={"code": "x"}, headers=headers).status_code == 403


def test_a_sign_in_alone_is_no_patients_screen(in_session: Clinic) -> None:
    with pytest.raises(WebSocketDisconnect), in_session.socket("/patient/live"):
        pass
    assert in_session.good("GET", "/patient-screen/me") == {"state": "none"}


def test_unpairing_closes_its_sockets_and_leaves_the_sign_in_alone(paired: Clinic) -> None:
    paired.calibrate()
    with paired.socket("/patient/live") as socket:
        socket.receive_json()
        (shown,) = paired.good("GET", "/patient-screen")["screens"]
        assert shown["connected"] is True
        left = paired.good("DELETE", f"/patient-screen/{shown['id']}")
        assert left["screens"] == []
        assert closing(socket) == 4401
    assert paired.good("GET", "/patient-screen/me") == {"state": "unpaired"}
    assert paired.log()[-1].what == "patient's screen unpaired"
    assert paired("DELETE", f"/patient-screen/{shown['id']}").status_code == 404
    assert paired("GET", "/patients").status_code == 200


def test_the_end_of_the_session_is_the_end_of_its_screens(paired: Clinic) -> None:
    with paired.socket("/patient/live") as socket:
        socket.receive_json()
        paired.good("DELETE", "/session")
        assert closing(socket) == 4401
    assert paired.good("GET", "/patient-screen/me") == {"state": "over"}
    paired.open_session(paired.add_patient("P-2"))
    only(paired, "bodydrive_screen")
    assert paired.client.get("/view/patient/", headers=ORIGIN).status_code == 401


def test_a_forgotten_session_keeps_no_screen_beyond_twelve_hours(screen: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    now = utc_now()
    monkeypatch.setattr(store_patient_screens, "utc_now", lambda: now + timedelta(hours=12, minutes=1))
    assert screen.good("GET", "/patient-screen/me") == {"state": "over"}
    assert screen.client.get("/view/patient/", headers=ORIGIN).status_code == 401


def test_a_pairing_that_ends_behind_its_back_closes_its_socket(screen: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sockets, "CHECK_EVERY", 0.05)
    with screen.socket("/patient/live") as socket:
        socket.receive_json()
        with screen.database.transaction() as db:
            db.get_one(PatientScreen, 1).unpaired = utc_now()
        assert closing(socket) == 4401


def test_signing_out_in_the_same_browser_leaves_the_screen(paired: Clinic) -> None:
    with paired.socket("/patient/live") as socket:
        paired.good("POST", "/auth/sign-out")
        for _ in range(3):
            socket.receive_json()
    assert paired.good("GET", "/patient-screen/me") == {"state": "paired"}


def test_a_browser_that_pairs_again_is_the_same_screen(paired: Clinic) -> None:
    before = paired.client.cookies["bodydrive_screen"]
    assert pair(paired, code_of(paired)).status_code == 200
    assert paired.client.cookies["bodydrive_screen"] != before
    assert [screen["number"] for screen in paired.good("GET", "/patient-screen")["screens"]] == [2]


def test_there_is_an_end_to_screens(paired: Clinic) -> None:
    for _ in range(7):
        only(paired, "bodydrive_sign_in")
        assert pair(paired, code_of(paired)).status_code == 200
    only(paired, "bodydrive_sign_in")
    assert "unpair one" in pair(paired, code_of(paired)).json()["detail"]


def test_the_language_of_the_screen_is_that_of_the_patients_session_before(in_session: Clinic) -> None:
    settings = in_session.good("GET", "/patient-screen")["settings"]
    in_session.good("POST", "/patient-screen/settings", json=settings | {"language": "es", "large": True})
    patient = in_session.good("GET", "/session")["patient"]["id"]
    in_session.good("DELETE", "/session")
    in_session.good("POST", "/session", json={"patient_id": patient})
    assert in_session.good("GET", "/patient-screen")["settings"] == settings | {"language": "es"}
