"""Whoever reads something of a patient stands in the log, whatever route answers."""

import re
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import timedelta
from typing import Any

import pytest
from api.fake_clinic import Clinic, next_message
from api.served_routes import filled, requested, routes_of

from app.store import log
from app.store.log import LISTED, VIEWED

# Rows that name the patient, the session or the trial; routes that say nothing of the patient.
ROWS = {VIEWED, "session viewed", "trial viewed", "export", "report exported"}
LISTS = {LISTED, "patients viewed by attention"}  # rows of all patients
SILENT = {"/patients/{patient_id}/archive/room"}  # how large the recordings are


@contextmanager
def watching(clinic: Clinic, cookies: dict[str, str]) -> Iterator[Any]:
    """Open the live socket of another person."""
    with clinic.as_person(cookies):
        opening = clinic.socket("/live")
        socket = opening.__enter__()
    yield socket
    opening.__exit__(None, None, None)


def viewings(clinic: Clinic, person: str) -> list[int]:
    """Return the ids of the patients whose viewing by a person is in the log."""
    return [row.details["patient"] for row in clinic.log() if row.what == VIEWED and row.person == person]


def test_every_route_that_answers_with_something_of_a_patient_is_logged(
    calibrated: Clinic, trial: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(log, "VIEWED_EVERY", timedelta(0))
    calibrated.good("DELETE", "/session")
    patient = calibrated.patient["id"]
    driven = calibrated.good("GET", f"/trials?patient={patient}")[0]
    ids = {"patient_id": patient, "session_id": calibrated.session, "trial_id": trial}
    needed = {"floorplan": driven["floorplan"], "path": driven["path"], "source": "simulated", "patient": patient}
    silent, answered = [], 0
    for route in routes_of(calibrated, {"GET"}):
        name = route.removeprefix("GET ")
        placeholders = set(re.findall(r"\{(\w+)\}", name))
        if not placeholders or placeholders - ids.keys() or name in SILENT:
            continue
        before = len(calibrated.log())
        answer = calibrated("GET", filled(name, **ids), params=needed)
        if answer.status_code == 200:
            answered += 1
            if not ROWS & {row.what for row in calibrated.log()[before:]}:
                silent.append(name)
    assert answered > 10
    assert silent == []


def test_every_answer_that_names_the_patient_who_is_here_is_logged(
    calibrated: Clinic, trial: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Routes without a patient in their address, too: those of the open session."""
    monkeypatch.setattr(log, "VIEWED_EVERY", timedelta(0))
    code, pseudonym = "P-4711", "Dragonfly"
    calibrated.rename_patient(code, pseudonym)
    named, silent = set(), set()
    for route in routes_of(calibrated, {"GET"}):
        name = route.removeprefix("GET ")
        if name in SILENT:
            continue
        before = len(calibrated.log())
        answer = requested(calibrated, route)
        if answer.status_code == 200 and (code in answer.text or pseudonym in answer.text):
            named.add(name)
            if not (ROWS | LISTS) & {row.what for row in calibrated.log()[before:]}:
                silent.add(name)
    assert {"/start", "/session", "/patients", "/sessions/{session_id}/story"} <= named
    assert silent == set()


@pytest.mark.parametrize("path", ["/start", "/session"])
def test_who_is_told_who_is_here_stands_in_the_log_once(calibrated: Clinic, path: str) -> None:
    here = calibrated.patient["id"]
    with calibrated.as_person(calibrated.cookies_of("Rita", "reviewer", [here])):
        for _ in range(3):
            calibrated.good("GET", path)
    with calibrated.as_person(calibrated.cookies_of("Otto", "reviewer", [])):
        calibrated.good("GET", path)  # it says that nobody is here
    assert (viewings(calibrated, "Rita"), viewings(calibrated, "Otto")) == ([here], [])


def test_who_watches_a_session_live_stands_in_the_log_from_the_first_picture_of_each_patient(calibrated: Any) -> None:
    first, second = calibrated.patient["id"], calibrated.add_patient("P-2")
    rita, otto = calibrated.cookies_of("Rita", "reviewer", None), calibrated.cookies_of("Otto", "reviewer", [second])
    with watching(calibrated, rita) as ritas, watching(calibrated, otto) as ottos:
        for _ in range(3):  # pictures of one patient make one row
            assert not ritas.receive_json()["hidden"]
        assert ottos.receive_json()["hidden"]
        calibrated.open_session(second)
        session = int(calibrated.session)
        for socket in (ritas, ottos):
            next_message(socket, lambda m: m["session"] == session)
        while not (len(viewings(calibrated, "Rita")) > 1 and viewings(calibrated, "Otto")):
            ritas.receive_json()  # rows are written beside the pictures
    assert (viewings(calibrated, "Rita"), viewings(calibrated, "Otto")) == ([first, second], [second])
