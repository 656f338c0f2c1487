import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import STANDSTILL, Twist
from app.pipeline.shaping import REST, TURN_BUILD_UP, Cruise, Shaper, forward_ramp, turn_ramp
from app.speed_limits import Speeds
from building import make_parameters

control = st.floats(-1, 1)


def shaper(**changes):
    return Shaper(make_parameters().model_copy(update=changes))


def driven(shape, wishes, twist=STANDSTILL, dt=0.01):
    """Return the twists that follow from (u1, u2)."""
    rates, seen = STANDSTILL, []
    for u1, u2 in wishes:
        after = shape.step(u1, u2, twist, rates, dt)
        rates = Twist((after.v - twist.v) / dt, (after.omega - twist.omega) / dt)
        twist = after
        seen.append(twist)
    return seen


def test_one_full_stroke_of_half_a_second_adds_about_a_third_of_a_metre_per_second():
    stroke = [(min(1.0, 1.6 * (1 - abs(i - 24.5) / 25)), 0.0) for i in range(50)]  # an activation rises and falls
    assert driven(shaper(), stroke)[-1].v == pytest.approx(0.32, abs=0.08)


def test_velocity_mode_is_the_papers_equation_once_the_ramp_is_over():
    twist = driven(shaper(mode_u1="velocity"), [(0.5, -0.25)] * 300)[-1]
    assert twist == Twist(0.5 * Speeds().forward, -0.25 * Speeds().turn)


def test_backwards_only_through_standstill():
    seen = [twist.v for twist in driven(shaper(mode_u1="velocity"), [(-1.0, 0.0)] * 300, Twist(0.8, 0.0))]
    assert 0.0 in seen
    assert seen[-1] == -Speeds().reverse
    assert seen == sorted(seen, reverse=True)


def test_a_wish_for_more_than_the_reverse_speed_gets_the_reverse_speed():
    assert driven(shaper(mode_u1="velocity"), [(-0.9, 0.0)] * 300)[-1].v == -Speeds().reverse


def test_acceleration_mode_adds_what_is_asked_and_keeps_it():
    assert shaper().speed(0.5, 0.2, 0.0, 0.01) == 0.2 + 0.5 * Speeds().acceleration * 0.01
    assert shaper().speed(-0.5, 0.2, 0.0, 0.01) == 0.2 - 0.5 * Speeds().acceleration * 0.01
    assert shaper().speed(0.0, 0.2, 0.0, 0.01) == 0.2
    turning = shaper(mode_u2="acceleration")
    assert turning.turn_rate(-0.5, 0.1, 0.0, 0.01) == 0.1 - 0.5 * Speeds().turn / TURN_BUILD_UP * 0.01
    assert turning.turn_rate(0.0, 0.1, 0.0, 0.01) == 0.1


def test_a_cruise_that_nobody_asks_for_runs_out():
    shape = shaper(cruise_time=2.0)
    seen = [twist.v for twist in driven(shape, [(0.0, 0.0)] * 400, Twist(0.6, 0.0))]
    assert seen[:199] == [0.6] * 199
    assert seen[204] < 0.6
    assert seen[-1] == 0.0


@pytest.mark.parametrize("axis", [0, 1])
@pytest.mark.parametrize("sign", [1, -1])
def test_any_intention_lets_the_speed_or_the_turn_go_on(sign, axis):
    shape = shaper(mode_u2="acceleration", cruise_time=2.0, turn_cruise_time=2.0)
    wish = (sign * 1e-6, 0.0) if axis == 0 else (0.0, sign * 1e-6)
    begin = Twist(0.6, 0.0) if axis == 0 else Twist(0.0, 0.5)
    rest_and_wish = [(0.0, 0.0)] * 150 + [wish]
    assert driven(shape, rest_and_wish * 4, begin)[-1][axis] == pytest.approx(begin[axis], abs=1e-5)


def test_a_new_permission_begins_both_time_outs_anew():
    shape = shaper(mode_u2="acceleration", cruise_time=2.0, turn_cruise_time=2.0)
    driven(shape, [(0.0, 0.0)] * 150, Twist(0.6, 0.5))
    shape.reset()
    assert driven(shape, [(0.0, 0.0)] * 190, Twist(0.6, 0.5))[-1] == Twist(0.6, 0.5)


def test_in_velocity_mode_nothing_runs_out():
    shape = shaper(mode_u1="velocity", cruise_time=1.0, turn_cruise_time=1.0)
    assert driven(shape, [(1.0, 1.0)] * 500)[-1] == Twist(Speeds().forward, Speeds().turn)
    assert shape.cruise is shape.turn_cruise is None


