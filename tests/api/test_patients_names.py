"""A patient's pseudonym and note are in the database only: in no address, no row of the log, no name of a file."""

import json
import re
from typing import Any

import pytest
from api.fake_clinic import Clinic

from app.settings import Settings

PATIENT = {"code": "P-77", "pseudonym": "Bartailed", "note": "likes the window"}
# What an address may hold besides numbers: names of plans and their paths, of measures, objects and files, a step of
# the calibration, a role, a source of signals, a choice, the form of a file, and random words. `person` is one who may
# sign in: never a patient.
WORDS_OF_ADDRESSES = {
    *("name", "floorplan", "path", "measure", "kind", "identity", "step", "role", "source", "same_name", "form"),
    *("word", "consent", "course", "person", "language"),
}
NUMBERS = {"integer", "number", "boolean", "null"}


def kinds_of(schema: dict[str, Any]) -> set[Any]:
    """Return the types that a parameter may have; None for one without a type, such as a choice of words."""
    return {one.get("type") for one in schema.get("anyOf", [schema])}


def named_in(text: str) -> list[str]:
    return [value for value in PATIENT.values() if value in text]


def test_a_session_leaves_no_name_in_log_and_file_names(
    signed_in: Clinic, settings: Settings, caplog: pytest.LogCaptureFixture
) -> None:
    patient = signed_in.good("POST", "/patients", json=PATIENT)
    signed_in.open_session(patient["id"])
    signed_in.calibrate()
    signed_in.good("GET", f"/patients/{patient['id']}/quality")
    signed_in.good("DELETE", "/session")
    assert signed_in("POST", "/patients", json=PATIENT).status_code == 409
    signed_in.good("DELETE", f"/patients/{patient['id']}")
    signed_in.good("POST", f"/patients/{patient['id']}/restore")
    rows = [json.dumps([row.what, row.details]) for row in signed_in.log()]
    assert {"patient added", "session opened", "patient deleted"} <= {row.what for row in signed_in.log()}
    files = [str(place.relative_to(settings.state)) for place in settings.state.rglob("*")]
    assert files
    assert named_in("\n".join([*rows, *files, caplog.text])) == []


def test_addresses_hold_numbers_and_words_that_name_nobody(signed_in: Clinic) -> None:
    paths = signed_in.good("GET", "/openapi.json")["paths"]
    words = set()
    for path, methods in paths.items():
        given = [parameter for operation in methods.values() for parameter in operation.get("parameters", [])]
        kinds = {one["name"]: kinds_of(one["schema"]) for one in given if one["in"] in {"path", "query"}}
        words |= {name for name, possible in kinds.items() if not possible <= NUMBERS}
        assert set(re.findall(r"\{(\w+)\}", path)) <= kinds.keys()
    assert words <= WORDS_OF_ADDRESSES, words - WORDS_OF_ADDRESSES
