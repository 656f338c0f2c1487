import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import STANDSTILL, Twist
from app.pipeline.shaping import Shaper
from app.speeds import Speeds
from building import make_parameters

control = st.floats(-1, 1)


def shaper(**changes):
    return Shaper(make_parameters().model_copy(update=changes))


def test_one_full_stroke_of_half_a_second_adds_about_a_third_of_a_metre_per_second():
    twist = STANDSTILL
    for i in range(50):
        u1 = 1 - abs(i - 24.5) / 25  # a stroke's activation rises and falls
        twist = shaper().step(u1 * 1.6 if u1 * 1.6 < 1 else 1.0, 0.0, twist, 0.01)
    assert twist.v == pytest.approx(0.32, abs=0.08)


def test_velocity_mode_is_the_papers_equation_once_the_ramp_is_over():
    velocity = shaper(mode_u1="velocity")
    twist = STANDSTILL
    for _ in range(300):
        twist = velocity.step(0.5, -0.25, twist, 0.01)
    assert twist.v == pytest.approx(0.5 * Speeds().forward)
    assert twist.omega == pytest.approx(-0.25 * Speeds().turn)


def test_backwards_only_through_standstill():
    velocity = shaper(mode_u1="velocity")
    twist, seen = Twist(0.8, 0.0), []
    for _ in range(300):
        twist = velocity.step(-1.0, 0.0, twist, 0.01)
        seen.append(twist.v)
    assert 0.0 in seen
    assert seen[-1] == -Speeds().reverse


@given(
    st.sampled_from(["velocity", "acceleration"]),
    st.sampled_from(["velocity", "acceleration"]),
    st.lists(st.tuples(control, control, st.floats(0, 0.1)), max_size=60),
)
def test_speeds_and_ramps_hold_for_any_controls(mode_u1, mode_u2, inputs):
    speeds = Speeds()
    shape = shaper(mode_u1=mode_u1, mode_u2=mode_u2)
    last = STANDSTILL
    for u1, u2, dt in inputs:
        twist = shape.step(u1, u2, last, dt)
        assert -speeds.reverse <= twist.v <= speeds.forward
        assert abs(twist.omega) <= speeds.turn
        assert abs(twist.v - last.v) <= max(speeds.acceleration, speeds.deceleration) * dt + 1e-9
        assert abs(twist.omega - last.omega) <= speeds.turn_acceleration * dt + 1e-9
        last = twist
