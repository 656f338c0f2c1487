"""Verdicts in the answers of the API: the same word for everybody, and none where trials cannot be compared."""

from collections import Counter
from datetime import date
from typing import Any

import numpy as np
import pytest
from api.fake_clinic import Clinic
from clinic_rows import WORN, plan_at

PLAN = plan_at("apartment")


def measures(area: float, **more: Any) -> dict[str, Any]:
    return {"e_diff": area, "time": 60.0, "path_length": 13.6, "reached": True} | more


@pytest.fixture
def course(signed_in: Clinic) -> Clinic:
    """A clinic with five people; the trials of the first fall from 3 m2 to 1 m2 in the last of four sessions."""
    rng = np.random.default_rng(2)
    clinic = signed_in
    with clinic.rows() as rows:
        for number in range(5):
            patient = rows.patient(f"P-{number}")
            levels = (3.0, 3.0, 3.0, 1.0 if number == 0 else 3.0)
            sessions = [[measures(level * float(np.exp(rng.normal(0, 0.1)))) for _ in range(7)] for level in levels]
            ids = rows.course(patient, PLAN, sessions)
            if number == 0:
                clinic.course, clinic.heron = ids, patient.id  # type: ignore[attr-defined]
                (clinic.worn,) = rows.course(rows.patient("W"), PLAN, [[measures(3.0)]], WORN)  # type: ignore[attr-defined]
    return clinic


def task(clinic: Any, **more: str) -> Any:
    query = {"floorplan": PLAN.name, "path": PLAN.paths[0].name, **more}
    return clinic.good("GET", f"/patients/{clinic.heron}/learning", params=query)


def test_the_newest_session_is_better_than_noise_and_the_first_trials_of_the_task_do_not_count(course: Any) -> None:
    answer = task(course)
    days = [date.fromisoformat(row["started"][:10]) for row in answer["trials"]]
    assert [(day - days[0]).days for day in days] == [7 * session for session in range(4) for _ in range(7)]
    assert [row["familiarisation"] for row in answer["trials"]] == [True] * 3 + [False] * 25
    before, first = answer["verdicts"]["sessions"]
    assert (before["earlier"], first["earlier"], before["later"], before["trials"]) == (3, 1, 4, [7, 7])
    assert before["verdicts"]["e_diff"]["word"] == first["verdicts"]["e_diff"]["word"] == "better"
    assert before["verdicts"]["time"]["word"] == "within"
    assert answer["verdicts"]["deterioration"] == {}


def test_the_curve_of_one_measure_is_that_of_all_of_them(course: Any) -> None:
    every, one = task(course), task(course, measure="e_diff")
    assert one["curves"] == {"e_diff": every["curves"]["e_diff"]}
    assert len(every["curves"]) > 1
    assert {**one, "curves": None} == {**every, "curves": None}
    query = {"floorplan": PLAN.name, "path": "x", "measure": "E_diff"}
    refused = course("GET", f"/patients/{course.heron}/learning", params=query)
    assert refused.status_code == 422
    assert "is no measure: choose one of stages_done, " in refused.json()["detail"]


def test_a_trial_has_its_verdict_against_the_one_before_and_against_a_chosen_one(course: Any) -> None:
    ids = course.course
    plain = course.good("GET", f"/trials/{ids[-2]}/verdicts")
    assert (plain["earlier"], plain["verdicts"]["e_diff"]["word"]) == (ids[-3], "within")
    chosen = course.good("GET", f"/trials/{ids[-1]}/verdicts", params={"against": ids[-8]})
    assert (chosen["earlier"], chosen["verdicts"]["e_diff"]["word"]) == (ids[-8], "better")
    used = course.good("GET", f"/trials/{ids[2]}/verdicts")
    assert (used["earlier"], used["familiarisation"], used["verdicts"]) == (None, [ids[2]], {})


def test_the_list_says_in_which_session_a_trial_is_compared(course: Any) -> None:
    """The page that chose the task to show first counted by days what verdicts count by sessions."""
    listed = course.good("GET", "/trials", params={"patient": course.heron})
    assert [row["id"] for row in listed if row["compared_in"] is None] == course.course[:3]
    assert list(Counter(row["compared_in"] for row in listed).values()) == [3, 4, 7, 7, 7]


def test_a_discarded_trial_has_no_verdict_and_the_others_keep_their_place(course: Any) -> None:
    ids = course.course
    course.good("POST", f"/trials/{ids[1]}/discard", json={"reason": "practice"})
    assert course.good("GET", f"/trials/{ids[1]}/verdicts")["verdicts"] == {}
    assert course.good("GET", f"/trials/{ids[2]}/verdicts")["familiarisation"] == [ids[2]]
    assert course.good("GET", f"/trials/{ids[3]}/verdicts")["familiarisation"] == []


def test_trials_of_different_people_or_sources_are_refused_in_one_sentence(course: Any) -> None:
    refused = course.refused(409, "GET", f"/trials/{course.course[-1]}/verdicts", params={"against": course.worn})
    assert refused.startswith("These two trials differ")
    assert course("GET", f"/trials/{course.course[-1]}/verdicts", params={"against": 10**6}).status_code == 404


def test_a_reviewer_of_this_patient_alone_reads_the_same_verdicts(course: Any) -> None:
    owner = task(course)["verdicts"]
    with course.as_person(course.cookies_of("Rita", "reviewer", [course.heron])):
        assert task(course)["verdicts"] == owner
        assert [patient["code"] for patient in course.good("GET", "/patients")] == ["P-0"]
