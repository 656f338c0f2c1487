"""The gate's states: ten thousand boots, the neutral check, what a chair or a screen says, counted stops."""

import math

import numpy as np
import pytest
from pipeline.gates import DT, SPEEDS, armed_gate, checking_gate, decide, moving_gate

from app.faults import EXPLANATIONS, Fault, State
from app.geometry import STANDSTILL, Twist
from app.pipeline.safety_gate import (
    CHAIR_SILENT,
    NEUTRAL_PATIENCE,
    NEUTRAL_TIME,
    SCREEN_SILENT,
    BadGestures,
    ChairCondition,
    SafetyGate,
)

READY, WAITING, INHIBITED = ChairCondition.READY, ChairCondition.WAITING, ChairCondition.INHIBITED


def test_ten_thousand_boots_and_not_one_command_but_zero():
    rng = np.random.default_rng(1)
    for wish in rng.normal(size=(10_000, 2)).tolist():
        gate = SafetyGate(SPEEDS, 100.0)
        assert decide(gate, 0.0) is State.DISARMED
        assert gate.fault is Fault.NONE
        assert gate.limit(Twist(*wish), DT) is STANDSTILL


def test_the_neutral_check_begins_when_it_is_first_looked_at():
    gate = checking_gate()
    assert decide(gate, 1000.0) is State.CHECKING
    assert decide(gate, 1000.0 + NEUTRAL_TIME - 1e-9) is State.CHECKING
    assert decide(gate, 1000.0 + NEUTRAL_TIME) is State.ARMED


def test_arming_again_does_not_shorten_the_check_nor_interrupt_a_drive():
    gate = checking_gate()
    decide(gate, 0.0)
    assert gate.arm()
    assert decide(gate, 0.3) is State.CHECKING
    assert decide(gate, NEUTRAL_TIME) is State.ARMED
    assert gate.arm()
    assert gate.state is State.ARMED


@pytest.mark.parametrize("leave", ["disarm", "clear"])
def test_after_any_way_out_the_whole_check_comes_again(leave):
    gate = moving_gate()
    if leave == "clear":
        gate.stop(Fault.STOP_TABLET)
        assert gate.clear(gate.stops)
    gate.disarm()
    assert gate.arm()
    assert decide(gate, 50.0) is State.CHECKING
    assert decide(gate, 50.0 + NEUTRAL_TIME - 1e-6) is State.CHECKING
    assert decide(gate, 50.0 + NEUTRAL_TIME) is State.ARMED


@pytest.mark.parametrize("begin", [0.0, 1024.0])
@pytest.mark.parametrize(("chair", "fault"), [(READY, Fault.NOT_NEUTRAL), (WAITING, Fault.CHAIR_NOT_READY)])
def test_the_patience_is_five_seconds_and_not_a_tick_less(begin, chair, fault):
    gate = checking_gate()
    neutral = chair is WAITING
    decide(gate, begin, neutral=neutral, chair=chair)
    assert decide(gate, begin + NEUTRAL_PATIENCE, neutral=neutral, chair=chair) is State.CHECKING
    assert decide(gate, begin + NEUTRAL_PATIENCE + 1e-9, neutral=neutral, chair=chair) is State.FAULT
    assert gate.fault is fault


def test_a_chair_that_is_not_ready_is_waited_for():
    gate = checking_gate()
    for i in range(200):
        assert decide(gate, i * DT, chair=WAITING) is State.CHECKING
    assert decide(gate, 2.0) is State.ARMED


@pytest.mark.parametrize(
    ("conditions", "fault"),
    [
        ({"chair": WAITING}, Fault.CHAIR_DISARMED),
        ({"chair": INHIBITED}, Fault.STOP_CHAIR),
        ({"chair_age": math.nextafter(CHAIR_SILENT, 1)}, Fault.CHAIR_SILENT),
        ({"chair_age": math.inf}, Fault.CHAIR_SILENT),
        ({"chair_age": math.nan}, Fault.CHAIR_SILENT),
        ({"screen_age": math.nextafter(SCREEN_SILENT, 1)}, Fault.SCREEN_LOST),
        ({"screen_age": math.nan}, Fault.SCREEN_LOST),
        ({"screen_age": math.inf, "screen": Fault.SCREEN_HIDDEN}, Fault.SCREEN_LOST),
        ({"screen": Fault.SCREEN_HIDDEN}, Fault.SCREEN_HIDDEN),
        ({"screen": Fault.SCREEN_SLOW, "chair_age": math.inf}, Fault.SCREEN_SLOW),
    ],
)
def test_what_the_chair_or_the_screen_does_not_say_stops(conditions, fault):
    gate = moving_gate()
    assert decide(gate, 1.0, **conditions) is State.FAULT
    assert gate.fault is fault
    assert abs(gate.limit(Twist(9.0, 9.0), DT).v) < SPEEDS.forward


