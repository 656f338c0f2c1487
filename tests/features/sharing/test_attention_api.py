"""Who needs attention: answered at once; what has become worse is worked out behind it, and again after a change."""

from typing import Any

import numpy as np
import pytest
from api.fake_clinic import Clinic
from store.course_of_sessions import store_course
from store.known_people import known_clinic

from app.features.sharing.attention import RECENT
from app.source import Source
from app.speeds import HIGHEST_SPEEDS
from app.store.chairs import add_chair
from app.store.drives import add_drive, finish_drive
from app.store.parameters import current_parameters
from app.store.patients import add_patient, sessions_of
from app.store.runs import add_run
from app.store.tables import Patient
from app.world.floorplan import FloorPlan
from app.world.scene import find_place

PLAN = "apartment"
REAL = Source(shirt="udp", body=None, chair="udp", simulated=False)
LEVELS = {"steady": [1.0] * 11, "worse": [1.0] * 8 + [3.0] * 3}  # m2, of each session


@pytest.fixture
def course(signed_in: Clinic) -> dict[str, list[int]]:
    """Return the ids of the trials of two people: one stays as they are, the other becomes worse."""
    rng = np.random.default_rng(3)
    plan = find_place(PLAN)
    assert isinstance(plan, FloorPlan)
    ids = {}
    with signed_in.database.transaction() as db:
        clinic = known_clinic(db)
        assert clinic is not None
        for code, levels in LEVELS.items():
            patient = add_patient(db, code, "Heron", "")
            sessions = [
                [{"e_diff": level * float(np.exp(rng.normal(0, 0.1))), "reached": True} for _ in range(7)]
                for level in levels
            ]
            ids[code] = store_course(db, clinic.id, patient.id, plan, sessions)
    return ids


def reasons(answer: Any) -> dict[str, list[str]]:
    return {one["code"]: [reason["reason"] for reason in one["reasons"]] for one in answer}


def is_known(answer: Any) -> bool:
    return not any(one["pending"] for one in answer)


def test_who_has_become_worse_stands_first_once_it_is_worked_out(signed_in: Clinic, course: Any) -> None:
    first = signed_in.good("GET", "/attention")
    assert {one["code"]: one["pending"] for one in first} == {"steady": True, "worse": True}
    found = signed_in.until("/attention", is_known)
    assert [one["code"] for one in found] == ["worse", "steady"]
    assert ["deterioration" in one for one in reasons(found).values()] == [True, False]
    (worse,) = [one for one in found[0]["reasons"] if one["reason"] == "deterioration"]
    learning = signed_in.good(
        "GET", f"/patients/{found[0]['patient_id']}/learning", params={"floorplan": PLAN, "path": path_name()}
    )
    assert [worse["sentence"]] == list(learning["verdicts"]["deterioration"].values())


def test_a_trial_that_is_left_out_is_worked_out_anew(signed_in: Clinic, course: Any) -> None:
    signed_in.until("/attention", is_known)
    for trial in course["worse"][-21:]:  # the three bad sessions
        signed_in.good("POST", f"/trials/{trial}/discard", json={"reason": "ill"})
    assert not is_known(signed_in.good("GET", "/attention"))
    found = signed_in.until("/attention", is_known)
    assert {one["code"] for one in found} == set(LEVELS)
    assert not any("deterioration" in one for one in reasons(found).values())


def path_name() -> str:
    plan = find_place(PLAN)
    assert isinstance(plan, FloorPlan)
    return plan.paths[0].name


def test_a_drive_that_a_fault_stopped_stands_before_everything_else(signed_in: Clinic, course: Any) -> None:
    with signed_in.database.transaction() as db:
        patient = db.query(Patient).filter_by(code="steady").one()
        session = sessions_of(db, patient.id)[0]
        row, _ = current_parameters(db, patient.id)
        chair = add_chair(db, known_clinic(db), "Red", "chair.example", 5354, 7, HIGHEST_SPEEDS)
        for number, end in enumerate(("fault", "by hand", "fault")):
            run = add_run(db, f"drive-{number}", session.id, "drive", f"drive-{number}", REAL)
            given: dict[str, Any] = {
                "run": run,
                "patient_id": patient.id,
                "chair_id": chair.id,
            }
            drive = finish_drive(db, add_drive(db, parameters_id=row.id, digest=row.hash, **given).id, end, 2.0)
        drive.started -= RECENT  # long ago
        expected = session.id
    found = signed_in.until("/attention", is_known)
    assert [one["code"] for one in found] == ["steady", "worse"]
    reason = found[0]["reasons"][0]
    assert (reason["reason"], reason["number"], reason["session_id"]) == ("drive", 1, expected)
