"""Dead reckoning of a chair: many small steps and one large step give equal poses."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import Pose, Twist
from app.hardware.chair.odometry import arc

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
