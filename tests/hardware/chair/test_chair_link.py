"""What the sender of a real chair sends: hellos, the neutral check, twists, stops; and what it cannot open."""

import itertools
import math
import os
import socket

import pytest
from chair_stand_in import DISARMED
from link_story import AHEAD, LIMITS, Story

from app.faults import State
from app.hardware.base import HardwareError
from app.hardware.chair.key import Key, write_key
from app.hardware.chair.link import HELLO_EVERY, LAST_FRAMES, PERIOD, ChairLink
from app.hardware.chair.packet import DRIVE, STOP
from app.hardware.configs import RealChairConfig
from app.speeds import HIGHEST_SPEEDS


def test_disarmed_it_says_hello_at_5_hz_and_nothing_else_until_it_is_heard(story):
    assert story.during(2.0, State.DISARMED) == []
    assert story.chair.hellos == pytest.approx(2.0 / HELLO_EVERY, abs=1)
    assert math.isinf(story.link.age(story.t))
    assert "does not answer" in story.link.words()
    heard = story.chair.hellos
    for _ in range(10):
        story.hear()
        assert story.during(0.1, State.DISARMED) == []
    assert story.chair.hellos == heard
    assert story.link.age(story.t) == pytest.approx(0.1)
    assert story.link.words().endswith("disarmed, battery 50%.")


@pytest.mark.parametrize("dt", [0.0005, 0.001, 0.005, 0.0037, 0.01])
def test_50_hz_whatever_the_loop_s_rate(story, dt):
    story.meet()
    times = []
    for _ in range(round(2.0 / dt)):
        times += [story.t] * len(story.turn(State.CHECKING, dt=dt))
    assert len(times) == pytest.approx(2.0 / PERIOD, abs=2)
    assert max(after - before for before, after in itertools.pairwise(times)) < PERIOD + dt + 1e-9


def test_a_held_up_loop_leaves_deadlines_out(story):
    story.meet()
    story.during(0.1, State.CHECKING)
    assert len(story.turn(State.CHECKING, dt=0.5)) == 1
    assert len(story.during(0.1, State.CHECKING)) in (5, 6)


def test_the_neutral_check_sends_zeros_and_armed_sends_the_twist(story):
    story.link.use_parameters(b"digest-1")
    story.meet()
    first = story.check()
    commands = [first, *story.during(0.2, State.CHECKING, AHEAD)]
    assert all((command.flags, command.v, command.omega) == (0, 0.0, 0.0) for command in commands)
    assert {command.epoch for command in commands} == {first.epoch}
    assert first.epoch != 0
    driven = story.during(0.2, State.ARMED, AHEAD)
    assert len(driven) == 10
    assert all((command.flags, command.v, command.omega) == (DRIVE, 0.25, -0.5) for command in driven)
    every = commands + driven
    assert all(after.sequence > before.sequence for before, after in itertools.pairwise(every))
    assert all(after.t_ns > before.t_ns for before, after in itertools.pairwise(every))
    assert {(command.v_cap, command.omega_cap, command.digest) for command in every} == {(0.5, 1.0, b"digest-1")}


def test_the_parameter_set_of_an_arming_stays_the_same(story):
    story.link.use_parameters(b"digest-1")
    story.meet()
    story.check()
    story.link.use_parameters(b"digest-2")
    assert story.during(0.1, State.ARMED)[-1].digest == b"digest-1"
    story.turn(State.DISARMED)
    assert story.check().digest == b"digest-2"


@pytest.mark.parametrize(("state", "flags"), [(State.FAULT, STOP), (State.DISARMED, 0)])
@pytest.mark.parametrize("before", [State.CHECKING, State.ARMED])
def test_an_end_is_told_at_once_ten_times_and_then_silence(story, before, state, flags):
    story.arm()
    story.turn(before, AHEAD, dt=PERIOD)  # just now there was a command: the next is not due
    commands = story.turn(state, AHEAD, dt=0.001)
    assert len(commands) == 1
    story.hear()
    commands += story.during(0.1, state, AHEAD)
    story.hear()
    commands += story.during(0.1, state, AHEAD)
    story.hear()
    assert len(commands) == LAST_FRAMES
    assert all((command.flags, command.v, command.omega) == (flags, 0.0, 0.0) for command in commands)
    assert math.isinf(story.link.due)
    assert story.during(0.1, state, AHEAD) == []


