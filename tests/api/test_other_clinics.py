"""Ids of another clinic: 404, as for ids that do not exist, and a row in the log; for every id of every route."""

import re
from collections.abc import Iterator
from typing import Any

import pytest
from fake_clinic import Clinic

from app.api import refusals
from app.clock import utc_now
from app.refusals import DiskFull
from app.speeds import HIGHEST_SPEEDS
from app.store import tables
from app.store.chairs import add_chair
from app.store.interface_tests import add_interface_test
from app.store.keeping.incidents import mark_incident
from app.store.patient_screens import add_screen
from app.store.patients import add_patient, start_session
from app.store.people import add_clinic, add_person
from app.store.records.consents import give_consent
from app.store.runs import add_run, add_trial
from app.store.sharing.comments import add_comment
from app.store.sharing.share_links import add_share

IDS = {  # names of whole numbers that are ids, and of which table
    "patient_id": "patient",
    "patient": "patient",
    "trial_id": "trial",
    "test_id": "interface_test",
    "trial": "trial",
    "against": "trial",
    "chair_id": "chair",
    "screen_id": "patient_screen",
    "person_id": "person",
    "incident_id": "incident",
    "patients": "patient",
    "session_id": "session",
    "note_id": "session",  # a note and a scale are those of the session that the path names
    "scale_id": "session",
    "comment_id": "moment_comment",
    "share_id": "share_link",
    "other": "session",
    "PUT /chairs/chosen id": "chair",
}
# Whole numbers that are no ids.
NUMBERS = {
    "stops",
    "port",
    "seed",
    "baud",
    "address",
    "version",
    "direction",
    "before",
    "seconds",
    "hour",
    "years",
    "place",
} | {
    "session",
    "days",
    *("mental", "physical", "temporal", "performance", "effort", "frustration"),
}
FILLED = {
    "other": "1",
    "form": "csv",
    "reason": "by hand",
    "dynamics": "unicycle",
    "floorplan": "apartment",
    "path": "main",
}
LISTS = {"patients"}
OWN_PERSON = "1"  # the person who asks, where a path needs an id besides the one that is tried
BODIES: dict[str, dict[str, Any]] = {  # what has to be sent along with an id
    "PUT /interface-tests/{test_id}/workload": {"mental": 5},
    "POST /trials/{trial_id}/discard": {"reason": "x"},
    "PUT /chairs/chosen": {"dynamics": "unicycle"},
    "POST /incidents/{incident_id}/lifting": {"reason": "It is closed"},
    "POST /people": {"name": "Ben", "role": "reviewer"},
    "PUT /people/{person_id}": {"role": "reviewer"},
    "PUT /sessions/{session_id}/goal": {"goal": "x"},
    "POST /sessions/{session_id}/notes": {"text": "x"},
    "PUT /sessions/{session_id}/notes/{note_id}": {"text": "x"},
    "POST /sessions/{session_id}/scales": {"name": "SCIM III", "total": 41.0, "day": "2026-03-01"},
    "POST /sessions/{session_id}/unlock": {"reason": "x"},
    "POST /trials/{trial_id}/comments": {"t": 1.0, "text": "x"},
    "POST /trials/{trial_id}/comments/read": {},
    "PUT /comments/{comment_id}": {"text": "x"},
    "POST /patients/{patient_id}/shares": {"days": 14},
    "POST /sessions/{session_id}/shares": {"days": 14},
    "PUT /patients/{patient_id}/consents/{consent}": {"given": "2026-03-01"},
}
MISSING = 2**31 - 1  # an id that nothing has


def integers(document: dict[str, Any], schema: dict[str, Any], name: str = "") -> Iterator[str]:
    """Yield the names of all whole numbers in a schema, at any depth."""
    if "$ref" in schema:
        yield from integers(document, document["components"]["schemas"][schema["$ref"].rsplit("/", 1)[1]], name)
    if schema.get("type") == "integer":
        yield name
    for key in ("anyOf", "oneOf", "allOf", "prefixItems"):
        for inner in schema.get(key, []):
            yield from integers(document, inner, name)
    for inner in (schema.get("items"), schema.get("additionalProperties")):
        if isinstance(inner, dict):
            yield from integers(document, inner, name)
    for inner_name, inner in schema.get("properties", {}).items():
        yield from integers(document, inner, inner_name)


def places(document: dict[str, Any]) -> Iterator[tuple[str, str, str, list[str]]]:
    """Yield method, path, name of a whole number and the names of everything else that has to be sent along."""
    for path, methods in document["paths"].items():
        for method, operation in methods.items():
            given = operation.get("parameters", [])
            needed = [parameter["name"] for parameter in given if parameter["in"] == "query" and parameter["required"]]
            for parameter in given:
                for name in integers(document, parameter["schema"], parameter["name"]):
                    yield method.upper(), path, name, needed
            content = operation.get("requestBody", {}).get("content", {}).get("application/json", {})
            for name in integers(document, content.get("schema", {})):
                yield method.upper(), path, name, needed


def table_of(method: str, path: str, name: str) -> str | None:
    return IDS.get(f"{method} {path.removeprefix('/api/v1')} {name}") or IDS.get(name)


