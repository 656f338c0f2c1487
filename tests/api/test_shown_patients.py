"""A reviewer of chosen patients: every other patient does not exist, in any route, list, socket or 3D view."""

import asyncio
import json
import re
from contextlib import ExitStack
from typing import Any

import pytest
from api.fake_clinic import BASE, Clinic, is_news, next_message
from api.routes_with_ids import MISSING, places
from api.served_routes import requested, routes_of
from api.test_roles import FOR_REVIEWERS
from api.view.served_view import VIEW, serve_view
from starlette.responses import Response
from starlette.testclient import TestClient
from starlette.types import Receive, Scope, Send
from starlette.websockets import WebSocketDisconnect

from app.api.guard import Guard
from app.scene.client_messages import SUBPROTOCOL
from app.settings import Settings
from app.store.access.visible_patients import VISIBLE_PATIENTS, VisiblePatients
from app.store.tables import ParameterSet, Patient, PatientSession, Profile, Run, Table, Trial

SHOWN, HIDDEN = "SHOWN-1", "HIDDEN-2"


@pytest.fixture
def reviewed(calibrated: Clinic) -> Clinic:
    """Return a clinic where a patient called HIDDEN is here, with a trial, and one called SHOWN was here."""
    clinic = calibrated
    clinic.rename_patient(HIDDEN, "Zebra")
    clinic.drive_trial()
    clinic.shown = clinic.add_patient(SHOWN)  # type: ignore[attr-defined]
    return clinic


def reviewer(clinic: Clinic, *patients: int) -> dict[str, str]:
    """Return the cookies of a reviewer to whom these patients are shown."""
    return clinic.cookies_of(f"Rita {len(patients)}", "reviewer", list(patients))


def live_picture(clinic: Clinic) -> Any:
    with clinic.socket("/live") as socket:
        return socket.receive_json()


def test_the_id_of_another_patient_is_answered_like_one_that_does_not_exist(reviewed: Clinic) -> None:
    document = reviewed.good("GET", "/openapi.json")
    trial = reviewed.good("GET", "/trials", params={"patient": reviewed.patient["id"]})[0]["id"]
    hidden = {"patient": reviewed.patient["id"], "trial": trial, "session": int(reviewed.session)}
    tried = []
    with reviewed.as_person(reviewer(reviewed, reviewed.shown)):  # type: ignore[attr-defined]
        for place in places(document):
            if place.table not in hidden or place.route not in FOR_REVIEWERS:
                continue
            missing, refused = place.asked(reviewed, MISSING), place.asked(reviewed, hidden[place.table])
            assert (missing.status_code, refused.status_code) == (404, 404), (place.route, refused.text)
            assert re.sub(r"\d+", "N", refused.text) == re.sub(r"\d+", "N", missing.text), place.route
            tried.append(place.route)
    assert len(tried) >= 7


def test_no_answer_to_a_reviewer_names_another_patient(reviewed: Clinic) -> None:
    gets = routes_of(reviewed, {"GET"})
    said = json.dumps([requested(reviewed, name).text for name in gets])
    assert HIDDEN in said  # the owner sees the patient in these answers
    with reviewed.as_person(reviewer(reviewed, reviewed.shown)):  # type: ignore[attr-defined]
        answers = {name: requested(reviewed, name).text for name in gets}
        assert {name for name, text in answers.items() if HIDDEN in text or "Zebra" in text} == set()
        assert [patient["code"] for patient in reviewed.good("GET", "/patients")] == [SHOWN]
        assert reviewed.good("GET", "/session")["session"] is None
        assert reviewed.good("GET", "/start")["session"]["patient"] is None
        assert "No session is open" in reviewed("GET", "/adaptation").json()["detail"]
        assert reviewed.good("GET", "/drives/summary")["parameters"] is None


def test_the_open_session_is_shown_live_to_the_reviewers_of_its_patient_only(
    reviewed: Clinic, monkeypatch: pytest.MonkeyPatch
) -> None:
    serve_view(monkeypatch)
    session = reviewed.good("GET", "/session")["session"]["id"]
    with reviewed.as_person(reviewer(reviewed, reviewed.shown)):  # type: ignore[attr-defined]
        picture = live_picture(reviewed)
        assert (picture["hidden"], picture["session"], picture["gestures"]) == (True, None, [])
        with pytest.raises(WebSocketDisconnect) as refused, reviewed.client.websocket_connect(**VIEW):
            pass
        assert refused.value.code == 4409
    with reviewed.as_person(reviewer(reviewed, reviewed.shown, reviewed.patient["id"])):  # type: ignore[attr-defined]
        picture = live_picture(reviewed)
        assert (picture["hidden"], picture["session"]) == (False, session)
        assert picture["gestures"]
        with reviewed.client.websocket_connect(**VIEW) as socket:
            assert socket.accepted_subprotocol == SUBPROTOCOL


