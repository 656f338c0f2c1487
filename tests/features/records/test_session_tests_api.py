"""Two-minute tests stand in the record of a session, and side by side in the comparison of two."""

from typing import Any

import pytest
from api.fake_clinic import Clinic
from store.course_of_sessions import store_course
from stored_interface_test import store_interface_test

from app.store.database import Transaction
from app.store.patients import add_patient, sessions_of
from app.store.people import the_clinic
from app.world.floorplan import FloorPlan
from app.world.scene import find_place

LEVELS = ((0.6, 0.61, 0.6, 0.61), (0.6, 0.61, 0.9, 0.9))  # bit/s, of the tests of two sessions
FIGURES = ("acquisitions_per_minute", "throughput", "first_entry", "dial_in", "path_efficiency")


def two_sessions(db: Transaction) -> list[int]:
    """Add a patient with two sessions of one trial each; return the ids of the sessions."""
    plan, clinic = find_place("apartment"), the_clinic(db)
    assert isinstance(plan, FloorPlan)
    assert clinic is not None
    patient = add_patient(db, "P-1", "Heron", "")
    store_course(db, clinic.id, patient.id, plan, [[{"e_diff": 1.0, "reached": True}]] * 2)
    return sorted(one.id for one in sessions_of(db, patient.id))


@pytest.fixture
def sessions(signed_in: Clinic) -> list[int]:
    """Return two sessions with four tests each; the last test of the second was stopped."""
    with signed_in.database.transaction() as db:
        ids = two_sessions(db)
        for session, levels in zip(ids, LEVELS, strict=True):
            for number, level in enumerate(levels):
                end = "stopped" if session == ids[1] and number == 3 else "complete"
                store_interface_test(db, session, end=end, throughput=level)
    return ids


def test_the_record_has_each_test_with_its_figures(signed_in: Clinic, sessions: list[int]) -> None:
    tests = signed_in.good("GET", f"/sessions/{sessions[1]}")["tests"]
    assert [(one["number"], one["end"]) for one in tests] == [
        (5, "complete"),
        (6, "complete"),
        (7, "complete"),
        (8, "stopped"),
    ]
    assert [tests[0]["measures"][name] for name in FIGURES] == [10.0, 0.6, 2.5, 0.25, 0.875]
    assert tests[0]["source"]["simulated"] is True


def compared(clinic: Clinic, first: int, second: int) -> Any:
    (found,) = clinic.good("GET", f"/sessions/{first}/comparison", params={"other": second})["tests"]
    return found


def test_two_sessions_stand_side_by_side_with_verdicts(signed_in: Clinic, sessions: list[int]) -> None:
    found = compared(signed_in, sessions[1], sessions[0])
    assert (found["source"], found["complete"]) == ("simulated", [4, 3])
    assert (found["earlier"]["number"], found["later"]["number"]) == (4, 7)  # the newest complete ones
    words = {name: verdict["word"] for name, verdict in found["verdicts"].items()}
    assert (words["throughput"], words["first_entry"]) == ("better", "within")
    assert [found["verdicts"]["throughput"][name] for name in ("earlier", "later")] == [0.61, 0.9]


def test_without_a_complete_test_in_one_session_there_is_no_verdict(signed_in: Clinic) -> None:
    with signed_in.database.transaction() as db:
        first, second = two_sessions(db)
        store_interface_test(db, second)
    found = compared(signed_in, first, second)
    assert (found["complete"], found["earlier"], found["verdicts"]) == ([0, 1], None, {})