@pytest.fixture
def theirs(signed_in: Clinic) -> dict[str, int]:
    """Return the ids of what another clinic has in the same database, by table."""
    with signed_in.client.app.state.people.database.transaction() as db:  # type: ignore[attr-defined]
        clinic = add_clinic(db, "Another clinic")
        patient = add_patient(db, clinic.id, "P-9", "Otter", "")
        session = start_session(db, clinic.id, patient.id)
        run = add_run(db, "their-run", session.id, "drive", "their-run")
        chair = add_chair(db, clinic, "Red", "10.0.0.9", 5354, 1, HIGHEST_SPEEDS)
        add_screen(db, session.id, "Eve", None)
        screen = db.query(tables.PatientScreen).one()
        profile = tables.Profile(
            patient_id=patient.id, session_id=session.id, version=1, document={}, created=utc_now(), parent=None
        )
        db.add(profile)
        db.flush()
        parameters = tables.Parameters(
            profile_id=profile.id,
            title="Set",
            settings={},
            hash="0" * 64,
            created=utc_now(),
            current=True,
            abandoned=False,
        )
        db.add(parameters)
        db.flush()
        trial = add_trial(
            db,
            run=run,
            clinic_id=clinic.id,
            patient_id=patient.id,
            parameters_id=parameters.id,
            floorplan="apartment",
            floorplan_title="Apartment",
            path="main",
            path_points=[[0.0, 0.0]],
        )
        trial.status = "done"
        test = add_interface_test(db, run=run, session=session, parameters_id=parameters.id, plan={})
        test.status = "done"
        person = add_person(db, clinic, "Eve", "owner", None)
        comment = add_comment(db, trial, person.id, 1.0, "Theirs.")
        give_consent(db, patient.id, "sharing", utc_now().date(), "Eve")
        link, _ = add_share(db, clinic.id, patient.id, None, "hash", 14, "Eve")
        return {
            "person": person.id,
            "patient": patient.id,
            "trial": trial.id,
            "interface_test": test.id,
            "session": session.id,
            "chair": chair.id,
            "patient_screen": screen.id,
            "incident": mark_incident(db, clinic.id, utc_now(), "0" * 64, [patient.id], None).id,
            "moment_comment": comment.id,
            "share_link": link.id,
        }


def test_every_whole_number_of_every_route_is_known_as_an_id_or_as_none(signed_in: Clinic) -> None:
    found = list(places(signed_in.good("GET", "/openapi.json")))
    unknown = {(method, path, name) for method, path, name, _ in found if not table_of(method, path, name)}
    assert {name for _, _, name in unknown} <= NUMBERS, "say in IDS of which table this id is, or put it in NUMBERS"
    assert {table_of(method, path, name) for method, path, name, _ in found} >= set(IDS.values())
    # An id in a path is an id whatever it is called.
    assert not [place for place in unknown if f"{{{place[2]}}}" in place[1]]


def test_another_clinics_ids_do_not_exist_here_and_asking_for_one_is_noted(
    signed_in: Clinic, theirs: dict[str, int]
) -> None:
    asked = []
    for method, path, name, needed in places(signed_in.good("GET", "/openapi.json")):
        table = table_of(method, path, name)
        if table is None:
            continue

        def ask(number: int, method: str = method, path: str = path, name: str = name, needed: Any = needed) -> Any:
            in_path = f"{{{name}}}" in path
            url = path.removeprefix("/api/v1").replace(f"{{{name}}}", str(number))
            more = {other: FILLED[other] for other in needed if other != name}
            body = BODIES.get(f"{method} {path.removeprefix('/api/v1')}")
            url = url.replace("{person_id}", OWN_PERSON).replace("{trial_id}", str(number))
            for own in ("{session_id}", "{note_id}", "{scale_id}"):
                url = url.replace(own, str(number))
            url = url.replace("{consent}", "sharing")
            if not in_path and method == "GET":
                more[name] = str(number)
            elif not in_path:
                body = BODIES.get(f"{method} {path.removeprefix('/api/v1')}", {}) | {
                    name: [number] if name in LISTS else number
                }
            return signed_in(method, url, params=more, json=body)

        rows = len(signed_in.log())
        missing = ask(MISSING)
        assert len(signed_in.log()) == rows, (method, path)
        refused = ask(theirs[table])
        assert (refused.status_code, missing.status_code) == (404, 404), (method, path, refused.text)
        assert re.sub(r"\d+", "N", refused.text) == re.sub(r"\d+", "N", missing.text)
        (row,) = signed_in.log()[rows:]
        assert (row.person, row.what, row.details) == (
            "Demo clinician",
            "another clinic's id",
            {table: theirs[table]},
        ), (method, path)
        asked.append((method, path))
    assert len(asked) >= 15


def test_a_full_disk_does_not_tell_that_it_exists(
    signed_in: Clinic, theirs: dict[str, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_given: Any, **_more: Any) -> None:
        raise DiskFull("The disk is full.")

    monkeypatch.setattr(refusals, "write_log", full)
    assert signed_in("DELETE", f"/patients/{theirs['patient']}").status_code == 404