def test_a_stop_while_disarmed_is_told_too_and_clearing_it_is_not(story):
    story.arm()
    story.turn(State.DISARMED)
    story.during(0.3, State.DISARMED)
    stops = story.during(0.1, State.FAULT)
    rest = story.during(0.4, State.DISARMED)
    assert len(stops + rest) == LAST_FRAMES
    assert {command.flags for command in stops + rest} == {STOP}


def test_every_arming_has_an_epoch_of_its_own(story):
    story.meet()
    epochs = []
    for _ in range(20):
        epochs.append(story.check().epoch)
        story.turn(State.DISARMED)
    assert len(set(epochs)) == 20


def test_the_sequence_grows_when_the_chair_is_opened_again(story):
    story.meet()
    before = story.check().sequence
    story.link.close()
    story.link = ChairLink(story.chair.config)
    story.link.open()
    story.meet()
    assert story.check().sequence > before


def test_nothing_is_sent_while_the_nonce_is_unknown_and_at_once_when_it_is_known(story):
    assert story.during(0.2, State.CHECKING) == []
    assert story.chair.refused == 0
    story.hear()
    assert len(story.turn(State.CHECKING, dt=PERIOD)) == 1


def test_a_chair_that_disarms_during_the_check_gets_a_new_epoch_under_its_new_nonce(story):
    story.meet()
    first = story.check()
    story.chair.nonce = b"nonce--2"
    story.hear(DISARMED, first.epoch, first.sequence)
    again = story.during(0.1, State.CHECKING)
    assert again
    assert {command.epoch for command in again}.isdisjoint({first.epoch})


def test_nobody_there_is_no_trouble_and_costs_no_command_once_somebody_is(tmp_path):
    story = Story(tmp_path)
    try:
        address = story.chair.socket.getsockname()
        story.meet()
        story.check()
        story.chair.socket.close()
        story.t += PERIOD
        story.link.send(State.CHECKING, LIMITS, story.t)  # the kernel answers: nobody listens
        story.chair.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        story.chair.socket.bind(address)
        story.chair.socket.setblocking(False)
        story.t += 0.001
        story.link.send(State.FAULT, LIMITS, story.t)
        assert [command.flags for command in story.chair.commands()] == [STOP]
    finally:
        story.close()


def test_what_cannot_be_opened_is_one_sentence_without_the_key(tmp_path, monkeypatch):
    key = Key(3, bytes(range(32)))
    write_key(tmp_path / "good.key", key)
    write_key(tmp_path / "open.key", key)
    (tmp_path / "open.key").chmod(0o644)
    (tmp_path / "bad.key").write_text(key.line[:-1])
    (tmp_path / "bad.key").chmod(0o600)

    def unknown(host, *_args, **_keywords):
        raise socket.gaierror(socket.EAI_NONAME, "Name or service not known")

    monkeypatch.setattr(socket, "getaddrinfo", unknown)
    sentences = []
    descriptors = len(os.listdir("/proc/self/fd")) if os.path.isdir("/proc/self/fd") else 0
    for file in ("none.key", "open.key", "bad.key", "good.key"):
        document = {"kind": "udp", "name": "Salon", "host": "no-such-chair", "key_file": str(tmp_path / file)}
        link = ChairLink(RealChairConfig.model_validate({**document, "speeds": HIGHEST_SPEEDS.model_dump()}))
        with pytest.raises(HardwareError) as refused:
            link.open()
        link.close()
        sentences.append(str(refused.value))
    for words, sentence in zip(("cannot be read", "by others", "no key", "cannot be reached"), sentences, strict=True):
        assert words in sentence
    assert all(key.secret.hex()[:60] not in sentence and "\n" not in sentence for sentence in sentences)
    if descriptors:
        assert len(os.listdir("/proc/self/fd")) == descriptors
