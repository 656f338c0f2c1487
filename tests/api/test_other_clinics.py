"""Ids of another clinic: 404, as for ids that do not exist, and a row in the log; for every id of every route."""

import re
from typing import Any

import pytest
from api.fake_clinic import Clinic
from api.fake_process import LAYOUT
from api.routes_with_ids import IDS, MISSING, places
from stored_interface_test import store_interface_test

from app.api import refusals
from app.clock import utc_now
from app.features.comments.service import add_comment
from app.features.layouts.service import add_layout
from app.features.sharing.service import add_share
from app.refusals import DiskFull
from app.store import tables
from app.store.access.visible_patients import of_clinic
from app.store.keeping.incidents import mark_incident
from app.store.patient_screens import add_screen
from app.store.people import add_clinic

NUMBERS = {  # whole numbers that are no ids
    *("stops", "port", "seed", "baud", "address", "version", "direction", "before", "seconds", "hour", "years"),
    *("number", "ip_port"),
    *("place", "session", "days", "mental", "physical", "temporal", "performance", "effort", "frustration"),
    "ends",  # compared with the id of the open session, and never looked up
}


Ids = dict[str, int]


@pytest.fixture
def theirs(signed_in: Clinic) -> Ids:
    """Return the ids of what another clinic has in the same database, by table."""
    with signed_in.rows() as rows:
        db = rows.db
        rows.clinic = clinic = add_clinic(db, "Another clinic")
        with of_clinic(clinic.id):
            session = rows.open_session(rows.patient("P-9"))
            trial = rows.trial(session)
            add_screen(db, session.id, "Eve", None)
            test = store_interface_test(db, session.id)
            person = rows.person("Eve")
            comment = add_comment(db, trial, person.id, 1.0, "Theirs.")
            rows.consent(session.patient_id, "sharing")
            link, _ = add_share(db, session.patient_id, None, "hash", 14, "Eve")
            ids = {"person": person.id, "patient": session.patient_id, "session": session.id, "trial": trial.id}
            ids |= {"interface_test": test.id, "moment_comment": comment.id, "share_link": link.id}
            ids["clinic_layout"] = add_layout(db, LAYOUT).id
            return ids | {
                "chair": rows.chair().id,
                "patient_screen": db.query(tables.PatientScreen).one().id,
                "incident": mark_incident(db, utc_now(), "0" * 64, [session.patient_id], None).id,
            }


def test_every_whole_number_of_every_route_is_known_as_an_id_or_as_none(signed_in: Clinic) -> None:
    found = list(places(signed_in.good("GET", "/openapi.json")))
    unknown = [place for place in found if not place.table]
    assert {place.name for place in unknown} <= NUMBERS, "say in IDS of which table this id is, or put it in NUMBERS"
    assert {place.table for place in found} >= set(IDS.values())
    # An id in a path is an id whatever it is called; the number of a phone stands in no table.
    assert [place.path for place in unknown if place.is_in_path] == ["/phones/{number}"]


def test_another_clinics_ids_do_not_exist_here_and_asking_for_one_is_noted(signed_in: Clinic, theirs: Ids) -> None:
    asked = []
    for place in places(signed_in.good("GET", "/openapi.json")):
        if place.table is None:
            continue
        rows = len(signed_in.log())
        missing = place.asked(signed_in, MISSING)
        assert len(signed_in.log()) == rows, place.route
        refused = place.asked(signed_in, theirs[place.table])
        assert (refused.status_code, missing.status_code) == (404, 404), (place.route, refused.text)
        assert re.sub(r"\d+", "N", refused.text) == re.sub(r"\d+", "N", missing.text)
        (row,) = signed_in.log()[rows:]
        assert (row.person, row.what) == ("Demo clinician", "another clinic's id"), place.route
        assert row.details == {place.table: theirs[place.table]}, place.route
        asked.append(place.route)
    assert len(asked) >= 15


def test_no_query_finds_what_is_of_another_clinic(signed_in: Clinic, theirs: Ids) -> None:
    mappers = tables.Table.registry.mappers
    kinds: list[Any] = [mapper.class_ for mapper in mappers if "clinic_id" in mapper.local_table.columns]
    with signed_in.database.reading() as db:
        both = {kind.__tablename__ for kind in kinds if any(row.clinic_id != 1 for row in db.query(kind))}
    assert both >= {"person", "patient", "session", "trial", "chair", "share_link", "moment_comment", "incident"}
    with of_clinic(1), signed_in.database.reading() as db:
        assert {row.clinic_id for kind in kinds for row in db.query(kind)} == {1}
        assert db.get(tables.Patient, theirs["patient"]) is None


def test_a_full_disk_does_not_tell_it_exists(signed_in: Clinic, theirs: Ids, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_given: Any, **_more: Any) -> None:
        raise DiskFull("The disk is full.")

    monkeypatch.setattr(refusals, "write_log", full)
    assert signed_in("DELETE", f"/patients/{theirs['patient']}").status_code == 404
