"""Two-minute tests stand in the record of a session, and side by side in the comparison of two."""

from typing import Any

import pytest
from api.fake_clinic import Clinic
from clinic_rows import ROOM, ClinicRows
from stored_interface_test import store_interface_test

from app.store.patients import sessions_of

LEVELS = ((0.6, 0.61, 0.6, 0.61), (0.6, 0.61, 0.9, 0.9))  # bit/s, of the tests of two sessions
FIGURES = ("acquisitions_per_minute", "throughput", "first_entry", "dial_in", "path_efficiency")


def two_sessions(rows: ClinicRows) -> list[int]:
    """Add a patient with two sessions of one trial each; return the ids of the sessions."""
    patient = rows.patient()
    rows.course(patient, ROOM, [[{"e_diff": 1.0, "reached": True}]] * 2)
    return sorted(one.id for one in sessions_of(rows.db, patient.id))


@pytest.fixture
def sessions(signed_in: Clinic) -> list[int]:
    """Return two sessions with four tests each; the last test of the second was stopped."""
    with signed_in.rows() as rows:
        ids = two_sessions(rows)
        for session, levels in zip(ids, LEVELS, strict=True):
            for number, level in enumerate(levels):
                end = "stopped" if session == ids[1] and number == 3 else "complete"
                store_interface_test(rows.db, session, end=end, throughput=level)
    return ids


def test_the_record_has_each_test_with_its_figures(signed_in: Clinic, sessions: list[int]) -> None:
    tests = signed_in.good("GET", f"/sessions/{sessions[1]}")["tests"]
    assert [one["number"] for one in tests] == [5, 6, 7, 8]
    assert [one["end"] for one in tests] == ["complete"] * 3 + ["stopped"]
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
    with signed_in.rows() as rows:
        first, second = two_sessions(rows)
        store_interface_test(rows.db, second)
    found = compared(signed_in, first, second)
    assert (found["complete"], found["earlier"], found["verdicts"]) == ([0, 1], None, {})
