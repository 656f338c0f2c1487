"""The record of a session at the API: written, logged, signed off; then every route that would change it refuses."""

from typing import Any

from api.fake_clinic import Clinic
from api.served_routes import CHANGING, routes_of

from app import __version__

SCALE = {"name": "SCIM III", "total": 41.0, "day": "2026-03-01"}
BODIES: dict[str, dict[str, Any]] = {  # what each route that changes something of a session is sent
    "POST /trials/{trial_id}/discard": {"reason": "x"},
    "POST /trials/{trial_id}/keep": {},
    "PUT /sessions/{session_id}/goal": {"goal": "other"},
    "POST /sessions/{session_id}/notes": {"text": "x"},
    "PUT /sessions/{session_id}/notes/{note_id}": {"text": "other"},
    "POST /sessions/{session_id}/scales": SCALE,
    "DELETE /sessions/{session_id}/scales/{scale_id}": {},
    "POST /sessions/{session_id}/sign-off": {},
}
# What goes on after a sign-off: its unlocking, what people say about it, and who is shown it.
AFTER_SIGN_OFF = {
    *("POST /sessions/{session_id}/unlock", "POST /sessions/{session_id}/shares"),
    *("POST /trials/{trial_id}/comments", "POST /trials/{trial_id}/comments/read"),
}


def write_record(clinic: Clinic, session: int) -> dict[str, Any]:
    clinic.good("PUT", f"/sessions/{session}/goal", json={"goal": "To the kitchen."})
    clinic.good("POST", f"/sessions/{session}/notes", json={"text": "Tired."})
    return clinic.good("POST", f"/sessions/{session}/scales", json=SCALE)


def test_what_is_written_is_answered_and_logged_without_its_words(calibrated: Clinic) -> None:
    trial = calibrated.drive_trial()["id"]
    session = int(calibrated.session)
    found = write_record(calibrated, session)
    note, scale = found["notes"][0]["id"], found["scales"][0]["id"]
    found = calibrated.good("PUT", f"/sessions/{session}/notes/{note}", json={"text": "Tired after lunch."})
    assert [one["text"] for one in found["notes"][0]["revisions"]] == ["Tired after lunch.", "Tired."]
    assert (found["goal"], found["version"], found["sign_off"]) == ("To the kitchen.", __version__, None)
    assert found["scales"] == [{"id": scale, **SCALE}]
    assert [one["id"] for one in found["trials"]] == [trial]
    assert [one["version"] for one in found["sets"]] == [1]
    assert calibrated.good("DELETE", f"/sessions/{session}/scales/{scale}")["scales"] == []
    assert calibrated.good("GET", f"/sessions/{session}")["notes"] == found["notes"]
    (row,) = calibrated.good("GET", f"/patients/{calibrated.patient['id']}/sessions")
    assert (row["id"], row["trials"], row["sign_off"]) == (session, 1, None)
    rows = [one for one in calibrated.log() if one.what.startswith(("goal", "note", "scale"))]
    assert [one.what for one in rows] == ["goal written", "note added", "scale added", "note revised", "scale removed"]
    assert all(one.details["session"] == session and one.person for one in rows)
    assert not any(word in str([one.details for one in rows]) for word in ("Tired", "SCIM", "41.0"))


def test_what_is_not_a_goal_note_or_scale_is_refused_and_nothing_is_kept(in_session: Clinic) -> None:
    session = in_session.session
    wrong: list[tuple[str, str, dict[str, Any]]] = [
        ("PUT", "goal", {"goal": "x" * 1001}),
        ("POST", "notes", {"text": " \n"}),
        ("POST", "scales", {**SCALE, "name": ""}),
        ("POST", "scales", {**SCALE, "total": "41"}),
        ("POST", "scales", {**SCALE, "total": 1e13}),
        ("POST", "scales", {**SCALE, "day": "yesterday"}),
    ]
    for method, path, body in wrong:
        assert in_session(method, f"/sessions/{session}/{path}", json=body).status_code == 422, (path, body)
    found = in_session.good("GET", f"/sessions/{session}")
    assert (found["goal"], found["notes"], found["scales"]) == ("", [], [])


