"""The matrix of roles and routes: every route is requested by every role."""

from typing import Any

import pytest
from api.fake_clinic import BASE, Clinic
from api.pairing import code_of, pair
from api.served_routes import asked, contexts, requested, table
from fastapi.routing import APIRoute, APIWebSocketRoute
from starlette.websockets import WebSocketDisconnect

from app.api.sign_in.identity import SCREEN_COOKIE
from app.api.who_asks import who_asks

ROLES = {"nobody": 0, "patient's screen": 0, "reviewer of all": 1, "reviewer by patient": 1, "clinician": 2, "owner": 3}

# What a person may do here is this table, and the code; a new route has to be put in both.
FOR_EVERYONE = {
    *("POST /auth/demo", "POST /auth/setup", "POST /auth/sign-in", "POST /auth/unlock", "POST /auth/sign-out"),
    *("POST /auth/invitation", "POST /auth/invitation/accept", "GET /auth/me", "PUT /auth/language"),
    *("GET /start", "GET /reference", "GET /trust", "GET /equipment/practice", "POST /control/stop"),
    *("POST /patient-screen/pair", "GET /patient-screen/me", "POST /phones/pair", "GET /phones/me"),
    *("POST /shared/open", "GET /shared"),
}
# Method and path of those that need no cookie at all; what is shared has a cookie of its own.
OPEN = {(route.split()[0], f"/api/v1{route.split()[1]}") for route in FOR_EVERYONE - {"GET /shared"}}
FOR_PATIENTS_SCREENS = {"GET /view/{role}/", "GET /view/{role}/plan"}  # the patient's only
FOR_OWNERS = {
    *("POST /chairs", "DELETE /chairs/{chair_id}", "PUT /limits", "PUT /clinic-prior", "POST /computer/measurement"),
    *("POST /sessions/{session_id}/unlock", "GET /archives", "POST /archives", "PUT /record-keeping"),
    *("GET /backups", "POST /backups", "PUT /backups/settings", "POST /deleted-patients/{patient_id}/erasure"),
    *("POST /incidents/{incident_id}/lifting", "GET /log", "GET /log/export", "GET /log/check", "GET /openapi.json"),
    *("GET /people", "POST /people", "PUT /people/{person_id}", "POST /people/{person_id}/link"),
    *("POST /people/{person_id}/disable", "POST /people/{person_id}/enable"),
}
FOR_REVIEWERS = {
    *("PUT /auth/password", "POST /auth/introduction", "GET /attention", "GET /session", "GET /patients"),
    *("GET /patients/{patient_id}/sessions", "GET /patients/{patient_id}/consents"),
    *("GET /patients/{patient_id}/learning", "GET /patients/{patient_id}/trajectories"),
    *("GET /patients/{patient_id}/next-task", "GET /patients/{patient_id}/quality", "GET /patients/{patient_id}/maps"),
    *("GET /sessions/{session_id}", "GET /sessions/{session_id}/comparison", "GET /sessions/{session_id}/story"),
    *("GET /trials", "GET /trials/{trial_id}", "GET /trials/{trial_id}/timeline", "GET /trials/{trial_id}/verdicts"),
    *("GET /comments", "GET /trials/{trial_id}/comments", "POST /trials/{trial_id}/comments"),
    *("POST /trials/{trial_id}/comments/read", "PUT /comments/{comment_id}", "DELETE /comments/{comment_id}"),
    *("GET /equipment", "GET /equipment/sender", "GET /equipment/shirts", "GET /chairs", "GET /limits", "GET /tablets"),
    *("GET /floorplans", "GET /floorplans/{name}", "GET /clinic-prior", "GET /interface-tests", "GET /adaptation"),
    *("GET /drives", "GET /drives/summary", "GET /view/{role}/", "GET /view/{role}/plan"),
    *("POST /replays", "POST /replays/{word}/at", "DELETE /replays/{word}", "GET /view/replay/{word}/"),
}


