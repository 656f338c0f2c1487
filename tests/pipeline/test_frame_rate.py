"""A shirt that sends at another rate than the chain counts on is stopped, and one that only loses or bunches is not."""

import numpy as np
import pytest

from app.faults import Fault, State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain, FrameRate
from app.pipeline.safety_gate import Conditions
from building import make_parameters, make_signals

RATE = 100.0


def counted(rate, seconds=6.0, lost=0.0, jitter=0.0, burst=1, coarse=0.0):
    """Return whether a shirt of this true rate is said to differ, at any time."""
    random = np.random.default_rng(1)
    check, found, arrival = FrameRate(RATE), False, 0.0
    for i in range(round(seconds * rate)):
        if random.random() < lost:
            continue
        t_device = i / rate if not coarse else np.floor(i / rate / coarse) * coarse
        arrival = max(arrival, (i // burst * burst + burst) / rate + random.uniform(0.0, jitter))
        check.step(i, t_device, arrival)
        found |= check.differs
    return found


@pytest.mark.parametrize("rate", [48.0, 60.0, 70.0, 130.0, 200.0, 500.0, 1000.0])
def test_another_rate_differs(rate):
    assert counted(rate)


@pytest.mark.parametrize("rate", [82.0, 95.0, 100.0, 105.0, 118.0])
@pytest.mark.parametrize("how", [{}, {"lost": 0.3}, {"jitter": 0.1}, {"burst": 10}, {"coarse": 0.1}])
def test_losses_jitter_bursts_and_a_coarse_clock_do_not(rate, how):
    assert not counted(rate, **how)


def test_a_device_that_starts_anew_or_has_no_counter_is_not_judged():
    check = FrameRate(RATE)
    for i in range(1000):
        check.step(i % 300, (i % 300) / RATE, i / RATE)
        assert not check.differs
    check = FrameRate(RATE)
    for i in range(1000):
        check.step(0, i / RATE, i / RATE)
        assert not check.differs


@pytest.mark.parametrize("has_clock", [True, False])
@pytest.mark.parametrize("true_rate", [200.0, 500.0])
def test_a_shirt_of_another_rate_neither_arms_nor_goes_on(true_rate, has_clock):
    parameters = make_parameters()
    frames = make_signals(parameters, 3000, strokes=False)
    chain = Chain(RATE, parameters, VirtualChair(None, Pose(0.0, 0.0, 0.0)))

    def drive(first, rate, count, begin):
        for i in range(count):
            t = begin + i / rate
            t_device = t if has_clock else (first + i) / RATE
            tick = chain.step(SensorFrame(first + i, t_device, t, frames[(first + i) % 3000]), t, Conditions())
        return tick

    tick = drive(0, true_rate, round(2.5 * true_rate), 0.0)
    assert chain.arm()
    tick = drive(round(2.5 * true_rate), true_rate, round(0.1 * true_rate), 2.5)
    assert (tick.state, tick.fault) == (State.FAULT, Fault.SHIRT_RATE)
    chain.reset()
    assert chain.gate.clear(chain.gate.stops)
    assert chain.arm()
    assert drive(10_000, RATE, 300, 10.0).state is State.ARMED
    tick = drive(10_300, true_rate, round(4.5 * true_rate), 13.0)
    assert (tick.state, tick.fault) == (State.FAULT, Fault.SHIRT_RATE)
