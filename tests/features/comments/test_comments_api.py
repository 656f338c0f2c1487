"""Comments on a moment: written by who may look, changed by their author only, read by each person."""

from typing import Any

from api.fake_clinic import BASE, Clinic
from api.routes_with_ids import BODIES
from api.served_routes import CHANGING, filled, routes_of

from app.features.comments.service import comment_history

ORIGIN = {"Origin": BASE}

ASKS = {"heartbeat", "status"}  # of the web process itself, or a question that changes nothing
MOMENT = {"t": 1.5, "text": "The left shoulder tires here."}


def test_a_reviewers_comment_reaches_the_clinicians_until_they_have_read_it(calibrated: Clinic, trial: int) -> None:
    with calibrated.as_person(calibrated.cookies_of("Rhea", "reviewer")):
        (made,) = calibrated.good("POST", f"/trials/{trial}/comments", json=MOMENT)
        assert (made["person"], made["is_own"], made["t"], made["unread"]) == ("Rhea", True, 1.5, False)
        assert calibrated.good("GET", "/comments") == []
    (found,) = calibrated.good("GET", "/comments")
    assert (found["revisions"][0]["text"], found["is_own"], found["unread"]) == (MOMENT["text"], False, True)
    assert calibrated.good("GET", f"/comments?patient={calibrated.patient['id']}") == [found]
    assert calibrated("GET", "/comments?patient=999").status_code == 404
    (patient,) = calibrated.good("GET", "/attention")
    assert ("comment", 1, trial) in [(one["reason"], one["number"], one["trial_id"]) for one in patient["reasons"]]
    assert calibrated("POST", f"/trials/{trial}/comments/read", json={}).status_code == 204
    assert calibrated.good("GET", "/comments") == []
    with calibrated.as_person(calibrated.cookies_of("Rhea", "reviewer")):
        calibrated.good("PUT", f"/comments/{made['id']}", json={"text": "The right one."})
    (again,) = calibrated.good("GET", "/comments")  # a revision is read anew
    assert [one["text"] for one in again["revisions"]] == ["The right one.", MOMENT["text"]]


def test_who_reads_comments_or_the_list_of_patients_stands_in_the_log_once(calibrated: Clinic, trial: int) -> None:
    patient = calibrated.patient["id"]

    def rows(person: str) -> list[tuple[str, Any]]:
        looks = [row for row in calibrated.log() if row.what in {"patient viewed", "patients listed"}]
        return [(row.what, row.details.get("patient")) for row in looks if row.person == person]

    calibrated.good("POST", f"/trials/{trial}/comments", json=MOMENT)
    for name in ("Rhea", "Rita"):
        with calibrated.as_person(calibrated.cookies_of(name, "reviewer")):
            for _ in range(2):
                calibrated.good("GET", "/comments" if name == "Rita" else f"/trials/{trial}/comments")
                calibrated.good("GET", "/patients")
        assert rows(name) == [("patient viewed", patient), ("patients listed", None)]
    with calibrated.as_person(calibrated.cookies_of("Rolf", "reviewer")):
        assert calibrated("POST", f"/trials/{trial}/comments/read", json={}).status_code == 204
        assert calibrated.good("GET", "/comments") == []
    assert rows("Rolf") == []  # nothing of anybody was shown


def test_only_its_author_revises_or_withdraws_a_comment_and_the_history_stays(calibrated: Clinic, trial: int) -> None:
    (made,) = calibrated.good("POST", f"/trials/{trial}/comments", json=MOMENT)
    path = f"/comments/{made['id']}"
    for role in ("reviewer", "owner"):
        with calibrated.as_person(calibrated.cookies_of(role, role)):
            assert calibrated("PUT", path, json={"text": "x"}).status_code == 409
            assert calibrated("DELETE", path).status_code == 409
    assert calibrated.good("DELETE", path) == []
    assert calibrated("PUT", path, json={"text": "x"}).status_code == 409
    with calibrated.database.transaction() as db:
        assert [row.text for row in comment_history(db, made["id"])] == [MOMENT["text"]]
    whats = [(row.what, row.person) for row in calibrated.log() if row.what.startswith("comment")]
    assert whats == [("comment added", "Demo clinician"), ("comment withdrawn", "Demo clinician")]
    assert not any(str(MOMENT["text"]) in str(row.details) for row in calibrated.log())


def test_a_comment_is_bounded_and_has_a_moment_of_the_time_line(calibrated: Clinic, trial: int) -> None:
    for wrong in (
        *({"t": -90_000.0}, {"t": 90_000.0}, {"t": "1"}),
        *({"text": " "}, {"text": "x" * 2001}, {"text": "a\u202eb"}),
    ):
        assert calibrated("POST", f"/trials/{trial}/comments", json=MOMENT | wrong).status_code == 422, wrong
    assert calibrated.good("GET", f"/trials/{trial}/comments") == []


def test_a_reviewer_sees_no_comment_of_a_patient_who_is_not_shown(calibrated: Clinic, trial: int) -> None:
    (made,) = calibrated.good("POST", f"/trials/{trial}/comments", json=MOMENT)
    with calibrated.as_person(calibrated.cookies_of("Ron", "reviewer", [])):
        assert calibrated.good("GET", "/comments") == calibrated.good("GET", "/attention") == []
        assert calibrated("GET", f"/trials/{trial}/comments").status_code == 404
        assert calibrated("PUT", f"/comments/{made['id']}", json={"text": "x"}).status_code == 404
        assert calibrated("GET", f"/sessions/{calibrated.session}/story").status_code == 404


def test_nothing_of_a_reviewer_reaches_the_control_process(calibrated: Clinic, trial: int) -> None:
    """Every route, with what it needs; only Stop, which everybody may press, is left out."""
    ids = {"patient_id": calibrated.patient["id"], "session_id": calibrated.session, "trial_id": trial}
    reached = []
    for route in routes_of(calibrated, {"GET"} | CHANGING):
        method, path = route.split()
        if path == "/control/stop" or "{role}" in path:
            continue
        with calibrated.as_person(calibrated.cookies_of("Rhea", "reviewer")):  # anew: one of the routes signs out
            before = len(calibrated.process.calls), len(calibrated.process.told)
            calibrated(method, filled(path, **ids), json=BODIES.get(route, MOMENT))
            after = [do for do, _ in calibrated.process.calls[before[0] :]]
            after += [do for do, _ in calibrated.process.told[before[1] :]]
            reached += [(route, do) for do in after if do not in ASKS]
    assert reached == []


def test_a_reviewers_page_moves_nothing_and_stops(calibrated: Clinic) -> None:
    """The live websocket carries more than Stop, as every page has it."""
    choices: tuple[list[int] | None, ...] = (None, [])
    for patients in choices:
        with (
            calibrated.as_person(calibrated.cookies_of(f"Rhea {patients}", "reviewer", patients)),
            calibrated.socket("/live") as socket,
        ):
            told, stops = len(calibrated.process.told), calibrated.process.stops
            socket.send_json({"move": {"right_elbow": 0.7}})
            socket.send_json({"look": {"yaw": 0.5, "pitch": 0.0, "roll": 0.0}})
            socket.send_json({"stop": True})
            while socket.receive_json()["stops"] == stops:
                pass
            assert [do for do, _ in calibrated.process.told[told:] if do in {"move", "look"}] == []
