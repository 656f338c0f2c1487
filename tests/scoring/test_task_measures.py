"""The measures of each kind of task, and the catalogue that names every one of them."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.scoring.path_measures import path_measures
from app.scoring.task_measures import task_measures
from app.world.floorplan import FloorPlan
from app.world.footprint import CHAIR_RADIUS
from app.world.scene import find_place

LINE = ((0.0, 0.0), (6.0, 0.0))


def plan_of(points=LINE, task=None, **changes):
    path = {"name": "main", "title": "Main", "points": points, "instruction": "Go."}
    own = {name: changes.pop(name) for name in ("start_heading", "goal_radius") if name in changes}
    asked = {} if task is None else {"task": task}
    plan = FloorPlan(name="p", title="P", walls=changes.pop("walls", ()), paths=(path | own | asked,), **changes)
    return plan, plan.paths[0]


def rows(x, y, theta=0.0, dt=0.05, **changes):
    n = len(np.atleast_1d(x))
    t = np.arange(n) * dt
    own = {"t": t, "scene_t": t, "x": x, "y": y, "theta": theta, "v": 0.0, "u1": 0.0, "u2": 0.0}
    own |= {"in_contact": 0, "contacts": 0} | changes
    return {name: np.broadcast_to(np.asarray(column, dtype=np.float64), n).copy() for name, column in own.items()}


def ahead(y=0.0, end=6.0, **changes):
    x = np.linspace(0.0, end, 121)
    return rows(x, np.full(121, y), **changes)


def test_a_plain_path_has_the_measures_of_a_path():
    driven = ahead(0.2, u1=0.5)
    names = ("in_contact", "contacts", "u1", "u2")
    plain = path_measures(driven["t"], driven["x"], driven["y"], LINE, 0.5, **{name: driven[name] for name in names})
    assert task_measures(*plan_of(), driven) == plain


@pytest.mark.parametrize(("aside", "touched"), [(0.46, 1), (0.48, 0), (0.0, 1), (-0.46, 1)])
def test_a_cone_is_touched_within_both_radii(aside, touched):
    cones = ({"position": (3.0, 0.6)}, {"position": (3.0, 3.0)})
    measures = task_measures(*plan_of(cones=cones), ahead(0.6 + aside))
    assert (measures["cones_touched"], measures["cones"]) == (touched, 2)


def gap_at(width, y=0.0):
    walls = (((3.0, -5.0), (3.0, y - width / 2)), ((3.0, y + width / 2), (3.0, 5.0)))
    return {"walls": walls, "wall_thickness": 0.1, "gaps": ({"label": "gap", "position": (3.0, y), "width": width},)}


@settings(max_examples=40, deadline=None)
@given(st.floats(0.75, 2.0), st.floats(-0.3, 0.3))
def test_the_clearance_of_a_gap_is_that_at_its_nearer_side(width, aside):
    measures = task_measures(*plan_of(**gap_at(width)), ahead(aside))
    room = max(0.0, width / 2 - CHAIR_RADIUS - abs(aside))
    if abs(aside) < width / 2 - CHAIR_RADIUS:
        assert measures["gap_clearance"] == pytest.approx(room, abs=0.01)
    else:
        assert measures["gap_clearance"] == 0.0


def test_a_gap_not_passed_has_no_clearance_and_its_contacts_count():
    touching = np.zeros(121)
    touching[[10, 55, 56, 57, 58, 70]] = 1  # at 0.5 m, 2.75 m and 3.5 m
    measures = task_measures(*plan_of(**gap_at(1.0)), ahead(end=2.5))
    assert measures["gap_clearance"] is None
    contacts = np.searchsorted([10, 55, 70], np.arange(121), side="right")
    measures = task_measures(*plan_of(**gap_at(1.0)), ahead(in_contact=touching, contacts=contacts))
    assert measures["door_contacts"] == 2
    assert measures["contact_time"] == pytest.approx(6 * 0.05)
    assert measures["gaps"] == 1


def test_a_contact_that_began_elsewhere_does_not_count_for_the_gap():
    sliding = np.zeros(121)
    sliding[10:70] = 1  # from 0.5 m on, along something, and through
    measures = task_measures(
        *plan_of(**gap_at(1.0)), ahead(in_contact=sliding, contacts=np.maximum.accumulate(sliding))
    )
    assert (measures["collisions"], measures["door_contacts"]) == (1, 0)


def test_rows_after_the_goal_do_not_count():
    plan, path = plan_of(cones=({"position": (8.0, 0.0)},))
    assert task_measures(plan, path, ahead(end=9.0))["cones_touched"] == 0


GUIDE = {"name": "guide", "kind": "person", "points": ((1.5, 0.0), (6.0, 0.0)), "pace": ((0.0, 0.5),)}
FOLLOW = {"kind": "follow", "leader": "guide", "distance": 1.5}


def test_a_leader_who_is_followed_exactly():
    t = np.arange(240) * 0.05
    driven = rows(np.minimum(0.5 * t, 4.5), np.zeros(240))
    measures = task_measures(*plan_of(task=FOLLOW, movers=(GUIDE,), goal_radius=0.6), driven)
    assert measures["reached"]
    assert measures["follow_error_rms"] == pytest.approx(0.0, abs=1e-6)
    assert measures["follow_near"] == 1.0
    assert measures["time"] <= 9.1


@settings(max_examples=30, deadline=None)
@given(
    st.lists(st.tuples(st.floats(-3, 8), st.floats(-3, 3)), min_size=2, max_size=12, unique=True), st.floats(0.5, 3.0)
)
def test_distances_are_those_of_a_direct_computation(places, asked):
    x, y = np.array(places).T
    cones = tuple({"position": (c, 0.5)} for c in (1.0, 3.0, 5.0))
    task = FOLLOW | {"distance": asked}
    line = {"task": task, "movers": (GUIDE,), "goal_radius": 0.05}  # never reached: nothing is cut off
    plan, path = plan_of(((0.0, 2.0), (6.0, 2.0)), **line, cones=cones)
    measures = task_measures(plan, path, rows(x, y, math.pi))
    errors = [math.dist((a, b), (1.5 + 0.5 * 0.05 * k, 0.0)) - asked for k, (a, b) in enumerate(places)]
    assert measures["follow_error_max"] == pytest.approx(max(map(abs, errors)), abs=1e-6)
    assert measures["follow_error_rms"] == pytest.approx(math.sqrt(np.mean(np.square(errors[:-1]))), abs=1e-6)
    share = np.linspace(0, 1, 400)
    finely = np.concatenate([a + np.outer(share, b - a) for a, b in pairwise(np.array(places))])
    near = [float(np.hypot(*(finely - (c, 0.5)).T).min()) for c in (1.0, 3.0, 5.0)]
    reach = 0.15 + CHAIR_RADIUS
    assert sum(d <= reach for d in near) <= measures["cones_touched"] <= sum(d <= reach + 0.02 for d in near)


def test_a_leader_whom_nobody_follows():
    measures = task_measures(*plan_of(task=FOLLOW, movers=(GUIDE,)), rows(np.zeros(200), np.zeros(200)))
    assert not measures["reached"]
    assert measures["follow_error_max"] == pytest.approx(4.5)
    assert measures["follow_near"] == pytest.approx(0.1, abs=0.02)  # the first second of ten


@settings(max_examples=30, deadline=None)
@given(st.floats(0.0, 0.45), st.floats(-math.pi, math.pi), st.floats(-9.0, 9.0))
def test_how_far_a_turn_ended_beside_the_mark_and_rolled_off_the_spot(drift, way, beside):
    plan, path = plan_of(((0.0, 0.0), (0.0, 2.0)), {"kind": "turn", "direction": "left"}, start_heading=0.0)
    share = np.concatenate([np.linspace(0, 1, 60), np.ones(60)])
    x, y = drift * math.cos(way) * share, drift * math.sin(way) * share
    measures = task_measures(plan, path, rows(x, y, np.radians(90 + beside) * share))
    assert measures["reached"]
    assert measures["heading_error_deg"] == pytest.approx(abs(beside), abs=1e-6)
    assert measures["turn_drift"] == pytest.approx(drift, abs=1e-9)


def test_turning_on_the_spot_has_its_own_measures():
    plan, path = plan_of(((0.0, 0.0), (0.0, 2.0)), {"kind": "turn", "direction": "left"}, start_heading=0.0)
    theta = np.concatenate([np.linspace(0, math.radians(95), 60), np.full(60, math.radians(95))])
    measures = task_measures(plan, path, rows(np.full(120, 0.12), np.full(120, 0.16), theta))
    assert measures["reached"]
    assert measures["heading_error_deg"] == pytest.approx(5, abs=1e-6)
    assert measures["turn_drift"] == pytest.approx(0.2)
    assert "dist" not in measures
    assert "e_diff" not in measures
    assert measures["time"] == pytest.approx(59 * 0.05 * 80 / 95 + 1.0, abs=0.06)


def test_backing_counts_backwards_only():
    plan, path = plan_of(((0.0, 0.0), (-2.0, 0.0)), {"kind": "back"}, start_heading=0.0, goal_radius=0.25)
    back = rows(np.linspace(0, -2, 80), np.zeros(80))
    turned = rows(np.linspace(0, -2, 80), np.zeros(80), math.pi)
    assert task_measures(plan, path, back)["reached"]
    assert task_measures(plan, path, back)["e_diff"] == pytest.approx(0.0, abs=1e-9)
    assert not task_measures(plan, path, turned)["reached"]


def test_a_course_is_measured_stage_by_stage():
    plan = find_place("skills.easy")
    path = plan.paths[0]
    x = np.concatenate([np.linspace(0, 6, 120), np.linspace(5.6, 4, 60)])
    measures = task_measures(plan, path, rows(x, np.zeros(180)))
    assert (measures["stages_done"], measures["stages"], measures["reached"]) == (2, 7, False)
    assert [part["reached"] for part in measures["parts"]] == [True, True, *[False] * 5]
    assert [part["kind"] for part in measures["parts"]][:4] == ["path", "back", "path", "turn"]
    assert measures["parts"][0]["dist"] == pytest.approx(6, abs=0.6)
    assert measures["parts"][1]["reached"]
    assert "e_diff" not in measures


def test_each_stage_of_a_course_counts_the_contacts_that_began_in_it():
    x = np.concatenate([np.linspace(0, 6, 120), np.linspace(5.6, 4, 60)])
    touching = np.zeros(180)
    touching[[30, 31]] = touching[100:130] = 1  # the second contact goes on into the second stage
    contacts = np.where(np.arange(180) < 30, 0, np.where(np.arange(180) < 100, 1, 2))
    plan = find_place("skills.easy")
    measures = task_measures(plan, plan.paths[0], rows(x, np.zeros(180), in_contact=touching, contacts=contacts))
    assert [part.get("collisions") for part in measures["parts"][:3]] == [2, 0, 0]
    assert measures["collisions"] == 2
