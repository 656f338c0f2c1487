"""Where a new contact begins, from touches: as the virtual chair counts while it drives."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from app.geometry import Pose, Twist
from app.hardware.chair.simulator import VirtualChair
from app.world.contacts import NEW_CONTACT_AFTER, contact_rows
from app.world.floorplan import FloorPlan

PATH = {"name": "main", "title": "Main", "points": ((-3.0, 0.0), (-1.0, 0.0)), "instruction": "Go."}
PLAN = FloorPlan(name="p", title="P", walls=(((0.0, -5.0), (0.0, 5.0)),), paths=(PATH,))
DT = 1 / 128  # s, whose sums are exact


@settings(max_examples=50, deadline=None)
@given(st.lists(st.tuples(st.sampled_from([1.0, -0.01]), st.integers(1, 40)), max_size=20))
def test_the_rows_are_those_in_which_the_chair_s_count_rises(drives):
    chair = VirtualChair(PLAN, Pose(-0.6, 0.0, 0.0))
    states = [chair.drive(Twist(v, 0.0), DT) for v, steps in drives for _ in range(steps)]
    touching = np.array([state.in_contact for state in states], dtype=bool)
    rises = np.flatnonzero(np.diff([state.contacts for state in states], prepend=0))
    assert contact_rows(touching, DT * np.arange(len(states))).tolist() == rises.tolist()


def test_a_touch_after_less_freedom_belongs_to_the_contact_before():
    t = np.arange(200) / 100
    touching = np.zeros(200, dtype=bool)
    touching[[0, 20, 20 + round(NEW_CONTACT_AFTER * 100) + 2]] = True
    assert contact_rows(touching, t).tolist() == [0, 47]
    assert contact_rows(np.zeros(200, dtype=bool), t).tolist() == []
