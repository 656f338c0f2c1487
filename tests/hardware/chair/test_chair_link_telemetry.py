"""What the sender of a real chair makes of telemetry: age, silence, readiness, place, forgeries."""

import math
import socket

import pytest
from chair_stand_in import ARMED, CHECKING, DISARMED, FAULT
from link_story import AHEAD

from app.faults import State
from app.geometry import Pose
from app.hardware.chair.key import new_key
from app.hardware.chair.link import MOST_DATAGRAMS
from app.hardware.chair.packet import encode_telemetry
from app.hardware.chair.reasons import WORDS, Reason


def test_a_chair_that_is_paired_with_another_address_is_heard_often_enough(story):
    oldest = 0.0
    answered = 0
    for _ in range(400):
        story.turn(State.DISARMED)
        if story.chair.hellos > answered:
            answered = story.chair.hellos
            story.hear()
        elif answered:
            oldest = max(oldest, story.link.age(story.t))
    assert oldest < 0.3


def test_a_chair_that_disarms_itself_while_armed_gets_none(story):
    epoch = story.arm()
    story.turn(State.ARMED, AHEAD)
    story.chair.nonce = b"nonce--2"
    story.hear(DISARMED, epoch, 5)
    assert not story.link.telemetry.ready
    assert story.link.age(story.t) < 0.3  # it is heard: it is not silent but disarmed
    assert {command.epoch for command in story.during(0.1, State.ARMED, AHEAD)} == {epoch}


def test_commands_that_take_long_to_arrive_count_as_silence(story):
    epoch = story.arm()
    oldest = []
    sent = []
    for _ in range(10):  # telemetry comes in time, but tells of commands that are 0.4 s old
        sent += [(story.t, command) for command in story.during(0.1, State.ARMED, AHEAD)]
        known = [command.sequence for t, command in sent if t < story.t - 0.4]
        story.hear(ARMED, epoch, known[-1] if known else 0)
        oldest.append(story.link.age(story.t))
    assert max(oldest) > 0.3
    assert story.t - story.link.telemetry.t == 0.0


def test_commands_that_arrive_in_time_do_not(story):
    epoch = story.arm()
    for _ in range(10):
        sequence = story.during(0.1, State.ARMED, AHEAD)[-1].sequence
        assert story.link.age(story.t) < 0.25
        story.hear(ARMED, epoch, sequence)
        assert story.link.age(story.t) < 0.05


def test_a_sender_that_stood_still_does_not_let_the_chair_go_on(story):
    """Safety S15: the chair has begun to stop by itself."""
    epoch = story.arm()
    sequence = story.during(0.1, State.ARMED, AHEAD)[-1].sequence
    story.t += 0.2
    story.hear(ARMED, epoch, sequence)
    assert story.link.telemetry.ready
    assert not story.link.ready
    story.turn(State.FAULT)
    story.check()
    last = story.during(0.1, State.CHECKING)[-1]
    story.hear(ARMED, last.epoch, last.sequence)
    assert story.link.ready


def test_recorded_telemetry_changes_nothing(story):
    epoch = story.arm()
    recorded = story.chair.say(ARMED, epoch, 4)
    story.link.listen(story.t)
    newest = story.link.telemetry.newest
    story.chair.send(recorded)
    story.chair.send(encode_telemetry(newest, new_key(7)))  # another key
    story.chair.send(recorded[:-1])
    story.chair.send(recorded + b"x")
    story.chair.send(bytes(68))
    story.link.listen(story.t)
    assert story.link.telemetry.newest is newest


def test_others_on_the_network_are_not_heard_and_a_flood_does_not_hold_it_up(story):
    story.meet()
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        true = story.chair.telemetry(FAULT)
        other.sendto(true, story.chair._sender)
        story.link.listen(story.t)
        assert story.link.telemetry.newest.state == DISARMED
    for _ in range(MOST_DATAGRAMS + 10):
        story.chair.send(b"junk")
    story.chair.send(true)
    story.link.listen(story.t)
    assert story.link.telemetry.newest.state == DISARMED
    story.link.listen(story.t)
    assert story.link.telemetry.newest.state == FAULT


def test_the_place_is_reckoned_from_what_the_chair_says_until_it_is_silent(story):
    story.link.place(Pose(1.0, 2.0, 0.0))
    story.meet()
    story.hear(v=0.5, omega=0.0)
    for _ in range(10):
        state = story.link.drive(AHEAD, 0.01)
    assert (state.x, state.y, state.v) == (pytest.approx(1.05), 2.0, 0.5)
    story.t += 0.31
    story.link.listen(story.t)
    state = story.link.drive(AHEAD, 1.0)
    assert (state.x, state.v) == (pytest.approx(1.05), 0.0)
    story.hear(v=math.nan, omega=1e30)
    assert story.link.drive(AHEAD, 1.0).x == pytest.approx(1.05)


def test_it_stands_when_the_chair_says_so_or_after_a_while(story):
    epoch = story.arm()
    story.turn(State.ARMED, AHEAD)
    assert not story.link.stands
    story.turn(State.DISARMED)
    story.hear(DISARMED, epoch, 9, v=0.2)
    assert not story.link.stands
    story.hear(DISARMED, epoch, 9)
    assert story.link.stands
    for _ in range(10):  # one that never says so is not waited for
        story.t += 0.11
        story.hear(DISARMED, epoch, 9, v=0.2)
    assert story.link.stands


def test_its_words_tell_what_the_chair_says(story):
    story.meet()
    story.hear(FAULT, stop_input=1, fault=Reason.STOP_INPUT, battery=math.nan)
    assert story.link.words().endswith(f"stop switch pressed. {WORDS[Reason.STOP_INPUT]}")
    story.hear(CHECKING, fault=200)
    assert story.link.words().endswith("checking that it is told to stand, battery 50%.")
