"""Patients, as their page asks for them."""

import json
from typing import Any


def test_nobody_signed_in_sees_no_patient(clinic: Any) -> None:
    for path in ("patients", "session", "equipment", "calibration", "controls", "floorplans", "trials?patient=1"):
        assert clinic.refused(401, "GET", f"/{path}").startswith("You are not signed in")


def test_a_patient_is_added_deleted_and_brought_back(signed_in: Any) -> None:
    patient = signed_in.good("POST", "/patients", json={"code": "P-1", "pseudonym": "Heron", "note": "left-handed"})
    assert (patient["sessions"], patient["trials"], patient["last_seen"]) == (0, 0, None)
    refused = signed_in.refused(409, "POST", "/patients", json={"code": "P-1", "pseudonym": "Otter"})
    assert "choose another code" in refused
    signed_in.good("DELETE", f"/patients/{patient['id']}")
    assert signed_in.good("GET", "/patients") == []
    signed_in.good("POST", f"/patients/{patient['id']}/restore")
    assert signed_in.good("GET", "/patients")[0]["pseudonym"] == "Heron"
    assert signed_in("DELETE", "/patients/999").status_code == 404


def test_bad_input_is_one_sentence_and_adds_nobody(signed_in: Any) -> None:
    bodies: list[tuple[Any, str]] = [
        ({"code": "P 1", "pseudonym": "Heron"}, "code"),
        ({"code": "P-1"}, "pseudonym: this is missing"),
        ({"code": "P-1", "pseudonym": "Heron", "name": "Real Name"}, "name: this is not known here"),
        ({"code": float("nan"), "pseudonym": "Heron"}, "code"),
        ([1, 2], "What was sent"),
    ]
    for body, words in bodies:
        sent = {"content": json.dumps(body), "headers": {"Content-Type": "application/json"}}
        assert words in signed_in.refused(422, "POST", "/patients", **sent), body
    assert signed_in.good("GET", "/patients") == []


def test_what_is_not_json_is_said_so(signed_in: Any) -> None:
    refused = signed_in.refused(422, "POST", "/patients", content=b"{", headers={"Content-Type": "application/json"})
    assert refused == "What was sent is not JSON: correct it."


def test_an_open_session_of_another_patient_ends_only_when_the_person_agrees(signed_in: Any) -> None:
    first, second = (signed_in.add_patient(code) for code in ("P-1", "P-2"))
    opened = signed_in.good("POST", "/session", json={"patient_id": first})["session"]
    assert opened["trials"] == 0
    for ends in ({}, {"ends": opened["id"] + 1}):
        words = signed_in.refused(409, "POST", "/session", json={"patient_id": second, **ends})
        assert f"P-1 is open: begun by {opened['opened_by']} at " in words
        assert ", 0 trials. End it first, or confirm" in words
        assert signed_in.good("GET", "/session")["patient"]["id"] == first
    assert signed_in.good("POST", "/session", json={"patient_id": first})["session"] == opened
    now = signed_in.good("POST", "/session", json={"patient_id": second, "ends": opened["id"]})
    assert now["patient"]["id"] == second
