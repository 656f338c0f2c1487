"""A late screen pauses the virtual chair, which goes on by itself; a real chair and other stops stay as they are."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.faults import Fault, State
from app.pipeline.loop import PUNCTUAL, ScreenPause
from app.pipeline.safety_gate import NEUTRAL_TIME, BadGestures, ChairCondition, Conditions, SafetyGate
from app.speed_limits import Speeds

LATE = [("slow", 0.0, Fault.SCREEN_SLOW), ("hidden", 0.0, Fault.SCREEN_HIDDEN), ("in view", None, Fault.SCREEN_LOST)]


@pytest.fixture
def armed(control, tmp_path):
    """A trial on the virtual chair that may move."""
    control.live(0.1)
    control.done("run", run_id="a", folder=str(tmp_path / "a"), kind="drive")
    control.done("arm", hash=control.parameters.hash)
    control.live(NEUTRAL_TIME + 0.1)
    assert state(control) == (State.ARMED, Fault.NONE)
    return control


def state(control):
    tick = control.ring.newest()
    return State(int(tick["state"])), Fault(int(tick["fault"]))


def report(control, seconds, screen="in view", screen_age=0.0):
    """Turn the loop for a while, with a heartbeat ten times a second that says this of the screen."""
    until = control.clock.now() + seconds
    while control.clock.now() < until:
        beat = control.clock.now() + 0.1
        control.notify("heartbeat", screen=screen, screen_age=screen_age)
        while control.clock.now() < min(beat, until):
            control.loop.turn()


@pytest.mark.parametrize(("screen", "age", "fault"), LATE)
def test_a_late_screen_pauses_the_trial_and_it_goes_on_by_itself(armed, screen, age, fault):
    stops = armed.setup.chain.gate.stops
    report(armed, 4.0, screen, age)
    assert state(armed) == (State.DISARMED, fault)
    report(armed, PUNCTUAL - 0.1)
    assert state(armed) == (State.DISARMED, fault)
    report(armed, 0.3)
    assert state(armed) == (State.CHECKING, Fault.NONE)
    report(armed, NEUTRAL_TIME)
    assert state(armed) == (State.ARMED, Fault.NONE)
    assert armed.setup.chain.gate.stops == stops  # nothing was latched


def test_reports_count_as_punctual_only_in_a_row(armed):
    report(armed, 0.5, "slow")
    for _ in range(3):
        report(armed, PUNCTUAL - 0.2)
        report(armed, 0.2, "slow")
    assert state(armed) == (State.DISARMED, Fault.SCREEN_SLOW)


@pytest.mark.parametrize("by", ["tablet", "key", "picture"])
def test_a_stop_ends_the_pause_and_waits_for_a_person(armed, by):
    report(armed, 0.5, "slow")
    armed.done("stop", by=by)
    report(armed, 10.0)
    assert state(armed)[0] is State.FAULT
    armed.done("clear", stops=int(armed.ring.newest()["stops"]))
    report(armed, 1.0)
    assert state(armed) == (State.ARMED, Fault.NONE)


@pytest.mark.parametrize("ending", ["disarm", "end_run"])
def test_what_is_ended_during_a_pause_is_not_armed_again(armed, ending):
    report(armed, 0.5, "slow")
    armed.done(ending)
    report(armed, 5.0)
    assert state(armed) == (State.DISARMED, Fault.NONE)
    assert armed.setup.chain.gate.state is State.DISARMED


def test_a_silent_web_process_is_a_fault_also_during_a_pause(armed):
    report(armed, 0.5, "slow")
    until = armed.clock.now() + 0.4
    while armed.clock.now() < until:
        armed.loop.turn()
    assert state(armed) == (State.FAULT, Fault.WEB_SILENT)
    report(armed, 5.0)
    assert state(armed) == (State.FAULT, Fault.WEB_SILENT)


@pytest.mark.uncompiled
def test_a_patient_who_is_not_at_rest_after_a_pause_is_not_driven(armed, monkeypatch):
    report(armed, 0.5, "slow")
    monkeypatch.setattr("app.pipeline.controls.Controls.is_neutral", lambda *_: False)
    decoder = armed.setup.chain._decoder
    step = decoder.step
    monkeypatch.setattr(decoder, "step", lambda *given: (step(*given), setattr(decoder, "is_active", True)))
    report(armed, PUNCTUAL + 4.0)
    assert state(armed)[0] is State.CHECKING
    report(armed, 2.0)
    assert state(armed) == (State.FAULT, Fault.NOT_NEUTRAL)


class ReadyLink:
    """The link of a real chair that is always ready."""

    ready = stands = True
    inhibited = False
    due = math.inf

    def longest_wait(self, deadline, t):
        return deadline - t

    def age(self, _t):
        return 0.0

    def listen(self, t): ...

    def send(self, state, limits, t): ...

    def report(self, tick, t): ...


def test_a_real_chair_keeps_its_latched_fault(armed, monkeypatch):
    monkeypatch.setattr(armed.setup, "link", ReadyLink())
    report(armed, 0.2, "slow")
    assert state(armed) == (State.FAULT, Fault.SCREEN_SLOW)
    report(armed, 5.0)
    assert state(armed) == (State.FAULT, Fault.SCREEN_SLOW)


ages = st.floats(0.0, 1.0) | st.sampled_from([math.nan, math.inf])
faults = st.sampled_from([Fault.NONE, Fault.SCREEN_HIDDEN, Fault.SCREEN_SLOW])
turns = st.tuples(st.floats(0.001, 0.2), ages, faults, ages, st.sampled_from(["", "", "", "stop", "disarm"]))


@given(st.lists(turns, max_size=200))
def test_it_arms_nothing_but_what_it_paused(steps):
    gate, pause, t = SafetyGate(Speeds(), 100.0), ScreenPause(), 0.0
    gate.arm()
    for step, age, screen, web, person in steps:
        t += step
        if person == "stop":
            gate.stop(Fault.STOP_TABLET)
        elif person == "disarm":
            gate.disarm()
            pause.end()
        before = gate.state
        conditions = Conditions(supervisor_age=web, screen_age=age, screen=screen, chair=ChairCondition.READY)
        paused = pause.reason
        if pause.decide(t, gate, conditions):
            assert before is State.DISARMED
            assert paused is not Fault.NONE
            assert person == ""
            gate.arm()
        if before is State.FAULT:
            assert gate.state is State.FAULT
        if not age <= 0.3 or screen is not Fault.NONE:
            assert gate.state not in (State.CHECKING, State.ARMED)
        assert (pause.reason is Fault.NONE) or gate.state is State.DISARMED
        gate.decide(t, step, True, BadGestures(), 0.0, conditions)
