"""Whoever reads something of a patient stands in the log, whatever route answers."""

from datetime import timedelta
from typing import Any

import pytest
from fake_clinic import Clinic
from fastapi.routing import APIRoute
from test_roles import contexts

from app.store import log

# Rows that name the patient or the trial; routes that say nothing of the patient.
ROWS = {"patient viewed", "trial viewed", "export", "report exported"}
SILENT = {
    "/patients/{patient_id}/archive/room",  # how large the recordings are
}


def test_every_route_that_answers_with_something_of_a_patient_is_logged(
    calibrated: Clinic, trial: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(log, "VIEWED_EVERY", timedelta(0))
    calibrated.good("DELETE", "/session")
    driven = next(one for one in calibrated.good("GET", f"/trials?patient={calibrated.patient['id']}"))
    words = {"{patient_id}": calibrated.patient["id"], "{session_id}": calibrated.session, "{trial_id}": trial}
    needed: dict[str, Any] = {
        "floorplan": driven["floorplan"],
        "path": driven["path"],
        "source": "simulated",
        "patient": calibrated.patient["id"],
    }
    silent, answered = [], 0
    for context in contexts(calibrated.client.app, APIRoute):  # type: ignore[arg-type]
        path = name = context.path.removeprefix("/api/v1")
        for word, value in words.items():
            path = path.replace(word, str(value))
        if "GET" not in context.methods or path == name or "{" in path or name in SILENT:
            continue
        before = len(calibrated.log())
        answer = calibrated("GET", path, params=needed)
        if answer.status_code == 200:
            answered += 1
            if not ROWS & {row.what for row in calibrated.log()[before:]}:
                silent.append(name)
    assert answered > 10
    assert silent == []