def test_turning_that_nobody_asks_for_runs_out_by_itself_and_at_its_own_time():
    shape = shaper(mode_u2="acceleration", cruise_time=4.0, turn_cruise_time=2.0)
    seen = driven(shape, [(0.0, 0.0)] * 300, Twist(0.6, -0.5))
    assert [twist.omega for twist in seen[:199]] == [-0.5] * 199
    assert -0.5 < seen[202].omega < 0.0
    assert seen[-1] == Twist(0.6, 0.0)


@pytest.mark.parametrize("name", ["u1", "u2"])
def test_a_wish_that_never_rests_ends_with_the_time_out_and_counts_again_after_a_rest(name):
    shape = shaper(mode_u2="acceleration", cruise_time=4.0, turn_cruise_time=4.0)
    wish, rest = ((1.0, 0.0), (0.0, 0.0)) if name == "u1" else ((0.0, 1.0), (0.0, 0.0))
    stuck = driven(shape, [wish] * 900)
    moved = [abs(twist.v) + abs(twist.omega) for twist in stuck]
    assert moved[398] > 0.5
    assert moved[-1] == 0.0
    again = driven(shape, [rest] * 35 + [wish] * 100)
    assert abs(again[-1].v) + abs(again[-1].omega) > 0.3


def test_pushing_again_and_again_is_no_stuck_sensor():
    shape = shaper(cruise_time=1.0)
    seen = [twist.v for twist in driven(shape, ([(1.0, 0.0)] * 60 + [(0.0, 0.0)] * 35) * 30)]
    assert seen == sorted(seen)


def test_a_short_time_out_permits_a_push_of_three_seconds():
    seen = [twist.v for twist in driven(shaper(cruise_time=1.0), [(1.0, 0.0)] * 350)]
    assert seen[:299] == sorted(seen[:299])
    assert seen[-1] < seen[310]


@given(st.lists(st.tuples(st.sampled_from([0.0, 0.5]), st.integers(1, 300)), max_size=8))
def test_coasting_at_once_is_coasting_step_by_step(pieces):
    at_once, stepped = Cruise(3.5), Cruise(3.5)
    for control, length in pieces:
        went_on = [stepped.goes_on(control, 0.01) for _ in range(length)]
        count = went_on.index(False) if False in went_on else length
        assert at_once.coast(control, np.full(length, 0.01)) == count
        if count < length:
            return


@pytest.mark.parametrize("control", [0.0, 1.0])
def test_the_time_out_itself_still_goes_on_and_a_tick_more_does_not(control):
    cruise = Cruise(4.0)
    assert [cruise.goes_on(control, 0.5) for _ in range(9)] == [True] * 8 + [False]
    assert Cruise(4.0).coast(control, np.full(9, 0.5)) == 8


@pytest.mark.parametrize(("rest", "count"), [(REST, 1), (0.125, 0)])
def test_a_rest_of_its_length_lets_pushing_begin_anew_and_a_shorter_one_does_not(rest, count):
    stepped, at_once = Cruise(4.0), Cruise(4.0)
    for control, step in ((1.0, 3.75), (0.0, rest)):
        assert stepped.goes_on(control, step)
        assert at_once.coast(control, np.array([step])) == 1
    assert stepped.goes_on(1.0, 3.75) == bool(count)
    assert at_once.coast(1.0, np.array([3.75])) == count


def test_a_single_step_past_the_time_out_is_none():
    cruise = Cruise(4.0)
    assert cruise.coast(1.0, np.array([3.9375])) == 1
    assert cruise.coast(0.0, np.array([0.125])) == 0
    cruise.reset()
    assert cruise.coast(1.0, np.array([3.875])) == 1
    assert cruise.coast(0.0, np.array([0.125])) == 1


def test_lower_limits_are_shaped_within():
    shape = shaper(mode_u1="velocity")
    shape.restrict(Speeds(forward=0.4, turn=0.5))
    assert driven(shape, [(1.0, -1.0)] * 300)[-1] == Twist(0.4, -0.5)


# The loop's longest wait is 20 ms; of the step after a hold-up of nearly 100 ms the gate may take off a little.
@given(st.lists(st.tuples(st.floats(-0.3, 0.8), st.floats(-0.8, 0.8)), max_size=60), st.floats(0.001, 0.05))
def test_the_gate_grants_a_shaped_wish_as_it_is(wishes, dt):
    shape = shaper(mode_u1="velocity")
    forward, turn = forward_ramp(Speeds()), turn_ramp(Speeds())
    last, rates = STANDSTILL, STANDSTILL
    for u1, u2 in wishes:
        asked = shape.step(u1, u2, last, rates, dt)
        assert forward.bounded(last.v, rates.v, asked.v, dt) == pytest.approx(asked.v, abs=1e-9)
        assert turn.bounded(last.omega, rates.omega, asked.omega, dt) == pytest.approx(asked.omega, abs=1e-9)
        rates = Twist((asked.v - last.v) / dt, (asked.omega - last.omega) / dt)
        last = asked
