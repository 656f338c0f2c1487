"""A deleted patient is hidden everywhere at once: each route answers as for an id that does not exist."""

import json
import re

import pytest
from api.fake_clinic import Clinic, sentence_of
from api.routes_with_ids import MISSING, places
from api.served_routes import requested, routes_of
from api.test_shown_patients import HIDDEN, reviewed
from stored_interface_test import store_interface_test

from app.clock import utc_now
from app.features.comments.tables import MomentComment
from app.features.records.service import add_note, add_scale
from app.features.sharing.tables import ShareLink

__all__ = ["reviewed"]  # the fixture: a patient called HIDDEN with a trial, and another one

# What an owner does with deleted patients: undo, erase, and read the log of what was done.
FOR_DELETED = {"POST /patients/{patient_id}/restore", "POST /deleted-patients/{patient_id}/erasure", "GET /log"}
NAMES = re.compile(f"{HIDDEN}|Zebra")
SHOWS_DELETED = {"GET /backups"}


def records_of(clinic: Clinic) -> dict[str, int]:
    """Make a record of each kind for the patient who is here; return their ids by the names that routes give them."""
    patient, session = clinic.patient["id"], int(clinic.session)
    trial = clinic.good("GET", "/trials", params={"patient": patient})[0]["id"]
    with clinic.rows() as rows:
        rows.consent(patient, "sharing")
        found = {
            "note_id": add_note(rows.db, session, f"{HIDDEN} is tired.", "Ada"),
            "scale_id": add_scale(rows.db, session, "SCIM III", 41.0, utc_now().date()),
            "test_id": store_interface_test(rows.db, session).id,
        }
    clinic.good("POST", f"/trials/{trial}/comments", json={"t": 1.0, "text": f"{HIDDEN} turned well."})
    clinic.link = clinic.good("POST", f"/patients/{patient}/shares", json={"days": 14})  # type: ignore[attr-defined]
    with clinic.database.transaction() as db:
        found |= {"comment_id": db.query(MomentComment).one().id, "share_id": db.query(ShareLink).one().id}
    found |= dict.fromkeys(("patient_id", "patient"), patient) | dict.fromkeys(("session_id", "other"), session)
    return found | dict.fromkeys(("trial_id", "trial", "against"), trial)


@pytest.fixture
def deleted(reviewed: Clinic) -> Clinic:
    clinic = reviewed
    clinic.ids = records_of(clinic)  # type: ignore[attr-defined]
    clinic.good("DELETE", "/session")
    assert HIDDEN in json.dumps(clinic.good("GET", "/patients"))
    clinic.good("DELETE", f"/patients/{clinic.patient['id']}")
    return clinic


def test_every_route_answers_as_for_an_id_that_does_not_exist(deleted: Clinic) -> None:
    ids = deleted.ids  # type: ignore[attr-defined]
    tried = set()
    for place in places(deleted.good("GET", "/openapi.json")):
        if place.name not in ids or place.route in FOR_DELETED:
            continue
        nothing = dict.fromkeys(ids, MISSING)
        for more_body in ({}, {"nonsense": 1}):  # the second one is refused for its form where there is a body
            missing, refused = (place.asked(deleted, numbers, **more_body) for numbers in (nothing, ids))
            assert missing.status_code == refused.status_code, (place.route, refused.text)
            assert refused.status_code in ({404, 409, 422} if more_body else {404}), (place.route, refused.text)
            assert re.sub(r"\d+", "N", refused.text) == re.sub(r"\d+", "N", missing.text), place.route
            assert not NAMES.search(refused.text), place.route
            assert refused.json()["detail"].endswith("."), place.route
        tried.add((place.route, place.name))
    assert {name for _, name in tried} == set(ids)
    assert len(tried) >= 30


def test_no_answer_names_a_deleted_patient(deleted: Clinic) -> None:
    answers = {name: requested(deleted, name).text for name in routes_of(deleted, {"GET"})}
    assert {name for name, text in answers.items() if HIDDEN in text or "Zebra" in text} == SHOWS_DELETED
    deleted.good("POST", f"/patients/{deleted.patient['id']}/restore")
    assert HIDDEN in requested(deleted, "GET /patients").text
    trial = deleted.ids["trial_id"]  # type: ignore[attr-defined]
    assert deleted.good("GET", f"/trials/{trial}")["id"] == trial


def test_a_share_link_of_a_deleted_patient_opens_nothing_also_where_it_is_open(reviewed: Clinic) -> None:
    records_of(reviewed)
    link = reviewed.link  # type: ignore[attr-defined]
    token = {"token": link["url"].partition("#")[2], "pin": link["pin"]}
    with reviewed.as_person({}):
        assert reviewed("POST", "/shared/open", json=token).status_code == 204
        visit = dict(reviewed.client.cookies)
        assert reviewed.good("GET", "/shared")["code"] == HIDDEN
    reviewed.good("DELETE", "/session")
    reviewed.good("DELETE", f"/patients/{reviewed.patient['id']}")
    for cookies in ({}, visit):
        with reviewed.as_person(cookies):
            for refused in (reviewed("GET", "/shared"), reviewed("POST", "/shared/open", json=token)):
                sentence_of(refused, 401)
                assert not NAMES.search(refused.text)


def test_a_record_that_was_removed_alone_is_gone_or_says_that_it_was_withdrawn(reviewed: Clinic) -> None:
    ids = records_of(reviewed)
    scale = f"/sessions/{reviewed.session}/scales/{ids['scale_id']}"
    link, comment = f"/shares/{ids['share_id']}", f"/comments/{ids['comment_id']}"
    for path in (scale, link, comment):
        reviewed.good("DELETE", path)
    # A scale is gone; a comment keeps its history, and a link its openings.
    for method, path, body, status, words in (
        ("DELETE", scale, None, 404, "There is no scale"),
        ("PUT", comment, {"text": "Once more."}, 409, "This comment was withdrawn"),
        ("DELETE", comment, None, 409, "This comment was withdrawn"),
        ("DELETE", link, None, 409, "This link was revoked already."),
    ):
        refused = reviewed(method, path, json=body)
        assert (refused.status_code, refused.json()["detail"].startswith(words)) == (status, True), refused.text
