"""The chair link sends hellos, the neutral check, twists and stops; and errors when it is opened."""

import itertools
import math
import os
import socket

import pytest
from hardware.chair.chair_stand_in import DISARMED
from hardware.chair.link_and_chair import AHEAD, LIMITS, LinkAndChair

from app.faults import State
from app.hardware.base import HardwareError
from app.hardware.chair.key import Key, write_key
from app.hardware.chair.link import HELLO_EVERY, LAST_FRAMES, PERIOD, ChairLink
from app.hardware.chair.packet import DRIVE, STOP
from app.hardware.configs import RealChairConfig
from app.speed_limits import HIGHEST_SPEEDS


def test_disarmed_it_says_hello_at_5_hz_and_nothing_else_until_it_is_heard(pair):
    assert pair.during(2.0, State.DISARMED) == []
    assert pair.chair.hellos == pytest.approx(2.0 / HELLO_EVERY, abs=1)
    assert math.isinf(pair.link.age(pair.t))
    assert "does not answer" in str(pair.link.description())
    heard = pair.chair.hellos
    for _ in range(10):
        pair.hear()
        assert pair.during(0.1, State.DISARMED) == []
    assert pair.chair.hellos == heard
    assert pair.link.age(pair.t) == pytest.approx(0.1)
    assert str(pair.link.description()).endswith("disarmed, battery 50 %.")


@pytest.mark.parametrize("dt", [0.0005, 0.001, 0.005, 0.0037, 0.01])
def test_50_hz_whatever_the_loop_s_rate(pair, dt):
    pair.meet()
    times = []
    for _ in range(round(2.0 / dt)):
        times += [pair.t] * len(pair.turn(State.CHECKING, dt=dt))
    assert len(times) == pytest.approx(2.0 / PERIOD, abs=2)
    assert max(after - before for before, after in itertools.pairwise(times)) < PERIOD + dt + 1e-9


def test_a_held_up_loop_leaves_deadlines_out(pair):
    pair.meet()
    pair.during(0.1, State.CHECKING)
    assert len(pair.turn(State.CHECKING, dt=0.5)) == 1
    assert len(pair.during(0.1, State.CHECKING)) in (5, 6)


def test_the_neutral_check_sends_zeros_and_armed_sends_the_twist(pair):
    pair.link.use_parameters(b"digest-1")
    pair.meet()
    first = pair.check()
    commands = [first, *pair.during(0.2, State.CHECKING, AHEAD)]
    assert all((command.flags, command.v, command.omega) == (0, 0.0, 0.0) for command in commands)
    assert {command.epoch for command in commands} == {first.epoch}
    assert first.epoch != 0
    driven = pair.during(0.2, State.ARMED, AHEAD)
    assert len(driven) == 10
    assert all((command.flags, command.v, command.omega) == (DRIVE, 0.25, -0.5) for command in driven)
    every = commands + driven
    assert all(after.sequence > before.sequence for before, after in itertools.pairwise(every))
    assert all(after.t_ns > before.t_ns for before, after in itertools.pairwise(every))
    assert {(command.v_cap, command.omega_cap, command.digest) for command in every} == {(0.5, 1.0, b"digest-1")}


def test_the_parameter_set_of_an_arming_stays_the_same(pair):
    pair.link.use_parameters(b"digest-1")
    pair.meet()
    pair.check()
    pair.link.use_parameters(b"digest-2")
    assert pair.during(0.1, State.ARMED)[-1].digest == b"digest-1"
    pair.turn(State.DISARMED)
    assert pair.check().digest == b"digest-2"


@pytest.mark.parametrize(("state", "flags"), [(State.FAULT, STOP), (State.DISARMED, 0)])
@pytest.mark.parametrize("before", [State.CHECKING, State.ARMED])
def test_an_end_is_told_at_once_ten_times_and_then_silence(pair, before, state, flags):
    pair.arm()
    pair.turn(before, AHEAD, dt=PERIOD)  # just now there was a command: the next is not due
    commands = pair.turn(state, AHEAD, dt=0.001)
    assert len(commands) == 1
    pair.hear()
    commands += pair.during(0.1, state, AHEAD)
    pair.hear()
    commands += pair.during(0.1, state, AHEAD)
    pair.hear()
    assert len(commands) == LAST_FRAMES
    assert all((command.flags, command.v, command.omega) == (flags, 0.0, 0.0) for command in commands)
    assert math.isinf(pair.link.due)
    assert pair.during(0.1, state, AHEAD) == []


def test_a_stop_while_disarmed_is_told_too_and_clearing_it_is_not(pair):
    pair.arm()
    pair.turn(State.DISARMED)
    pair.during(0.3, State.DISARMED)
    stops = pair.during(0.1, State.FAULT)
    rest = pair.during(0.4, State.DISARMED)
    assert len(stops + rest) == LAST_FRAMES
    assert {command.flags for command in stops + rest} == {STOP}


def test_every_arming_has_an_epoch_of_its_own(pair):
    pair.meet()
    epochs = []
    for _ in range(20):
        epochs.append(pair.check().epoch)
        pair.turn(State.DISARMED)
    assert len(set(epochs)) == 20


def test_the_sequence_grows_when_the_chair_is_opened_again(pair):
    pair.meet()
    before = pair.check().sequence
    pair.link.close()
    pair.link = ChairLink(pair.chair.config)
    pair.link.open()
    pair.meet()
    assert pair.check().sequence > before


def test_nothing_is_sent_while_the_nonce_is_unknown_and_at_once_when_it_is_known(pair):
    assert pair.during(0.2, State.CHECKING) == []
    assert pair.chair.refused == 0
    pair.hear()
    assert len(pair.turn(State.CHECKING, dt=PERIOD)) == 1


def test_a_chair_that_disarms_during_the_check_gets_a_new_epoch_under_its_new_nonce(pair):
    pair.meet()
    first = pair.check()
    pair.chair.nonce = b"nonce--2"
    pair.hear(DISARMED, first.epoch, first.sequence)
    again = pair.during(0.1, State.CHECKING)
    assert again
    assert {command.epoch for command in again}.isdisjoint({first.epoch})


def test_nobody_there_is_no_trouble_and_costs_no_command_once_somebody_is(tmp_path):
    pair = LinkAndChair(tmp_path)
    try:
        address = pair.chair.socket.getsockname()
        pair.meet()
        pair.check()
        pair.chair.socket.close()
        pair.t += PERIOD
        pair.link.send(State.CHECKING, LIMITS, pair.t)  # the kernel answers: nobody listens
        pair.chair.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        pair.chair.socket.bind(address)
        pair.chair.socket.setblocking(False)
        pair.t += 0.001
        pair.link.send(State.FAULT, LIMITS, pair.t)
        assert [command.flags for command in pair.chair.commands()] == [STOP]
    finally:
        pair.close()


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
