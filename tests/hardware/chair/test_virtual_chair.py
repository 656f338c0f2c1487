"""The virtual chair, and dead reckoning of any chair."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import Pose, Twist
from app.hardware.chair.odometry import arc
from app.hardware.chair.simulator import VirtualChair
from app.world.dynamics import Motion, Wheelchair
from app.world.dynamics import step as dynamics_step
from app.world.floorplan import FloorPlan
from app.world.kinematics import unicycle

PATH = {"name": "main", "title": "Main", "points": [(50, 0), (60, 0)], "instruction": "Go."}
WALL = [(0, -10), (0, 10)]
PLAN = FloorPlan.model_validate({"name": "test", "title": "Test", "walls": [WALL], "paths": [PATH]})
FORWARD = Twist(0.8, 0.0)
DYNAMICS = pytest.mark.parametrize("dynamics", ["unicycle", "wheelchair"])


def test_it_drives_as_the_paper_says():
    chair = VirtualChair(None, Pose(0, 0, 0))
    for _ in range(100):
        state = chair.drive(Twist(0.5, 0.2), 0.01)
    assert (state.v, state.omega, state.theta) == pytest.approx((0.5, 0.2, 0.2))
    assert state.x == pytest.approx(2.5 * math.sin(0.2), abs=1e-3)
    assert not state.in_contact


@pytest.mark.parametrize("dt", [0.0, -1.0, math.nan])
def test_no_time_moves_nothing(dt):
    chair = VirtualChair(None, Pose(1, 2, 0))
    state = chair.drive(FORWARD, dt)
    assert (state.x, state.y, state.theta) == (1, 2, 0)


def test_after_a_silence_it_has_not_driven_on():
    chair = VirtualChair(None, Pose(0, 0, 0))
    assert chair.drive(FORWARD, 30.0).x == pytest.approx(0.08)


@given(st.sampled_from([math.nan, math.inf, -math.inf, 1e9]), st.booleans())
def test_what_is_no_command_is_a_standstill(bad, forward):
    chair = VirtualChair(None, Pose(0, 0, 0))
    state = chair.drive(Twist(bad, 0.1) if forward else Twist(0.1, bad), 0.01)
    assert (state.x, state.y, state.theta, state.v, state.omega) == (0, 0, 0, 0, 0)


@DYNAMICS
def test_a_wall_holds_it_and_its_wheels_and_counts_once(dynamics):
    chair = VirtualChair(PLAN, Pose(-1, 0, 0), dynamics=dynamics)
    for _ in range(300):
        state = chair.drive(FORWARD, 0.01)
    assert state.x == pytest.approx(-0.37, abs=1e-6)
    assert (state.in_contact, state.contacts) == (True, 1)
    assert state.v == pytest.approx(0, abs=1e-9)
    away = -0.3 if dynamics == "unicycle" else -0.3 * (1 - math.exp(-0.05))
    assert chair.drive(Twist(-0.3, 0.0), 0.01).v == pytest.approx(away, rel=0.02)


def test_a_new_contact_needs_a_quarter_of_a_second_of_freedom():
    chair = VirtualChair(PLAN, Pose(-0.6, 0, 0))
    for backwards, expected in ((0.1, 1), (0.4, 2)):
        for _ in range(100):
            chair.drive(FORWARD, 0.01)
        for _ in range(round(backwards / 0.01)):
            chair.drive(Twist(-0.3, 0.0), 0.01)
        for _ in range(100):
            state = chair.drive(FORWARD, 0.01)
        assert state.contacts == expected


def test_turning_at_the_wall_is_free():
    chair = VirtualChair(PLAN, Pose(-0.37, 0, 0))
    for _ in range(100):
        state = chair.drive(Twist(0.0, 1.0), 0.01)
    assert state.theta == pytest.approx(1.0)


def test_placing_forgets_the_contacts():
    chair = VirtualChair(PLAN, Pose(-0.5, 0, 0))
    for _ in range(50):
        chair.drive(FORWARD, 0.01)
    chair.place(Pose(-3, 0, 1))
    assert (chair.state.x, chair.state.theta, chair.state.contacts, chair.state.in_contact) == (-3, 1, 0, False)


@pytest.mark.parametrize("pose", [Pose(0.1, 0, 0), Pose(math.nan, 0, 0), Pose(0, 0, math.inf)])
def test_it_cannot_be_put_where_no_chair_can_stand(pose):
    with pytest.raises(ValueError, match="place"):
        VirtualChair(PLAN, pose)


TWISTS = st.lists(st.builds(Twist, st.floats(-1.5, 1.5), st.floats(-2.5, 2.5)), min_size=1, max_size=30)


@given(TWISTS, st.floats(0.001, 0.1))
def test_by_default_it_is_the_unicycle_exactly(twists, dt):
    chair, pose = VirtualChair(None, Pose(1, 2, 3)), Pose(1, 2, 3)
    for twist in twists:
        state, pose = chair.drive(twist, dt), Pose(*unicycle(*pose, *twist, dt))
        assert (state.x, state.y, state.theta, state.v, state.omega) == (*pose, *twist)


@given(TWISTS)
def test_as_a_wheelchair_it_tells_what_it_does_and_not_what_it_was_told(twists):
    chair, motion = VirtualChair(None, Pose(1, 2, 3), dynamics="wheelchair"), Motion(Pose(1, 2, 3))
    for twist in twists:
        state, motion = chair.drive(twist, 0.01), dynamics_step(motion, twist, 0.01, Wheelchair())
        assert (state.x, state.y, state.theta, state.v, state.omega) == (*motion.pose, motion.v, motion.omega)


def test_a_wheelchair_lags_behind_and_rolls_out():
    chair = VirtualChair(None, Pose(0, 0, 0), dynamics="wheelchair")
    assert 0 < chair.drive(FORWARD, 0.01).v < 0.1
    for _ in range(200):
        chair.drive(FORWARD, 0.01)
    assert 0.7 < chair.drive(Twist(0.0, 0.0), 0.01).v < 0.8
    for _ in range(300):
        state = chair.drive(Twist(0.0, 0.0), 0.01)
    assert (state.v, state.omega) == (0.0, 0.0)


@DYNAMICS
@given(st.lists(st.builds(Twist, st.floats(), st.floats()), max_size=30), st.floats())
def test_nothing_that_it_is_told_breaks_it(dynamics, twists, dt):
    chair = VirtualChair(PLAN, Pose(-2, 0, 0), dynamics=dynamics)
    for twist in twists:
        state = chair.drive(twist, dt)
        assert all(map(math.isfinite, (state.x, state.y, state.theta)))
        assert abs(state.v) <= 60 >= abs(state.omega)


@DYNAMICS
def test_placing_lets_it_stand(dynamics):
    chair = VirtualChair(None, Pose(0, 0, 0), dynamics=dynamics)
    for _ in range(50):
        chair.drive(Twist(0.5, 1.0), 0.01)
    chair.place(Pose(0, 0, 0))
    fresh = VirtualChair(None, Pose(0, 0, 0), dynamics=dynamics)
    assert chair.drive(FORWARD, 0.01) == fresh.drive(FORWARD, 0.01)


def test_a_misspelt_kind_of_dynamics_is_refused():
    with pytest.raises(ValueError, match="unicycle"):
        VirtualChair(None, Pose(0, 0, 0), dynamics="wheelchairs")


def test_what_moves_by_itself_moves_while_motion_is_permitted_and_holds_the_chair():
    guide = {"name": "guide", "kind": "person", "points": [[2, 3], [6, 3]], "pace": [[0, 0.5]], "radius": 0.3}
    plan = FloorPlan.model_validate({**PLAN.model_dump(), "walls": [], "obstacles": [], "movers": [guide]})
    chair = VirtualChair(plan, Pose(0.5, 3, 0))
    for _ in range(200):
        state = chair.drive(FORWARD, 0.01)
    assert state.scene_t == 0.0
    assert state.in_contact
    assert state.contacts == 1
    assert state.x == pytest.approx(2 - 0.3 - 0.32, abs=0.02)
    for _ in range(200):
        state = chair.drive(Twist(0.0, 0.0), 0.01, True)
    assert state.scene_t == pytest.approx(2.0)
    assert not state.in_contact, "he has gone on"
    chair.place(Pose(0.5, 3, 0))
    assert chair.state.scene_t == 0.0


poses = st.builds(Pose, st.floats(-10, 10), st.floats(-10, 10), st.floats(-3.1, 3.1))
twists = st.builds(Twist, st.floats(-1.5, 1.5), st.floats(-2.5, 2.5))


def test_a_quarter_of_a_circle():
    there = arc(Pose(0.0, 0.0, 0.0), Twist(math.pi / 2, math.pi / 2), 1.0)  # radius 1 m
    assert there == pytest.approx((1.0, 1.0, math.pi / 2))


def test_straight_ahead_and_on_the_spot():
    assert arc(Pose(1.0, 2.0, math.pi / 2), Twist(0.5, 0.0), 2.0) == pytest.approx((1.0, 3.0, math.pi / 2))
    assert arc(Pose(1.0, 2.0, 0.0), Twist(0.0, 1.0), 0.5) == pytest.approx((1.0, 2.0, 0.5))


@given(poses, twists, st.floats(0, 2), st.integers(1, 20))
def test_one_step_is_many(pose, twist, dt, count):
    there = pose
    for _ in range(count):
        there = arc(there, twist, dt / count)
    at_once = arc(pose, twist, dt)
    assert there[:2] == pytest.approx(at_once[:2], abs=1e-9)
    assert math.cos(there.theta - at_once.theta) == pytest.approx(1.0)


@given(poses, st.floats(-1.5, 1.5), st.floats(-1e-5, 1e-5))
def test_nearly_straight_is_nearly_straight(pose, v, omega):
    there, straight = arc(pose, Twist(v, omega), 1.0), arc(pose, Twist(v, 0.0), 1.0)
    assert there[:2] == pytest.approx(straight[:2], abs=1e-4)
