"""Measures the gate: deciding and limiting while armed, without a fault."""

from app.clock import stopwatch
from app.faults import State
from app.geometry import Twist
from app.pipeline.safety_gate import BadGestures, Conditions, SafetyGate
from app.speed_limits import Speeds
from bench.datagram import against_datagram
from bench.row import Row, reach_of

RUNS = 5
STEPS = 50_000
RATE = 1000.0  # Hz
REACH = reach_of(0.8, 0.3)  # of one loopback datagram
TURN_AFTER = 400  # steps between two changes of direction, so that the ramps are always in use


def measure_gate() -> list[Row]:
    """Return the time of one step of the gate, relative to one loopback datagram."""
    step, ratios = against_datagram(_step_time, RUNS)
    details = (
        f"{1e6 * step:.1f} us to decide and limit, armed, speeds changing all the time; {STEPS} in each of {RUNS} runs"
    )
    return [Row("gate, one step, against one loopback datagram", ratios, "x", REACH, "lower", details)]


def _step_time() -> float:
    """Return the mean duration of a step, s."""
    gate, conditions, nothing_bad = SafetyGate(Speeds(), RATE), Conditions(), BadGestures()
    wishes = [Twist(0.8, 1.2), Twist(-0.3, -1.2)]
    gate.arm()
    t = 0.0
    while gate.state is not State.ARMED:
        t += 1 / RATE
        gate.decide(t, 1 / RATE, True, nothing_bad, 0.0, conditions)
    before = stopwatch()
    for i in range(STEPS):
        t += 1 / RATE
        gate.decide(t, 1 / RATE, False, nothing_bad, 0.0, conditions)
        gate.limit(wishes[i // TURN_AFTER % 2], 1 / RATE)
    duration = stopwatch() - before
    if gate.state is not State.ARMED:
        raise RuntimeError(f"the gate of the benchmark stopped: {gate.fault.name}")
    return duration / STEPS
