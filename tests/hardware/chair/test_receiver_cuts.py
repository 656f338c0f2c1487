"""S3 at a thousand random moments, and an hour of drifting clocks: a chair link that is cut or late."""

import math
import random
from itertools import pairwise

import pytest
from hardware.chair.commanded_receiver import PERIOD, STEP, CommandedReceiver

from app.hardware.chair.packet import DRIVE
from app.hardware.chair.reasons import Reason
from app.hardware.chair.receiver import ReceiverState
from app.pipeline import stop_ramp

CUTS = 1000
SLACK = 1e-9  # s, rounding of times


@pytest.fixture(scope="module")
def cut():
    """Return for each cut the times from the last command to slowing, standstill and disarming, and the speeds."""
    rng = random.Random(3)
    chair, found = CommandedReceiver(), []
    for _ in range(CUTS):
        v, omega = rng.choice((-1, 1)) * rng.uniform(0.05, 1.5), rng.uniform(-2.5, 2.5)
        chair.drive(v, omega, seconds=0.54)
        heard = chair.t + rng.uniform(0.0, STEP)
        assert chair.receiver.accept(chair.frame(v, omega, DRIVE), heard)
        before = chair.receiver.driven
        chair.speeds.clear()
        states = []
        while len(states) < 70:
            chair.step(rng.uniform(0.005, STEP))  # commands may step it more often, never less
            states.append(chair.state)
        times = [t - heard for t, _, _ in chair.speeds]
        moved = [(abs(v), abs(omega)) for _, v, omega in chair.speeds]
        slowed = next(t for t, (v, _) in zip(times, moved, strict=True) if v < abs(before.v))
        stood = next(t for t, speeds in zip(times, moved, strict=True) if speeds == (0.0, 0.0))
        disarmed = next(t for t, state in zip(times, states, strict=True) if state is ReceiverState.DISARMED)
        found.append((slowed, stood, disarmed, before, moved))
    return found


def test_the_way_to_standstill_begins_no_later_than_110_ms_after_the_last_command(cut):
    slowed = [moment for moment, *_ in cut]
    assert min(slowed) >= 0.1 - SLACK
    assert max(slowed) <= 0.11 + SLACK
    assert max(slowed) - min(slowed) > 0.8 * STEP, "the cuts came at every phase of a step"


def test_the_chair_is_disarmed_no_later_than_310_ms_after_the_last_command(cut):
    disarmed = [moment for _, _, moment, _, _ in cut]
    assert min(disarmed) >= 0.3 - SLACK
    assert max(disarmed) <= 0.31 + SLACK


def test_from_then_on_it_only_slows_and_stands_in_time(cut):
    for _, stood, _, before, moved in cut:
        speeds = [(abs(before.v), abs(before.omega)), *moved]
        for (v, omega), (next_v, next_omega) in pairwise(speeds):
            assert next_v <= v
            assert next_omega <= omega
        assert stood <= 0.11 + stop_ramp.STOP_TIME + STEP + SLACK


@pytest.mark.parametrize("drift", [-0.01, 0.01])
def test_an_hour_of_clocks_that_differ_by_a_hundredth(chair, drift):
    chair.arm()
    period = 0.09  # s: the rarest commands that do not count as silence
    for _ in range(int(3600 / period)):
        chair.sender_ahead += drift * period
        assert chair.send(0.4, 0.0, DRIVE)
        chair.step(period)
    assert chair.receiver.driven.v == pytest.approx(0.4)
    assert chair.state is ReceiverState.ARMED


def test_what_is_not_taken_for_late_leaves_no_trace():
    chair = CommandedReceiver().drive()
    late = chair.frame(0.9, 0.0, DRIVE, t_ns=int((chair.t + chair.sender_ahead - 0.15) * 1e9))
    before = repr(vars(chair.receiver))
    assert not chair.receiver.accept(late, chair.t)
    assert repr(vars(chair.receiver)) == before
    assert chair.send(0.5, 0.0, DRIVE)


def test_commands_that_wander_by_less_than_a_tenth_of_a_second_are_driven(chair):
    rng = random.Random(5)
    chair.arm()
    for _ in range(500):
        on_the_way = rng.uniform(0.0, 0.08)
        assert chair.send(0.4, 0.0, DRIVE, t_ns=int((chair.t + chair.sender_ahead - on_the_way) * 1e9))
        chair.wait(PERIOD)


def test_two_seconds_of_commands_that_a_network_kept_back_move_nothing():
    chair = CommandedReceiver().drive(0.5)
    kept = []
    for _ in range(100):
        kept.append(chair.frame(0.5, 0.0, DRIVE))
        chair.wait(PERIOD)
    assert (chair.state, chair.reason) == (ReceiverState.DISARMED, Reason.SILENT)
    assert not any(chair.receiver.accept(frame, chair.t) for frame in kept)


@pytest.mark.parametrize("pause", [0.12, 0.2, 0.28])
def test_commands_that_were_kept_back_for_less_do_not_drive_either_until_they_are_fresh(pause):
    chair = CommandedReceiver().drive(0.5)
    kept = []
    for _ in range(round(pause / PERIOD)):
        kept.append((chair.t, chair.frame(0.5, 0.0, DRIVE)))
        chair.wait(PERIOD)
    for sent, frame in kept:
        late = chair.t - sent
        taken = chair.receiver.accept(frame, chair.t)
        assert late <= 0.1 + 0.1 * pause + SLACK if taken else late > 0.1 - SLACK
    assert taken


@pytest.mark.parametrize("begin", random.Random(5).sample(range(1, 1_000_000), 40))
def test_a_loop_that_looks_when_it_is_due_acts_at_once(chair, begin):
    chair.t = begin / 7
    assert chair.receiver.next_look(chair.t) == math.inf, "nobody drives"
    chair.step(0.0)
    chair.drive(0.5, seconds=0.4)
    heard = chair.t - PERIOD
    seen = []
    for limit in (0.1, 0.3):
        look = chair.receiver.next_look(chair.t)
        assert look == pytest.approx(heard + limit, abs=1e-5)
        while chair.t + 1.5 * STEP < look:
            chair.step()
        seen += [(chair.receiver.driven.v, chair.reason)]
        chair.step(look - chair.t)
        seen += [(chair.receiver.driven.v, chair.reason)]
    assert seen[0] == (pytest.approx(0.5), Reason.NONE)
    assert seen[1][0] < 0.5
    assert [reason for _, reason in seen[1:]] == [Reason.NONE, Reason.NONE, Reason.SILENT]
