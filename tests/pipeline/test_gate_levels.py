"""The gate's limits: several levels of them, the ramps, no step of very many above one."""

import math
import os

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pipeline.gates import DT, SPEEDS, armed_gate, moving_gate

from app.faults import Fault, State
from app.geometry import STANDSTILL, Twist
from app.pipeline.safety_gate import BadGestures, Conditions, shirt_limits
from app.speed_limits import HIGHEST_SPEEDS, Speeds, apply_dial, most_restrictive

SMALLEST = {"acceleration": 0.1, "deceleration": 0.1, "turn_acceleration": 0.1, "jerk": 0.5, "turn_jerk": 1.0}


@pytest.mark.parametrize("going", [Twist(0.6, 0.0), Twist(0.0, -0.9)])
def test_a_stop_of_one_axis_alone_is_a_ramp_too(going):
    gate = armed_gate()
    gate.last = going
    gate.stop(Fault.STOP_KEY)
    twist = gate.limit(STANDSTILL, DT)
    assert 0.9 * max(map(abs, going)) < max(map(abs, twist)) < max(map(abs, going))


@pytest.mark.parametrize("name", list(Speeds.model_fields))
def test_a_lower_limit_holds_at_once_and_a_higher_one_only_at_rest(name):
    lower = SPEEDS.model_copy(update={name: max(0.5 * getattr(SPEEDS, name), SMALLEST.get(name, 0.0))})
    gate = moving_gate()
    assert gate.restrict(lower, neutral=False)
    assert gate.limits == lower
    assert not gate.restrict(SPEEDS, neutral=True)  # it moves
    assert gate.limits == lower
    gate.disarm()
    for _ in range(50):
        gate.limit(STANDSTILL, DT)
    assert not gate.restrict(SPEEDS, neutral=False)
    assert gate.restrict(SPEEDS, neutral=True)
    assert gate.limits == SPEEDS


def test_a_speed_above_a_limit_that_was_lowered_comes_down_at_the_deceleration():
    gate = moving_gate()
    assert gate.restrict(apply_dial(SPEEDS, 0.5), neutral=False)
    twists = [gate.limit(Twist(9.0, 9.0), DT) for _ in range(200)]
    speeds = [twist.v for twist in twists]
    assert speeds == sorted(speeds, reverse=True)
    assert twists[-1] == pytest.approx((0.4, 0.6), abs=1e-6)
    assert max(-np.diff(speeds)) <= SPEEDS.deceleration * DT * (1 + 1e-6)


levels = st.builds(
    Speeds,
    forward=st.floats(0.05, 1.5),
    reverse=st.floats(0.05, 1.5),
    turn=st.floats(0.05, 2.5),
    acceleration=st.floats(0.1, 3.0),
    deceleration=st.floats(0.1, 3.0),
    turn_acceleration=st.floats(0.1, 20.0),
    jerk=st.floats(0.5, 20.0),
    turn_jerk=st.floats(1.0, 400.0),
)


@given(st.lists(st.tuples(levels, st.booleans(), st.booleans()), max_size=20))
def test_no_limit_ever_rises_but_at_standstill_and_neutral(steps):
    gate = armed_gate()
    for wanted, neutral, moves in steps:
        if moves:
            gate.limit(Twist(0.3, 0.1), DT)
        before, stood = gate.limits, gate.last == STANDSTILL
        done = gate.restrict(wanted, neutral)
        assert gate.limits == (wanted if done else before)
        raised = any(getattr(gate.limits, name) > getattr(before, name) for name in Speeds.model_fields)
        assert not raised or (neutral and stood)


@given(levels, levels, levels, st.floats(0.1, 1))
def test_of_several_levels_the_smallest_holds(own, clinic, chair, share):
    smallest = most_restrictive(own, clinic, chair)
    for name in Speeds.model_fields:
        assert getattr(smallest, name) == min(getattr(level, name) for level in (own, clinic, chair))
        assert getattr(HIGHEST_SPEEDS, name) >= getattr(apply_dial(smallest, share), name)


