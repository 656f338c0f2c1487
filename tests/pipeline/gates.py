"""A gate in the states that its tests begin with."""

import pytest

from app.faults import State
from app.geometry import Twist
from app.pipeline.safety_gate import BadGestures, Conditions, SafetyGate
from app.speed_limits import Speeds

DT = 0.01
SPEEDS = Speeds()


def decide(gate, t, *, pause=DT, neutral=True, bad=BadGestures(), age=0.0, **conditions):  # noqa: B008  (it is a tuple)
    return gate.decide(t, pause, neutral, bad, age, Conditions(**conditions))


def checking_gate(speeds=SPEEDS):
    gate = SafetyGate(speeds, 100.0)
    assert gate.arm()
    return gate


def armed_gate(speeds=SPEEDS):
    gate = checking_gate(speeds)
    for i in range(60):
        decide(gate, i * DT)
    assert gate.state is State.ARMED
    return gate


def moving_gate():
    gate = armed_gate()
    for _ in range(200):
        gate.limit(Twist(9.0, 9.0), DT)
    assert gate.last == pytest.approx(Twist(SPEEDS.forward, SPEEDS.turn))
    return gate