def test_the_plan_of_the_running_trial_is_for_those_who_may_see_its_patient(reviewed: Clinic) -> None:
    others, own = reviewer(reviewed, reviewed.shown), reviewer(reviewed, reviewed.shown, reviewed.patient["id"])  # type: ignore[attr-defined]
    trial = reviewed.start_trial()["id"]
    with reviewed.as_person(own):
        assert reviewed.good("GET", "/view/clinician/plan")["trial"] == trial
    with reviewed.as_person(others):
        assert reviewed.good("GET", "/view/clinician/plan") is None
        assert live_picture(reviewed)["trial"] is None


def test_a_session_of_a_shown_patient_appears_at_once(reviewed: Clinic) -> None:
    cookies = reviewer(reviewed, reviewed.shown)  # type: ignore[attr-defined]
    with ExitStack() as stack:
        with reviewed.as_person(cookies):
            socket = stack.enter_context(reviewed.socket("/live"))
            assert socket.receive_json()["hidden"] is True
        reviewed.open_session(reviewed.shown)  # type: ignore[attr-defined]
        picture = next_message(socket, lambda m: not m["hidden"], most=100)
    assert picture["session"] == reviewed.good("GET", "/session")["session"]["id"]


def test_news_of_another_patient_reaches_no_reviewer(reviewed: Clinic) -> None:
    shown, hidden = reviewed.shown, reviewed.patient["id"]  # type: ignore[attr-defined]
    with ExitStack() as stack:
        with reviewed.as_person(reviewer(reviewed, shown)):
            socket = stack.enter_context(reviewed.socket("/live"))
            socket.receive_json()
        reviewed.good("DELETE", f"/patients/{hidden}/consents/recording")
        session = reviewed.open_session(shown)["session"]["id"]  # ends the other one, which is news, too
        news = next_message(socket, lambda m: m.get("news", {}).get("patient"))["news"]
    assert news == {"what": "session", "patient": shown, "session": session, "trial": None}


def test_a_deletion_and_its_undoing_are_told_to_those_who_could_see_the_patient(reviewed: Clinic) -> None:
    shown, hidden = reviewed.shown, reviewed.add_patient("HIDDEN-3")  # type: ignore[attr-defined]
    with ExitStack() as stack:
        with reviewed.as_person(reviewer(reviewed, shown)):
            socket = stack.enter_context(reviewed.socket("/live"))
            socket.receive_json()
        for patient in (hidden, shown):
            reviewed.good("DELETE", f"/patients/{patient}")
        told = next_message(socket, is_news("deletion"))["news"]
        assert told == {"what": "deletion", "patient": shown, "session": None, "trial": None}
        for patient in (hidden, shown):
            reviewed.good("POST", f"/patients/{patient}/restore")
        assert next_message(socket, is_news("restoration"))["news"] == told | {"what": "restoration"}


def test_until_it_is_known_who_asks_no_patient_exists(settings: Settings) -> None:
    visible: dict[str, VisiblePatients] = {}

    async def note(scope: Scope, receive: Receive, send: Send) -> None:
        visible[scope["type"]] = VISIBLE_PATIENTS.get()
        if scope["type"] == "http":
            await Response()(scope, receive, send)

    guard = Guard(note, settings)
    TestClient(guard, base_url=BASE).get("/api/v1/patients")
    for kind in ("websocket", "lifespan"):  # whose start is the program's own work
        asyncio.run(guard({"type": kind}, None, None))  # type: ignore[arg-type]
    assert visible == {"http": frozenset(), "websocket": frozenset(), "lifespan": None}


def test_what_is_of_a_patient_is_left_out_of_every_query(reviewed: Clinic) -> None:
    """Every table with a way to a patient is restricted, also one that is added later."""
    database = reviewed.database
    of_patients = {"patient", "session", "patient_screen", "calibration_step", "run", "profile", "parameters", "trial"}
    with database.transaction() as db:
        before = {mapper.class_: db.query(mapper.class_).count() for mapper in Table.registry.mappers}
    token = VISIBLE_PATIENTS.set(frozenset())
    try:
        with database.transaction() as db:
            after = {kind: db.query(kind).count() for kind in before}
            for kind in (Patient, PatientSession, Profile, ParameterSet, Trial):
                assert db.get(kind, 1) is None
    finally:
        VISIBLE_PATIENTS.reset(token)
    reaching = {"patient"}
    while more := {
        table.name
        for table in Table.metadata.tables.values()
        for key in table.foreign_keys
        if key.column.table.name in reaching and not key.parent.nullable and table.name not in reaching
    }:
        reaching |= more
    assert reaching >= of_patients
    assert {kind.__tablename__ for kind in before if after[kind] != 0 and kind.__tablename__ in reaching} == set()
    assert all(after[kind] == before[kind] for kind in before if kind.__tablename__ not in reaching)
    assert min(before[Run], before[Trial]) > 0