def test_after_a_drive_the_ramps_begin_at_nothing():
    gate = moving_gate()
    gate.disarm()
    assert gate.rates == STANDSTILL
    gate.stand()
    assert (gate.last, gate.rates) == (STANDSTILL, STANDSTILL)


def test_a_step_without_time_leaves_the_ramps_alone():
    gate = armed_gate()
    gate.limit(Twist(9.0, 9.0), DT)
    before = gate.last, gate.rates
    gate.limit(Twist(9.0, 9.0), 0.0)
    assert (gate.last, gate.rates) == before


def test_the_rates_are_what_the_speeds_did():
    gate = armed_gate()
    first = gate.limit(Twist(9.0, -9.0), DT)
    assert gate.rates == pytest.approx((first.v / DT, first.omega / DT))
    assert (first.v, first.omega) == pytest.approx((SPEEDS.jerk * DT * DT, -SPEEDS.turn_jerk * DT * DT))


@pytest.mark.parametrize(
    ("rate", "limits"),
    [(59.999, (3 / 59.999, 12 / 59.999)), (60.0, (0.05, 0.2)), (100, (0.05, 0.2)), (20, (0.15, 0.6)), (10, (0.3, 1.2))],
)
def test_the_shirt_s_limits_change_over_at_60_hz(rate, limits):
    assert shirt_limits(rate) == pytest.approx(limits)


STEPS = int(os.environ.get("BODYDRIVE_GATE_STEPS", "100000"))  # `make safety` takes a million
NOT_NUMBERS = (math.nan, math.inf, -math.inf)
ODD = (0.0, -0.0, 1e308, -1e308, 5e-324, 9.0, -9.0)


def test_no_step_of_very_many_gets_past_a_limit():
    rng = np.random.default_rng(STEPS)
    gate, t, before = armed_gate(), 1.0, (STANDSTILL, STANDSTILL)
    for _ in range(STEPS // 1000):
        dts = np.where(rng.random(1000) < 0.8, DT, rng.uniform(0, 0.1, 1000)).tolist()
        wishes = np.where(rng.random((1000, 2)) < 0.4, rng.choice(ODD, (1000, 2)), rng.normal(size=(1000, 2))).tolist()
        events = rng.random(1000).tolist()
        for dt, wish, event in zip(dts, wishes, events, strict=True):
            t += dt
            if event < 0.002:
                gate.stop(Fault.STOP_KEY)
            elif event < 0.004:
                wish[0 if event < 0.003 else 1] = rng.choice(NOT_NUMBERS)
            elif event < 0.02 and gate.state is State.FAULT:
                gate.clear(gate.stops)
            elif gate.state is State.DISARMED:
                gate.arm()
            state = gate.decide(t, dt, True, BadGestures(), 0.0, Conditions())
            twist = gate.limit(Twist(*wish), dt)
            drove = state is State.ARMED and gate.state is State.ARMED and dt > 0.0
            for axis, (low, high, up, down, jerk) in enumerate(AXES):
                speed, was, change = twist[axis], before[0][axis], gate.rates[axis]
                assert low <= speed <= high
                if drove:
                    most = up if was * change > 0 else max(up, down)
                    assert abs(change) <= most * (1 + 1e-6)
                    assert abs(change - before[1][axis]) <= jerk * dt * (1 + 1e-6) + 1e-6
                else:
                    assert abs(speed) <= abs(was)
            before = gate.last, gate.rates


AXES = (
    (-SPEEDS.reverse, SPEEDS.forward, SPEEDS.acceleration, SPEEDS.deceleration, SPEEDS.jerk),
    (-SPEEDS.turn, SPEEDS.turn, SPEEDS.turn_acceleration, SPEEDS.turn_acceleration, SPEEDS.turn_jerk),
)