def test_every_route_says_whom_it_is_for_and_it_is_the_table(clinic: Clinic) -> None:
    rights = table(clinic.client.app)  # type: ignore[arg-type]
    assert len(rights) >= 50
    assert [name for name, right in rights.items() if right is None] == []
    for needed, names in ((0, FOR_EVERYONE), (1, FOR_REVIEWERS), (3, FOR_OWNERS)):
        assert {name for name, right in rights.items() if right == needed} == names


def test_every_route_finds_who_asks_before_it_reads_a_patient(clinic: Clinic) -> None:
    """Otherwise a route would show a reviewer of chosen patients every patient."""
    found = contexts(clinic.client.app, APIRoute)  # type: ignore[arg-type]
    assert [context.path for context in found if who_asks not in asked(context.dependant)] == []


def test_stop_asks_nobodys_name_before_it_stops(signed_in: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    """Otherwise a busy database would delay it."""

    def fail(*_given: Any, **_more: Any) -> None:
        raise AssertionError("Stop has read the database")

    monkeypatch.setattr("app.api.who_asks.find_sign_in", fail)
    assert signed_in("POST", "/control/stop").status_code == 200
    assert signed_in.process.stops == 1
    rows = [(row.person, row.what) for row in signed_in.log()]  # that of the gate may come before or after it
    assert ("Demo clinician", "stop requested") in rows


@pytest.mark.parametrize("role", ROLES)
def test_the_matrix_of_roles_and_routes(in_session: Clinic, role: str) -> None:
    """Requests have no content, so that a permitted one is refused for its content only."""
    clinic = in_session
    if role == "patient's screen":
        assert pair(clinic, code_of(clinic)).status_code == 200
        screen = clinic.client.cookies[SCREEN_COOKIE]
    elif role != "nobody":
        clinic.cookies_of(role, role.partition(" ")[0], [] if role == "reviewer by patient" else None)
    wrong = []
    cookies: dict[str, str] = {}
    for name, right in table(clinic.client.app).items():  # type: ignore[arg-type]
        for view in ("clinician", "patient") if "{role}" in name else ("clinician",):
            clinic.client.cookies.clear()
            if role == "patient's screen":
                clinic.client.cookies[SCREEN_COOKIE] = screen
            elif role != "nobody":
                cookies = cookies or clinic.cookies_of(role)
                clinic.client.cookies.update(cookies)
            status = requested(clinic, name, view).status_code
            if name == "POST /auth/sign-out":
                cookies = {}
            if status not in expected(role, name, right or 0, view):
                wrong.append((name, view, status))
    assert wrong == []


def expected(role: str, name: str, needed: int, view: str) -> set[int]:
    """Return which answers are right for a role."""
    if role == "patient's screen" and name in FOR_PATIENTS_SCREENS and view == "patient":
        return {200}
    if needed and ROLES[role] == 0:
        return {401}
    if needed > ROLES[role]:
        return {403}
    return {200, 201, 204, 401, 404, 409, 415, 422, 503} if needed == 0 else {200, 201, 204, 404, 409, 415, 422, 503}


def test_no_websocket_opens_for_nobody(clinic: Clinic) -> None:
    sockets = {context.path for context in contexts(clinic.client.app, APIWebSocketRoute)}  # type: ignore[arg-type]
    views = {"/view/{role}", "/view/{role}/", "/view/replay/{word}", "/view/replay/{word}/"}
    of_pages = {"/api/v1/live", "/api/v1/screen", "/api/v1/patient/live"}
    assert sockets == of_pages | {"/api/v1/camera", "/api/v1/phone"} | views
    for path in sockets:
        named = path.replace("{role}", "clinician").replace("{word}", "no-such-word")
        url = f"{BASE.replace('http', 'ws')}{named}"
        with pytest.raises(WebSocketDisconnect), clinic.client.websocket_connect(url, headers={"Origin": BASE}):
            pytest.fail(f"{path} was accepted")
