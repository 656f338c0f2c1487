"""The chair link and its telemetry: age, silence, readiness, place, forgeries."""

import math
import socket

import pytest
from hardware.chair.chair_stand_in import ARMED, CHECKING, DISARMED, FAULT
from hardware.chair.link_and_chair import AHEAD

from app.faults import State
from app.geometry import Pose
from app.hardware.chair.key import new_key
from app.hardware.chair.link import MOST_DATAGRAMS
from app.hardware.chair.packet import encode_telemetry
from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from app.messages import Tick


def test_a_chair_that_is_paired_with_another_address_is_heard_often_enough(pair):
    oldest = 0.0
    answered = 0
    for _ in range(400):
        pair.turn(State.DISARMED)
        if pair.chair.hellos > answered:
            answered = pair.chair.hellos
            pair.hear()
        elif answered:
            oldest = max(oldest, pair.link.age(pair.t))
    assert oldest < 0.3


def test_a_chair_that_disarms_itself_while_armed_gets_none(pair):
    epoch = pair.arm()
    pair.turn(State.ARMED, AHEAD)
    pair.chair.nonce = b"nonce--2"
    pair.hear(DISARMED, epoch, 5)
    assert not pair.link.telemetry.ready
    assert pair.link.age(pair.t) < 0.3  # it is heard: it is not silent but disarmed
    assert {command.epoch for command in pair.during(0.1, State.ARMED, AHEAD)} == {epoch}


def test_commands_that_take_long_to_arrive_count_as_silence(pair):
    epoch = pair.arm()
    oldest = []
    sent = []
    for _ in range(10):  # telemetry comes in time, but tells of commands that are 0.4 s old
        sent += [(pair.t, command) for command in pair.during(0.1, State.ARMED, AHEAD)]
        known = [command.sequence for t, command in sent if t < pair.t - 0.4]
        pair.hear(ARMED, epoch, known[-1] if known else 0)
        oldest.append(pair.link.age(pair.t))
    assert max(oldest) > 0.3
    assert pair.t - pair.link.telemetry.t == 0.0


def test_commands_that_arrive_in_time_do_not(pair):
    epoch = pair.arm()
    for _ in range(10):
        sequence = pair.during(0.1, State.ARMED, AHEAD)[-1].sequence
        assert pair.link.age(pair.t) < 0.25
        pair.hear(ARMED, epoch, sequence)
        assert pair.link.age(pair.t) < 0.05


def test_a_sender_that_stood_still_does_not_let_the_chair_go_on(pair):
    """Safety S15: the chair has begun to stop by itself."""
    epoch = pair.arm()
    sequence = pair.during(0.1, State.ARMED, AHEAD)[-1].sequence
    pair.t += 0.2
    pair.hear(ARMED, epoch, sequence)
    assert pair.link.telemetry.ready
    assert not pair.link.ready
    pair.turn(State.FAULT)
    pair.check()
    last = pair.during(0.1, State.CHECKING)[-1]
    pair.hear(ARMED, last.epoch, last.sequence)
    assert pair.link.ready


def test_a_chair_with_another_document_than_when_it_was_armed_is_not_ready(pair):
    pair.turn(State.DISARMED)
    pair.hear(document=b"measured")
    assert (pair.link.document, pair.link.crawls) == (b"measured".hex(), False)
    last = pair.during(0.1, State.CHECKING)[-1]
    pair.hear(ARMED, last.epoch, last.sequence, document=b"measured")
    assert pair.link.ready
    for other in (b"another!", bytes(8)):
        pair.hear(ARMED, last.epoch, last.sequence, document=other, crawls=1)
        assert pair.link.crawls
        assert not pair.link.ready


def test_recorded_telemetry_changes_nothing(pair):
    epoch = pair.arm()
    recorded = pair.chair.say(ARMED, epoch, 4)
    pair.link.listen(pair.t)
    newest = pair.link.telemetry.newest
    pair.chair.send(recorded)
    pair.chair.send(encode_telemetry(newest, new_key(7)))  # another key
    pair.chair.send(recorded[:-1])
    pair.chair.send(recorded + b"x")
    pair.chair.send(bytes(68))
    pair.link.listen(pair.t)
    assert pair.link.telemetry.newest is newest


