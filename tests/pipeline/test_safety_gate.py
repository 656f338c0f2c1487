"""The gate: denial by default, values around every limit, armed and not, each fault."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pipeline.gates import DT, SPEEDS, armed_gate, checking_gate, decide, moving_gate

from app.faults import Fault, State
from app.geometry import STANDSTILL, Twist
from app.pipeline.safety_gate import (
    LOOP_STALL,
    NEUTRAL_PATIENCE,
    NEUTRAL_TIME,
    WEB_SILENT,
    BadGestures,
    SafetyGate,
    shirt_limits,
)
from app.pipeline.stop_ramp import STOP_TIME

anything = st.floats(allow_nan=True, allow_infinity=True)


def test_it_boots_disarmed_and_sends_exactly_zero():
    gate = SafetyGate(SPEEDS, 100.0)
    assert gate.state is State.DISARMED
    for i in range(1000):
        decide(gate, i * DT)
        assert gate.limit(Twist(0.5, 0.5), DT) is STANDSTILL


def test_motion_waits_for_half_a_second_at_rest():
    gate = checking_gate()
    armed_at = next(i * DT for i in range(500) if decide(gate, i * DT) is State.ARMED)
    assert NEUTRAL_TIME <= armed_at <= NEUTRAL_TIME + DT


def test_a_twitch_begins_the_half_second_anew():
    gate = checking_gate()
    for i in range(90):
        assert decide(gate, i * DT, neutral=i != 45) is State.CHECKING
        assert gate.limit(Twist(1.0, 1.0), DT) is STANDSTILL


def test_never_at_rest_is_a_latched_fault_after_five_seconds():
    gate = checking_gate()
    steps = 0
    while decide(gate, steps * DT, neutral=False) is State.CHECKING:
        steps += 1
    assert steps * DT == pytest.approx(NEUTRAL_PATIENCE + DT, abs=DT)
    assert gate.fault is Fault.NOT_NEUTRAL
    assert not gate.arm()
    gate.clear(gate.stops)
    assert gate.state is State.DISARMED
    assert gate.arm()


@pytest.mark.parametrize(
    ("name", "limit", "fault"),
    [
        ("pause", LOOP_STALL, Fault.LOOP_LATE),
        ("supervisor_age", WEB_SILENT, Fault.WEB_SILENT),
        ("age", shirt_limits(100.0)[1], Fault.SHIRT_SILENT),
    ],
)
def test_every_limit_in_time_around_its_border(name, limit, fault):
    for value in np.linspace(0, limit, 50):
        assert decide(moving_gate(), 1.0, **{name: float(value)}) is State.ARMED
    for value in [np.nextafter(limit, 9), limit * 1.01, limit * 10, 1e308, math.inf, math.nan]:
        gate = moving_gate()
        assert decide(gate, 1.0, **{name: float(value)}) is State.FAULT
        assert gate.fault is fault


@pytest.mark.parametrize(
    ("condition", "fault"),
    [
        ({"screen_age": math.inf}, Fault.SCREEN_LOST),
        ({"recording": False}, Fault.RECORDING_LOST),
        ({"bad": BadGestures(2)}, Fault.CHANNELS_BAD),
    ],
)
def test_every_other_condition(condition, fault):
    gate = moving_gate()
    assert decide(gate, 1.0, **condition) is State.FAULT
    assert gate.fault is fault
    assert decide(checking_gate(), 0.0, **condition) is State.FAULT


@pytest.mark.parametrize("dt", [0.001, 0.01, 0.02])
@pytest.mark.parametrize("way", ["stop", "disarm"])
def test_from_any_speed_to_standstill_within_the_stop_time_and_never_faster_again(way, dt):
    for v in np.linspace(-SPEEDS.reverse, SPEEDS.forward, 12):
        for omega in np.linspace(-SPEEDS.turn, SPEEDS.turn, 7):
            gate = armed_gate()
            gate.last = Twist(float(v), float(omega))
            gate.stop(Fault.STOP_TABLET) if way == "stop" else gate.disarm()
            last, elapsed = gate.last, 0.0
            while gate.last is not STANDSTILL:
                twist = gate.limit(Twist(5.0, 5.0), dt)
                assert abs(twist.v) <= abs(last.v)
                assert abs(twist.omega) <= abs(last.omega)
                last, elapsed = twist, elapsed + dt
            assert elapsed <= STOP_TIME + 2 * dt


def test_a_stop_latches_keeps_its_first_reason_and_can_be_given_twice():
    gate = moving_gate()
    gate.stop(Fault.STOP_TABLET)
    gate.stop(Fault.STOP_KEY)
    gate.disarm()
    assert (gate.state, gate.fault) == (State.FAULT, Fault.STOP_TABLET)
    assert not gate.arm()
    for i in range(100):
        decide(gate, 2 + i * DT)
        gate.limit(Twist(1.0, 1.0), DT)
    assert (gate.state, gate.last) == (State.FAULT, STANDSTILL)


def test_a_stop_counts_while_disarmed_too():
    gate = SafetyGate(SPEEDS, 100.0)
    gate.stop(Fault.STOP_TABLET)
    assert not gate.arm()


def test_clearing_never_moves():
    gate = moving_gate()
    gate.stop(Fault.STOP_GESTURE)
    gate.clear(gate.stops)
    assert gate.state is State.DISARMED
    speeds = [gate.limit(Twist(1.0, 1.0), DT).v for _ in range(40)]
    assert speeds == sorted(speeds, reverse=True)
    assert speeds[-1] == 0


@pytest.mark.parametrize("nonsense", [math.nan, math.inf, -math.inf])
def test_what_is_not_a_number_stops(nonsense):
    for twist in (Twist(nonsense, 0.0), Twist(0.0, nonsense)):
        gate = moving_gate()
        gate.limit(twist, DT)
        assert gate.fault is Fault.BAD_NUMBER


@settings(max_examples=300)
@given(
    st.lists(
        st.tuples(
            anything, anything, st.floats(0, 0.1), st.sampled_from(["", "", "", "arm", "stop", "clear", "disarm"])
        ),
        max_size=80,
    )
)
def test_no_input_whatever_gets_past_speed_and_acceleration(steps):
    gate = armed_gate()
    last = gate.last
    t = 1.0
    for v, omega, dt, event in steps:
        if event == "arm":
            gate.arm()
        elif event == "stop":
            gate.stop(Fault.STOP_KEY)
        elif event == "clear":
            gate.clear(gate.stops)
        elif event == "disarm":
            gate.disarm()
        t += dt
        state = decide(gate, t, pause=dt)
        twist = gate.limit(Twist(v, omega), dt)
        assert -SPEEDS.reverse <= twist.v <= SPEEDS.forward
        assert abs(twist.omega) <= SPEEDS.turn
        if state is State.ARMED and gate.state is State.ARMED:
            assert abs(twist.v - last.v) <= SPEEDS.deceleration * dt + 1e-9
            assert abs(twist.omega - last.omega) <= SPEEDS.turn_acceleration * dt + 1e-9
        else:
            assert abs(twist.v) <= abs(last.v)
        last = twist


@pytest.mark.parametrize("again", [SafetyGate.disarm, lambda gate: gate.stop(Fault.STOP_TABLET)])
def test_a_stop_on_the_way_to_standstill_does_not_make_it_longer(again):
    gate = moving_gate()
    gate.disarm()
    for _ in range(round(STOP_TIME / DT / 2)):
        gate.limit(STANDSTILL, DT)
    again(gate)
    for _ in range(round(STOP_TIME / DT / 2) + 1):
        gate.limit(STANDSTILL, DT)
    assert gate.last is STANDSTILL
