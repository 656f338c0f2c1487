"""The measures of each kind of task, and the catalogue that names every one of them."""

import math
import re
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.faults import Fault, State
from app.scoring.interface_test.interface_measures import InterfaceMeasures
from app.scoring.measures import (
    CIRCUMSTANCES,
    EXPORTED,
    INTERRUPTIONS,
    LEADING,
    LEADING_OF_TESTS,
    REACHED,
    TEST_MEASURES,
    TRIAL_MEASURES,
    Measure,
)
from app.scoring.path_measures import path_measures
from app.scoring.task_measures import task_measures
from app.world.floorplan import FloorPlan
from app.world.kinematics import CHAIR_RADIUS
from app.world.scene import bundled_places, find_place
from folders import ROOT

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
    measures = task_measures(*plan_of(**gap_at(1.0)), ahead(in_contact=touching, contacts=np.cumsum(touching)))
    assert measures["door_contacts"] == 2
    assert measures["contact_time"] == pytest.approx(6 * 0.05)
    assert measures["gaps"] == 1


def test_a_contact_that_began_elsewhere_does_not_count_for_the_gap():
    sliding = np.zeros(121)
    sliding[10:70] = 1  # from 0.5 m on, along something, and through
    assert task_measures(*plan_of(**gap_at(1.0)), ahead(in_contact=sliding))["door_contacts"] == 0


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


NO_MEASURES = {REACHED, "interrupted", "title", "kind", "parts"}
ORDINARY = {"dist", "e_diff", "time", "stops", "throughput"}  # words of other subjects, too
MAY_NAME = re.compile(
    r"app/scoring/([a-z_]+/)*[a-z]+_measures\.py|app/scoring/smoothness\.py|app/study/.+|app/world/cursor_task\.py"
)
SCORE = "app/cli/score.py"  # knows which measures say how well a path was followed
NEXT_TASK = "app/scoring/next_task.py"  # a trial with a contact did not go well


def a_trial(x: float, y: float) -> dict[str, np.ndarray]:
    """Return the rows of a trial that goes half a metre on from (x, y), m, with one halt."""
    n = 12
    t = np.arange(n) * 0.1
    columns = dict.fromkeys(("theta", "v", "in_contact", "contacts", "u1", "u2"), np.zeros(n))
    state = np.full(n, State.ARMED)
    state[4] = State.FAULT
    fault = np.where(state == State.FAULT, Fault.SHIRT_LOSSY, Fault.NONE)
    place = {"x": x + 0.05 * np.arange(n), "y": np.full(n, y)}
    return {**columns, **place, "t": t, "scene_t": t, "state": state, "fault": fault}


def test_each_number_of_a_trial_has_an_entry_and_each_entry_a_number() -> None:
    found: set[str] = set()
    for place in bundled_places().values():
        for path in place.plan.paths:
            measures = task_measures(place.plan, path, a_trial(*path.points[0]))
            for part in (measures, *measures.get("parts", ())):
                found |= part.keys()
    assert found - NO_MEASURES == {*TRIAL_MEASURES, *INTERRUPTIONS, *CIRCUMSTANCES}


def test_each_measure_of_a_two_minute_test_is_computed() -> None:
    assert TEST_MEASURES.keys() <= InterfaceMeasures.model_fields.keys()


def test_what_a_measure_names_is_in_the_catalogue() -> None:
    numbers = TRIAL_MEASURES | CIRCUMSTANCES
    assert {one.of for one in TRIAL_MEASURES.values()} <= {None, *numbers}
    assert {name for row in LEADING for names in row for name in names} <= numbers.keys()
    assert set(LEADING_OF_TESTS) < TEST_MEASURES.keys()
    assert EXPORTED.keys() == {*TRIAL_MEASURES, *INTERRUPTIONS}


def test_no_other_file_has_a_table_of_measures() -> None:
    """A page, a report, an export or a command that named them one by one would miss the next one."""
    keys = re.compile(rf"\b({'|'.join((TRIAL_MEASURES.keys() | TEST_MEASURES.keys()) - ORDINARY)})\b")
    found = {}
    for folder, kind in (("app", "py"), ("web_static/js", "js")):
        for file in (ROOT / folder).rglob(f"*.{kind}"):
            name = file.relative_to(ROOT).as_posix()
            named = set(keys.findall(file.read_text(encoding="utf-8")))
            if named and name != "app/scoring/measures.py" and not MAY_NAME.fullmatch(name):
                found[name] = named
    assert found == {
        SCORE: {"dist_ratio", "cross_track_rms", "cross_track_max", "mean_speed"},
        NEXT_TASK: {"collisions"},
    }


def test_words_of_a_measure_follow_from_its_name() -> None:
    plain = Measure("Area off the path", "m²", "m2", 2)
    assert (plain.as_subject, plain.defined_as) == ("The area off the path", "Area off the path")
    named = Measure("Stops", "", "1", 0, subject="The number of stops")
    assert (named.as_subject, named.defined_as) == ("The number of stops", "Number of stops")


def test_levels_are_written_in_their_unit() -> None:
    assert TRIAL_MEASURES["heading_error_deg"].level(12.3) == "12°"
    assert TRIAL_MEASURES["stops"].level(0.4) == "0.4"
    assert TRIAL_MEASURES["sparc"].level(-0.001) == "0.00"
    assert TRIAL_MEASURES["follow_near"].level(0.434) == "43 %"
