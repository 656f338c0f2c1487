"""Who needs attention: answered at once; what has become worse is worked out behind it, and again after a change."""

from typing import Any

import numpy as np
import pytest
from api.fake_clinic import Clinic
from clinic_rows import SIMULATED, WORN, ClinicRows, plan_at

from app.features.sharing.attention import RECENT, counted_tasks, tasks_of
from app.source import OWN_GROUPS, UNKNOWN_SOURCE, Source
from app.store.patients import sessions_of
from app.store.tables import Patient

PLAN = plan_at("apartment")
LEVELS = {"steady": [1.0] * 11, "worse": [1.0] * 8 + [3.0] * 3}  # m2, of each session


@pytest.fixture
def course(signed_in: Clinic) -> dict[str, list[int]]:
    """Return the ids of the trials of two people: one stays as they are, the other becomes worse."""
    rng = np.random.default_rng(3)
    ids = {}
    with signed_in.rows() as rows:
        for code, levels in LEVELS.items():
            sessions = [
                [{"e_diff": level * float(np.exp(rng.normal(0, 0.1))), "reached": True} for _ in range(7)]
                for level in levels
            ]
            ids[code] = rows.course(rows.patient(code), PLAN, sessions)
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
    task = {"floorplan": PLAN.name, "path": PLAN.paths[0].name}
    learning = signed_in.good("GET", f"/patients/{found[0]['patient_id']}/learning", params=task)
    assert [worse["sentence"]] == list(learning["verdicts"]["deterioration"].values())


def test_a_trial_that_is_left_out_is_worked_out_anew(signed_in: Clinic, course: Any) -> None:
    signed_in.until("/attention", is_known)
    for trial in course["worse"][-21:]:  # the three bad sessions
        signed_in.good("POST", f"/trials/{trial}/discard", json={"reason": "ill"})
    assert not is_known(signed_in.good("GET", "/attention"))
    found = signed_in.until("/attention", is_known)
    assert {one["code"] for one in found} == set(LEVELS)
    assert not any("deterioration" in one for one in reasons(found).values())


def test_each_source_is_a_task_of_its_own(rows: ClinicRows) -> None:
    """Safety S26: what a camera saw makes nobody worse in a worn shirt."""
    session = rows.session()
    others = [Source(shirt=kind, body=None, chair="virtual", simulated=False) for kind in OWN_GROUPS]
    driven = {
        source.group: [rows.trial(session, {"dist": 1.0}, source=source).id for _ in range(2)]
        for source in (WORN, SIMULATED, UNKNOWN_SOURCE, *others)
    }
    assert len(driven) == 3 + len(OWN_GROUPS)
    tasks = counted_tasks(rows.db)
    assert {task.group: task.trials for task in tasks} == {
        group: ",".join(map(str, ids)) for group, ids in driven.items()
    }
    assert len(tasks) == len(driven)
    assert {group for *_, group in tasks_of(rows.db, session.patient_id)} == set(driven)


def test_a_drive_that_a_fault_stopped_stands_before_everything_else(signed_in: Clinic, course: Any) -> None:
    with signed_in.rows() as rows:
        patient = rows.db.query(Patient).filter_by(code="steady").one()
        session = sessions_of(rows.db, patient.id)[0]
        for end in ("fault", "by hand", "fault"):
            drive = rows.drive(session, end, 2.0)
        drive.started -= RECENT  # long ago
        expected = session.id
    found = signed_in.until("/attention", is_known)
    assert [one["code"] for one in found] == ["steady", "worse"]
    reason = found[0]["reasons"][0]
    assert (reason["reason"], reason["number"], reason["session_id"]) == ("drive", 1, expected)
