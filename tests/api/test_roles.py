"""The matrix of roles and routes: every route is requested by every role."""

from collections.abc import Iterator
from typing import Any

import pytest
from api.fake_clinic import BASE, Clinic
from api.pairing import code_of, pair
from fastapi import FastAPI
from fastapi.dependencies.models import Dependant
from fastapi.routing import APIRoute, APIWebSocketRoute, iter_route_contexts
from starlette.websockets import WebSocketDisconnect
from store.known_people import known_clinic, known_person

from app.api.deps import anyone_signed_in, clinician, everyone, exporter, owner, viewer
from app.api.sign_in.identity import SCREEN_COOKIE
from app.api.who_asks import who_asks
from app.store.access.sign_ins import sign_in
from app.store.people import add_person

RIGHTS = {everyone: 0, anyone_signed_in: 1, viewer: 1, clinician: 2, exporter: 2, owner: 3}
ROLES = {
    "nobody": 0,
    "patient's screen": 0,
    "reviewer of all": 1,
    "reviewer by patient": 1,
    "clinician": 2,
    "owner": 3,
}

# What a person may do here is this table, and the code; a new route has to be put in both.
FOR_EVERYONE = {
    "POST /auth/demo",
    "POST /auth/setup",
    "POST /auth/sign-in",
    "POST /auth/unlock",
    "POST /auth/invitation",
    "POST /auth/invitation/accept",
    "POST /auth/sign-out",
    "GET /auth/me",
    "GET /start",
    "GET /reference",
    "POST /control/stop",
    "POST /patient-screen/pair",
    "GET /patient-screen/me",
    "GET /equipment/practice",
    "GET /trust",
    "POST /shared/open",
    "GET /shared",
}
FOR_PATIENTS_SCREENS = {"GET /view/{role}/", "GET /view/{role}/plan"}  # the patient's only
FOR_OWNERS = {
    "POST /chairs",
    "DELETE /chairs/{chair_id}",
    "PUT /limits",
    "PUT /clinic-prior",
    "POST /sessions/{session_id}/unlock",
    "GET /archives",
    "POST /archives",
    "POST /computer/measurement",
    "GET /backups",
    "POST /backups",
    "PUT /backups/settings",
    "PUT /record-keeping",
    "POST /deleted-patients/{patient_id}/erasure",
    "POST /incidents/{incident_id}/lifting",
    "GET /log",
    "GET /log/export",
    "GET /log/check",
    "GET /openapi.json",
    "GET /people",
    "POST /people",
    "PUT /people/{person_id}",
    "POST /people/{person_id}/link",
    "POST /people/{person_id}/disable",
    "POST /people/{person_id}/enable",
}
FOR_REVIEWERS = {
    "GET /attention",
    "GET /sessions/{session_id}/story",
    "GET /comments",
    "GET /trials/{trial_id}/comments",
    "POST /trials/{trial_id}/comments",
    "POST /trials/{trial_id}/comments/read",
    "PUT /comments/{comment_id}",
    "DELETE /comments/{comment_id}",
    "PUT /auth/password",
    "POST /auth/introduction",
    "GET /patients",
    "GET /session",
    "GET /equipment",
    "GET /equipment/sender",
    "GET /equipment/shirts",
    "GET /chairs",
    "GET /limits",
    "GET /clinic-prior",
    "GET /tablets",
    "GET /floorplans",
    "GET /floorplans/{name}",
    "GET /patients/{patient_id}/sessions",
    "GET /patients/{patient_id}/consents",
    "GET /sessions/{session_id}",
    "GET /sessions/{session_id}/comparison",
    "GET /interface-tests",
    "GET /trials",
    "GET /trials/{trial_id}",
    "GET /trials/{trial_id}/timeline",
    "GET /trials/{trial_id}/verdicts",
    "GET /drives",
    "GET /drives/summary",
    "GET /patients/{patient_id}/learning",
    "GET /patients/{patient_id}/trajectories",
    "GET /patients/{patient_id}/next-task",
    "GET /patients/{patient_id}/quality",
    "GET /patients/{patient_id}/maps",
    "GET /adaptation",
    "GET /view/{role}/",
    "GET /view/{role}/plan",
    "POST /replays",
    "POST /replays/{word}/at",
    "DELETE /replays/{word}",
    "GET /view/replay/{word}/",
}


