import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.world.kinematics import unicycle


def test_one_step_uses_the_heading_before_it():
    assert unicycle(1, 2, math.pi / 2, 0.5, 1.0, 0.1) == pytest.approx((1, 2.05, math.pi / 2 + 0.1))


def test_forward_along_x_and_turning_left():
    assert unicycle(0, 0, 0, 1, 0, 0.5) == (0.5, 0, 0)
    assert unicycle(0, 0, 0, 0, 1, 0.5) == (0, 0, 0.5)


@given(st.floats(-math.pi, math.pi), st.floats(-2, 2), st.floats(-3, 3), st.floats(0, 0.1))
def test_the_way_is_as_long_as_speed_and_time_say(theta, v, omega, dt):
    x, y, turned = unicycle(0, 0, theta, v, omega, dt)
    assert math.hypot(x, y) == pytest.approx(abs(v) * dt)
    assert -math.pi <= turned <= math.pi
    assert math.cos(turned) == pytest.approx(math.cos(theta + omega * dt))
