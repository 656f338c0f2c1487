"""A deleted patient is hidden everywhere at once: each route answers as for an id that does not exist."""

import json
import re
from typing import Any

import pytest
from fake_clinic import Clinic
from fastapi.routing import APIRoute
from test_other_clinics import BODIES, FILLED, MISSING, places, table_of
from test_roles import contexts, requested
from test_shown_patients import HIDDEN, reviewed

__all__ = ["reviewed"]  # the fixture: a patient called HIDDEN with a trial, and another one

# What an owner does with deleted patients: undo, erase, and read the log of what was done.
FOR_DELETED = {"POST /patients/{patient_id}/restore", "POST /deleted-patients/{patient_id}/erasure", "GET /log"}
SHOWS_DELETED = {"GET /backups"}


@pytest.fixture
def deleted(reviewed: Clinic) -> Clinic:
    clinic = reviewed
    clinic.trial = clinic.good("GET", "/trials", params={"patient": clinic.patient["id"]})[0]["id"]  # type: ignore[attr-defined]
    clinic.good("DELETE", "/session")
    assert HIDDEN in json.dumps(clinic.good("GET", "/patients"))
    clinic.good("DELETE", f"/patients/{clinic.patient['id']}")
    return clinic


def test_every_route_answers_as_for_an_id_that_does_not_exist(deleted: Clinic) -> None:
    hidden = {"patient": deleted.patient["id"], "trial": deleted.trial}  # type: ignore[attr-defined]
    tried = []
    for method, path, name, needed in places(deleted.good("GET", "/openapi.json")):
        route, table = f"{method} {path.removeprefix('/api/v1')}", table_of(method, path, name)
        if table not in hidden or route in FOR_DELETED:
            continue

        def ask(number: int, method: str = method, path: str = path, name: str = name, needed: Any = needed) -> Any:
            url = path.removeprefix("/api/v1").replace(f"{{{name}}}", str(number)).replace("{trial_id}", str(number))
            more = {other: FILLED[other] for other in needed if other != name}
            body = BODIES.get(f"{method} {path.removeprefix('/api/v1')}")
            if f"{{{name}}}" not in path and method == "GET":
                more[name] = str(number)
            elif f"{{{name}}}" not in path:
                body = (body or {}) | {name: number}
            return deleted(method, url, params=more, json=body)

        missing, refused = ask(MISSING), ask(hidden[table])
        assert missing.status_code == refused.status_code, (route, refused.text)
        assert refused.status_code in {404, 409, 422}, (route, refused.text)
        assert re.sub(r"\d+", "N", refused.text) == re.sub(r"\d+", "N", missing.text), route
        tried.append(route)
    assert len(tried) >= 12


def test_no_answer_names_a_deleted_patient(deleted: Clinic) -> None:
    gets = [
        f"{method} {context.path.removeprefix('/api/v1')}"
        for context in contexts(deleted.client.app, APIRoute)  # type: ignore[arg-type]
        for method in context.methods & {"GET"}
    ]
    answers = {name: requested(deleted, name).text for name in gets}
    assert {name for name, text in answers.items() if HIDDEN in text or "Zebra" in text} == SHOWS_DELETED
    deleted.good("POST", f"/patients/{deleted.patient['id']}/restore")
    assert HIDDEN in requested(deleted, "GET /patients").text
    assert deleted.good("GET", f"/trials/{deleted.trial}")["id"] == deleted.trial  # type: ignore[attr-defined]
