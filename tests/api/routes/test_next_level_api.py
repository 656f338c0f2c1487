"""The next level over the API: after three good trials, unless one of them is worse than noise."""

from typing import Any

import pytest
from store.course_of_sessions import store_course

from app.store.patients import add_patient
from app.store.people import the_clinic
from app.world.floorplan import FloorPlan
from app.world.scene import find_place

EVEN = (2.0, 2.1, 1.9, 2.0, 2.05, 1.95, 2.0, 2.1, 1.9, 2.0)  # m2 off the path


@pytest.mark.parametrize(
    ("newest", "expected"), [(2.0, ("door.medium", "next level")), (9.0, ("door.easy", "again"))], ids=["even", "worse"]
)
def test_the_next_level_waits_while_a_trial_is_worse_than_noise(signed_in: Any, newest: float, expected: Any) -> None:
    plan = find_place("door.easy")
    assert isinstance(plan, FloorPlan)
    good = {"time": 60.0, "path_length": 5.0, "reached": True, "collisions": 0}
    with signed_in.database.transaction() as db:
        clinic = the_clinic(db)
        assert clinic is not None
        patient = add_patient(db, "P-1", "Heron", "")
        store_course(db, clinic.id, patient.id, plan, [[{**good, "e_diff": area} for area in (*EVEN, newest)]])
    found = signed_in.good("GET", f"/patients/{patient.id}/next-task", params={"source": "simulated"})
    assert (found["floorplan"], found["reason"]) == expected
