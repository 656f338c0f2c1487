"""The ramps and limits of the receiver on the chair: silence, stops, caps."""

import pytest
from hardware.chair.commanded_receiver import PERIOD, STEP, CommandedReceiver
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.chair import receiver as receiver_module
from app.hardware.chair.packet import DRIVE, STOP
from app.hardware.chair.reasons import Reason
from app.hardware.chair.receiver import ReceiverState
from app.pipeline import safety_gate, stop_ramp

ARMED, DISARMED = ReceiverState.ARMED, ReceiverState.DISARMED
STANDS = (0.0, 0.0)


def test_silence_slows_the_chair_after_100_ms_and_disarms_it_after_300(chair):
    chair.drive(0.75, 1.0)
    heard = chair.t - PERIOD
    chair.wait(0.5)
    slowed = next(t for t, v, _ in chair.speeds if t > heard and v < 0.75)
    assert 0.1 <= slowed - heard <= 0.11 + 1e-9
    stood = next(t for t, v, omega in chair.speeds if t > heard and (v, omega) == STANDS)
    assert stood - heard <= 0.11 + stop_ramp.STOP_TIME + STEP
    assert chair.reason is Reason.SILENT


def test_a_command_after_a_short_silence_drives_on(chair):
    chair.drive(1.5, seconds=1.0)
    chair.wait(0.2)
    slowest = chair.receiver.driven.v
    assert slowest < 1.0
    assert chair.state is ARMED
    chair.command(0.1, 1.5, 0.0, DRIVE)
    assert chair.receiver.driven.v == pytest.approx(slowest + 3.0 * 0.1), "as gently as ever, not as it slowed"
    chair.command(0.4, 1.5, 0.0, DRIVE)
    assert chair.receiver.driven.v == pytest.approx(1.5)


def test_a_stall_of_its_own_is_a_hundred_ms(chair):
    chair.drive()
    for pause, state in ((0.099, ARMED), (0.101, DISARMED)):
        chair.t += pause
        chair.send(0.5, 0.0, DRIVE)
        chair.step(0.0)
        assert chair.state is state


def test_the_stop_is_that_of_the_gate():
    for name in ("STOP_DECELERATION", "STOP_TURN_DECELERATION", "STOP_TIME"):
        assert getattr(receiver_module, name) == getattr(stop_ramp, name), name
    for name in ("NEUTRAL_TIME", "NEUTRAL_PATIENCE"):
        assert getattr(receiver_module, name) == getattr(safety_gate, name), name


def test_the_stopping_distance():
    """S18, counted from the last command sent."""
    for v in (sign * n / 20 for sign in (-1, 1) for n in range(1, 31)):
        chair = CommandedReceiver().drive(v, 0.0, 1.0)
        heard = chair.t - PERIOD
        chair.wait(0.5)
        distance = sum(abs(speed) * STEP for t, speed, _ in chair.speeds if t >= heard)
        detected = 0.11
        assert distance <= 1.05 * (abs(v) * detected + v * v / (2 * stop_ramp.STOP_DECELERATION)), v
        assert distance >= abs(v) * 0.1, v
        assert chair.receiver.driven == STANDS, v


@pytest.mark.parametrize("speeds", [(1.5, 2.5), (-1.5, -2.5), (0.2, 0.1), (1.5, 0.0), (0.0, -2.5)])
def test_any_stop_takes_at_most_a_quarter_of_a_second(chair, speeds):
    chair.drive(*speeds, seconds=1.2)
    assert chair.receiver.driven == pytest.approx(speeds)
    chair.send(0.0, 0.0, STOP)
    chair.wait(stop_ramp.STOP_TIME)
    assert chair.receiver.driven == pytest.approx(STANDS, abs=1e-9)


@pytest.mark.parametrize(
    ("own", "promised", "wanted", "driven"),
    [
        ((1.5, 2.5), (1.5, 2.5), (9.0, -9.0), (1.5, -2.5)),
        ((0.4, 0.3), (1.5, 2.5), (-1.0, 1.0), (-0.4, 0.3)),
        ((1.5, 2.5), (0.4, 0.3), (1.0, -1.0), (0.4, -0.3)),
        ((1.5, 2.5), (0.0, 0.0), (1.0, -1.0), (0.0, 0.0)),
        ((1.5, 2.5), (3e38, 3e38), (3e38, -3e38), (1.5, -2.5)),
    ],
)
def test_the_smaller_cap_holds(own, promised, wanted, driven):
    chair = CommandedReceiver(v_max=own[0], omega_max=own[1])
    chair.arm()
    chair.command(1.0, *wanted, DRIVE, v_cap=promised[0], omega_cap=promised[1])
    assert chair.receiver.driven == pytest.approx(driven)
    assert chair.state is ARMED


@given(st.lists(st.tuples(st.floats(width=32), st.floats(width=32), st.integers(0, 5)), min_size=1, max_size=40))
def test_no_commands_whatever_get_past_caps_and_ramps(commands):
    chair = CommandedReceiver(v_max=0.8, omega_max=1.2)
    chair.arm()
    for v, omega, pause in commands:
        chair.send(v, omega, DRIVE)
        chair.wait(pause * STEP)
    chair.send(0.0, 0.0, STOP)
    chair.wait(0.3)
    last_v = last_omega = 0.0
    for _, v, omega in chair.speeds:
        assert abs(v) <= 0.8
        assert abs(omega) <= 1.2
        assert abs(v - last_v) <= max(3.0, 0.8 / 0.25) * STEP + 1e-9
        assert abs(omega - last_omega) <= 20.0 * STEP + 1e-9
        last_v, last_omega = v, omega
    assert (last_v, last_omega) == STANDS


def test_ramps_are_no_stop(chair):
    chair.arm()
    chair.command(0.1, 1.0, 2.0, DRIVE)
    assert chair.receiver.driven == pytest.approx((0.3, 2.0))
    chair.command(0.08, 0.0, 0.0, DRIVE)
    assert chair.receiver.driven == pytest.approx((0.06, 0.4))
