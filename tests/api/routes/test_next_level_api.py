"""The next level over the API: after three good trials, unless one of them is worse than noise."""

from typing import Any

import pytest
from clinic_rows import plan_at

EVEN = (2.0, 2.1, 1.9, 2.0, 2.05, 1.95, 2.0, 2.1, 1.9, 2.0)  # m2 off the path


@pytest.mark.parametrize(
    ("newest", "expected"), [(2.0, ("door.medium", "next level")), (9.0, ("door.easy", "again"))], ids=["even", "worse"]
)
def test_the_next_level_waits_while_a_trial_is_worse_than_noise(signed_in: Any, newest: float, expected: Any) -> None:
    good = {"time": 60.0, "path_length": 5.0, "reached": True, "collisions": 0}
    with signed_in.rows() as rows:
        patient = rows.patient()
        rows.course(patient, plan_at("door.easy"), [[{**good, "e_diff": area} for area in (*EVEN, newest)]])
    found = signed_in.good("GET", f"/patients/{patient.id}/next-task", params={"source": "simulated"})
    assert (found["floorplan"], found["reason"]) == expected