def test_at_the_border_itself_it_drives_on():
    assert decide(moving_gate(), 1.0, chair_age=CHAIR_SILENT, screen_age=SCREEN_SILENT) is State.ARMED


@pytest.mark.parametrize(
    ("conditions", "fault"),
    [
        ({"screen": Fault.SCREEN_HIDDEN}, Fault.SCREEN_HIDDEN),
        ({"screen": Fault.SCREEN_SLOW}, Fault.SCREEN_SLOW),
        ({"chair": INHIBITED}, Fault.STOP_CHAIR),
    ],
)
def test_a_screen_that_does_not_count_and_a_pressed_switch_forbid_the_check_too(conditions, fault):
    gate = checking_gate()
    assert decide(gate, 0.0, **conditions) is State.FAULT
    assert gate.fault is fault


def test_one_bad_gesture_is_not_at_rest():
    gate = checking_gate()
    for i in range(501):
        assert decide(gate, i * DT, bad=BadGestures(1)) is State.CHECKING
    decide(gate, 5.02, bad=BadGestures(1))
    assert gate.fault is Fault.CHANNELS_BAD


def test_the_last_brake_that_breaks_stops_at_once():
    gate = moving_gate()
    assert decide(gate, 1.0, bad=BadGestures(1, brakes=False)) is State.ARMED
    assert decide(gate, 1.0, bad=BadGestures(1, brakes=True)) is State.FAULT
    assert gate.fault is Fault.BRAKE_BAD


def test_signals_that_no_movement_makes_stop_at_once_and_are_not_at_rest():
    gate = moving_gate()
    assert decide(gate, 1.0, bad=BadGestures(doubts=True)) is State.ARMED
    assert decide(gate, 1.0, bad=BadGestures(doubts=True, disbelieves=True)) is State.FAULT
    assert gate.fault is Fault.NO_MOVEMENT
    gate = checking_gate()
    for i in range(501):
        assert decide(gate, i * DT, bad=BadGestures(doubts=True, disbelieves=i % 2 == 0)) is State.CHECKING
    decide(gate, 5.02, bad=BadGestures(doubts=True))
    assert gate.fault is Fault.NO_MOVEMENT


def test_each_stop_counts_and_only_who_saw_the_last_clears():
    gate = armed_gate()
    gate.stop(Fault.STOP_TABLET)
    seen = gate.stops
    gate.stop(Fault.STOP_KEY)
    assert not gate.clear(seen)
    assert (gate.state, gate.fault) == (State.FAULT, Fault.STOP_TABLET)
    assert gate.clear(seen + 1)
    assert (gate.state, gate.fault) == (State.DISARMED, Fault.NONE)
    assert not gate.clear(gate.stops)


def test_a_fault_that_is_found_counts_too():
    gate = moving_gate()
    decide(gate, 1.0, recording=False)
    assert gate.stops == 1
    decide(gate, 1.1, recording=False)
    assert gate.stops == 1  # latched already: nothing is looked for any more


def test_every_fault_of_the_gate_has_words():
    assert set(EXPLANATIONS) == set(Fault)
    assert all(
        str(words.happened).endswith(".") and str(words.next_step).endswith(".") for words in EXPLANATIONS.values()
    )


def test_what_to_do_when_nothing_runs_does_not_name_continue():
    assert str(EXPLANATIONS[Fault.SHIRT_SILENT].remedy) == "Check its battery and cable, and look at the Shirt page."
    assert not [words for words in EXPLANATIONS.values() if "Continue" in str(words.remedy)]
    assert all(str(words.remedy).endswith(".") and ".." not in str(words.remedy) for words in EXPLANATIONS.values())