def test_every_route_that_changes_something_of_a_session_refuses_a_signed_one(calibrated: Clinic) -> None:
    trial, session = calibrated.drive_trial()["id"], int(calibrated.session)
    found = write_record(calibrated, session)
    note, scale = found["notes"][0]["id"], found["scales"][0]["id"]
    values = {"trial_id": trial, "session_id": session, "note_id": note, "scale_id": scale}
    signed = calibrated.good("POST", f"/sessions/{session}/sign-off")
    assert signed["ended"] is not None
    assert calibrated.session == "none"  # it ended with the sign-off
    routes = {route for route in routes_of(calibrated, CHANGING) if "{session_id}" in route or "{trial_id}" in route}
    assert routes - AFTER_SIGN_OFF == {*BODIES}
    before = calibrated.good("GET", f"/sessions/{session}")
    for route, body in BODIES.items():
        method, path = route.split()
        words = calibrated.refused(409, method, path.format(**values), json=body)
        assert words.startswith("Session 1 was signed off by Demo clinician on "), route
        assert words.count(". ") == 0
    assert calibrated.good("GET", f"/sessions/{session}") == before


def test_an_owner_unlocks_for_a_reason_and_the_history_stays(calibrated: Clinic) -> None:
    session = int(calibrated.session)
    unlock = f"/sessions/{session}/unlock"
    assert calibrated("POST", unlock, json={"reason": "x"}).status_code == 409
    calibrated.good("POST", f"/sessions/{session}/sign-off")
    assert calibrated("POST", unlock, json={"reason": " "}).status_code == 422
    with calibrated.as_person(calibrated.cookies_of("Cleo")):
        assert calibrated("POST", unlock, json={"reason": "a wrong scale"}).status_code == 403
    found = calibrated.good("POST", unlock, json={"reason": "a wrong scale"})
    assert found["sign_off"] is None
    assert [(one["person"], one["reason"]) for one in found["sign_offs"]] == [("Demo clinician", "a wrong scale")]
    calibrated.good("PUT", f"/sessions/{session}/goal", json={"goal": "To the garden."})
    rows = [(one.what, one.details.get("signed_by")) for one in calibrated.log()]
    assert ("session unlocked", "Demo clinician") in rows


def test_an_open_session_is_not_signed_off_while_something_is_recorded(calibrated: Clinic) -> None:
    session = calibrated.session
    step = calibrated.good("GET", "/calibration")["steps"][0]["id"]
    calibrated.good("POST", f"/calibration/steps/{step}/start")
    assert "A calibration step is running." in calibrated.refused(409, "POST", f"/sessions/{session}/sign-off")
    assert calibrated.session == session
    calibrated.good("POST", f"/calibration/steps/{step}/cancel")
    calibrated.good("POST", f"/sessions/{session}/sign-off")


def test_two_sessions_are_compared_by_task_and_by_what_changed(calibrated: Clinic) -> None:
    patient, first = calibrated.patient["id"], int(calibrated.session)
    for _ in range(4):
        calibrated.drive_trial()
    calibrated.good("POST", f"/sessions/{first}/sign-off")
    calibrated.open_session(patient)
    second = int(calibrated.session)
    calibrated.drive_trial()
    found = calibrated.good("GET", f"/sessions/{second}/comparison", params={"other": first})
    assert (found["earlier"]["id"], found["later"]["id"]) == (first, second)
    (task,) = found["tasks"]
    assert (task["trials"], task["counted"], task["source"]) == ([4, 1], [4, 1], "simulated")
    path = calibrated.good("GET", "/floorplans/apartment")["paths"][0]
    assert (task["path"], task["path_title"]) == (path["name"], path["title"])
    e_diff = task["measures"]["e_diff"]
    assert e_diff["earlier"] == {"median": 1.5, "low": 1.5, "high": 1.5, "trials": 1}  # three to get used to it
    assert e_diff["verdict"]["word"] == "too few"
    assert found["changes"] == []
    assert [one["version"] for one in found["sets"]] == [1, 1]
    again = calibrated("GET", f"/sessions/{first}/comparison", params={"other": first})
    assert (again.status_code, "choose two" in again.text) == (409, True)
    calibrated.open_session(calibrated.add_patient("B-1"))
    two = calibrated("GET", f"/sessions/{first}/comparison", params={"other": int(calibrated.session)})
    assert (two.status_code, "not of one patient" in two.text) == (409, True)