def test_a_recording_of_the_switch_arms_nothing_and_the_words_ask_for_it_anew(pair):
    pair.meet()
    pressed = pair.chair.say(FAULT, stop_input=1)
    pair.chair.t_ns += 3_600_000_000_000  # an hour later; nobody has seen it meanwhile
    pair.link.listen(pair.t)
    assert pair.link.switch_reported
    assert not pair.link.switch_seen
    pair.hear()
    first = pair.check()
    pair.hear(ARMED, first.epoch, first.sequence)
    assert not pair.link.ready
    assert not pair.link.switch_reported
    assert str(pair.link.description()).endswith("press and release the switch again.")
    pair.chair.send(pressed)
    pair.link.listen(pair.t)
    assert not pair.link.switch_reported
    pair.turn(State.FAULT)
    pair.hear(FAULT, first.epoch, stop_input=1)
    pair.hear(DISARMED, first.epoch)
    assert pair.link.switch_seen
    second = pair.check()
    pair.hear(ARMED, second.epoch, second.sequence)
    assert pair.link.ready


def test_others_on_the_network_are_not_heard_and_a_flood_does_not_hold_it_up(pair):
    pair.meet()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        true = pair.chair.telemetry(FAULT)
        other.sendto(true, pair.chair._sender)
        pair.link.listen(pair.t)
        assert pair.link.telemetry.newest.state == DISARMED
    for _ in range(MOST_DATAGRAMS + 10):
        pair.chair.send(b"junk")
    pair.chair.send(true)
    pair.link.listen(pair.t)
    assert pair.link.telemetry.newest.state == DISARMED
    pair.link.listen(pair.t)
    assert pair.link.telemetry.newest.state == FAULT


def test_what_the_chair_measures_counts_more_than_what_its_receiver_commands(pair):
    pair.link.place(Pose(1.0, 2.0, 0.0))
    pair.meet()
    pair.hear(v=0.5, omega=0.25, measured_v=0.25, measured_omega=0.0)
    for _ in range(10):
        state = pair.link.drive(AHEAD, 0.01)
    assert (state.x, state.y, state.v, state.omega) == (pytest.approx(1.025), 2.0, 0.25, 0.0)
    tick = Tick()
    pair.link.report(tick, pair.t)
    assert (tick.measured, tick.own_joystick) == (1, 0)
    pair.hear(v=0.5, measured_v=0.25, own_joystick=1)  # a chair that measures no turn rate
    state = pair.link.drive(AHEAD, 0.01)
    assert (state.v, state.omega) == (0.25, 0.0)
    pair.link.report(tick, pair.t)
    assert tick.own_joystick == 1
    pair.hear(v=0.5, measured_v=math.inf)
    assert pair.link.drive(AHEAD, 0.01).v == 0.5


@pytest.mark.parametrize(("measured", "stands"), [(0.0, True), (0.02, True), (-0.02, True), (0.1, False)])
def test_a_chair_that_measures_a_little_stands(pair, measured, stands):
    pair.arm()
    pair.turn(State.DISARMED)
    pair.hear(measured_v=measured, measured_omega=0.0)
    assert pair.link.stands == stands


def test_the_place_is_reckoned_from_what_the_chair_says_until_it_is_silent(pair):
    pair.link.place(Pose(1.0, 2.0, 0.0))
    pair.meet()
    pair.hear(v=0.5, omega=0.0)
    for _ in range(10):
        state = pair.link.drive(AHEAD, 0.01)
    assert (state.x, state.y, state.v) == (pytest.approx(1.05), 2.0, 0.5)
    pair.t += 0.31
    pair.link.listen(pair.t)
    state = pair.link.drive(AHEAD, 1.0)
    assert (state.x, state.v) == (pytest.approx(1.05), 0.0)
    pair.hear(v=math.nan, omega=1e30)
    assert pair.link.drive(AHEAD, 1.0).x == pytest.approx(1.05)


def test_it_stands_when_the_chair_says_so_or_after_a_while(pair):
    epoch = pair.arm()
    pair.turn(State.ARMED, AHEAD)
    assert not pair.link.stands
    pair.turn(State.DISARMED)
    pair.hear(DISARMED, epoch, 9, v=0.2)
    assert not pair.link.stands
    pair.hear(DISARMED, epoch, 9)
    assert pair.link.stands
    for _ in range(10):  # one that never says so is not waited for
        pair.t += 0.11
        pair.hear(DISARMED, epoch, 9, v=0.2)
    assert pair.link.stands


def test_its_words_tell_what_the_chair_says(pair):
    pair.meet()
    pair.hear(FAULT, stop_input=1, fault=Reason.STOP_INPUT, battery=math.nan)
    assert str(pair.link.description()).endswith(f"stop switch pressed. {DESCRIPTIONS[Reason.STOP_INPUT]}")
    pair.hear(CHECKING, fault=200)
    assert str(pair.link.description()).endswith("waits for rest, battery 50 %.")