def asked(dependant: Dependant) -> Iterator[Any]:
    """Yield the dependencies of a route, at any depth."""
    for below in dependant.dependencies:
        yield below.call
        yield from asked(below)


def contexts(app: FastAPI, kind: type) -> list[Any]:
    """Return all routes of a kind as they are reached, those of included routers too; each has a path and methods."""
    return [context for context in iter_route_contexts(app.routes) if isinstance(context.original_route, kind)]


def table(app: FastAPI) -> dict[str, int | None]:
    """Return the highest right that each route requires, None when it requires none."""
    rights = {}
    for context in contexts(app, APIRoute):
        right = max((RIGHTS[call] for call in asked(context.dependant) if call in RIGHTS), default=None)
        for method in context.methods - {"HEAD"}:
            rights[f"{method} {context.path.removeprefix('/api/v1')}"] = right
    return rights


def test_every_route_says_whom_it_is_for_and_it_is_the_table(clinic: Clinic) -> None:
    rights = table(clinic.client.app)  # type: ignore[arg-type]
    assert len(rights) >= 50
    assert [name for name, right in rights.items() if right is None] == []
    assert {name for name, right in rights.items() if right == 0} == FOR_EVERYONE
    assert {name for name, right in rights.items() if right == 1} == FOR_REVIEWERS
    assert {name for name, right in rights.items() if right == 3} == FOR_OWNERS


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


def requested(clinic: Clinic, name: str, view: str = "clinician") -> Any:
    """Request a route by its method and path as in the table, without content; return the answer."""
    method, path = name.split()
    for placeholder in (
        "{chair_id}",
        "{patient_id}",
        "{trial_id}",
        "{screen_id}",
        "{person_id}",
        "{session_id}",
        "{share_id}",
    ):
        path = path.replace(placeholder, "1")
    path = path.replace("{comment_id}", "1")
    path = path.replace("{note_id}", "1").replace("{scale_id}", "1").replace("{consent}", "sharing")
    path = path.replace("{name}", "nowhere").replace("{step}", "rest").replace("{role}", view)
    path = path.replace("{word}", "no-such-word").replace("{kind}", "floorplan")
    path = path.replace("{identity}", "20260101T000000Z--nowhere")
    is_frame = path == f"/view/{view}/" or path.startswith("/view/replay/")
    prefix = "" if is_frame and method == "GET" else "/api/v1"
    return clinic.client.request(method, f"{prefix}{path}", headers={"Origin": BASE})


@pytest.mark.parametrize("role", ROLES)
def test_the_matrix_of_roles_and_routes(in_session: Clinic, role: str) -> None:
    """Requests have no content, so that a permitted one is refused for its content only."""
    clinic = in_session
    database = clinic.database
    if role == "patient's screen":
        assert pair(clinic, code_of(clinic)).status_code == 200
        screen = clinic.client.cookies[SCREEN_COOKIE]
    elif role != "nobody":
        with database.transaction() as db:
            patients: list[int] | None = [] if role == "reviewer by patient" else None
            add_person(db, known_clinic(db), role, role.partition(" ")[0], None, patients=patients)
    wrong = []
    for name, right in table(clinic.client.app).items():  # type: ignore[arg-type]
        for view in ("clinician", "patient") if "{role}" in name else ("clinician",):
            clinic.client.cookies.clear()
            if role == "patient's screen":
                clinic.client.cookies[SCREEN_COOKIE] = screen
            elif role != "nobody":
                with database.transaction() as db:  # anew: one of the routes signs out
                    clinic.client.cookies["bodydrive_sign_in"] = sign_in(db, known_person(db, role), "test")
            status = requested(clinic, name, view).status_code
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
    assert sockets == {"/api/v1/live", "/api/v1/screen", "/api/v1/patient/live"} | views
    for path in sockets:
        named = path.replace("{role}", "clinician").replace("{word}", "no-such-word")
        url = f"{BASE.replace('http', 'ws')}{named}"
        with pytest.raises(WebSocketDisconnect), clinic.client.websocket_connect(url, headers={"Origin": BASE}):
            pytest.fail(f"{path} was accepted")
