"""The benchmark's chair: arms as the protocol says, and what it measures is what was sent."""

import math
import socket

from app.clock import MonotonicClock
from app.hardware.chair.key import new_key
from app.hardware.chair.packet import (
    DRIVE,
    FRAME_BYTES,
    STOP,
    Command,
    decode_telemetry,
    encode_command,
    encode_hello,
)
from bench.processes.listening import ListeningChair
from bench.processes.stand_in_chair import ARMED, CHECKING, DISARMED, StandInChair

KEY = new_key(1)
PATIENCE = 20.0  # s


class Sender:
    """Tells a stand-in chair to drive, 50 times a second of a time that it makes itself."""

    def __init__(self):
        self.chair = StandInChair(KEY)
        self.t, self.sequence, self.telemetry = 100.0, 0, None
        self.hear()

    def hear(self):
        answer = self.chair.answer(self.t)
        if answer is not None:
            self.telemetry = decode_telemetry(answer, KEY)

    def send(self, epoch, flags, v=0.0, nonce=None):
        self.t += 0.02
        self.sequence += 1
        command = Command(flags, 1, epoch, self.sequence, int(self.t * 1e9), v, 0.0, 1.0, 1.0, bytes(8))
        taken = self.chair.take(encode_command(command, KEY, nonce or self.telemetry.nonce), self.t)
        self.hear()
        return taken is not None

    def arm(self, epoch):
        for _ in range(30):
            self.send(epoch, 0)


def test_it_arms_after_half_a_second_of_zeros_and_not_before():
    sender = Sender()
    assert sender.telemetry.state == DISARMED
    for _ in range(24):
        assert sender.send(7, 0)
        assert (sender.telemetry.state, sender.telemetry.epoch) == (CHECKING, 7)
    for _ in range(3):
        sender.send(7, 0)
    assert (sender.telemetry.state, sender.telemetry.epoch) == (ARMED, 7)
    assert sender.send(7, DRIVE, 0.5)


def test_motion_during_the_check_begins_it_anew_and_another_epoch_is_not_heard():
    sender = Sender()
    sender.send(7, 0)
    for _ in range(40):
        sender.send(7, DRIVE, 0.5)
    assert sender.telemetry.state == CHECKING
    assert not sender.send(8, 0)


def test_a_stop_a_withdrawal_and_a_silence_each_need_a_new_epoch_under_a_new_nonce():
    for how in ("stop", "withdrawal", "silence"):
        sender = Sender()
        sender.arm(7)
        assert sender.telemetry.state == ARMED
        sender.send(7, DRIVE, 0.5)
        nonce = sender.telemetry.nonce
        if how == "silence":
            sender.t += 0.4
            sender.hear()
        else:
            sender.send(7, STOP if how == "stop" else 0)
        assert sender.telemetry.state == DISARMED
        assert sender.telemetry.nonce != nonce
        assert not sender.send(9, 0, nonce=nonce)
        assert not sender.send(7, 0)
        assert not sender.send(8, 0, 0.5)
        sender.arm(8)
        assert sender.telemetry.state == ARMED


def test_an_old_sequence_and_what_is_no_number_do_nothing():
    sender = Sender()
    sender.arm(7)
    assert not sender.send(7, DRIVE, math.nan)
    sender.sequence -= 2
    assert not sender.send(7, DRIVE, 0.5)


def test_over_a_socket_it_answers_a_hello_and_notes_what_it_was_told():
    clock = MonotonicClock()
    with ListeningChair(KEY) as chair, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.settimeout(PATIENCE)
        sender.connect(("127.0.0.1", chair.port))
        sender.send(encode_hello(1))
        telemetry = decode_telemetry(sender.recv(FRAME_BYTES), KEY)
        before = clock.now()
        sender.send(encode_command(Command(0, 1, 7, 1, 1, 0.0, 0.0, 1.0, 1.0, bytes(8)), KEY, telemetry.nonce))
        until = before + PATIENCE
        while not chair.heard and clock.now() < until:
            clock.sleep_until(clock.now() + 0.01)
        when, command = chair.heard[0]
        assert before <= when <= clock.now()
        assert (command.epoch, command.sequence) == (7, 1)
