"""Telemetry: who gets it, which is accepted, and that a recording of an earlier one rolls nothing back."""

import math
import os

import pytest
from hardware.chair.commanded_receiver import KEY, STEP, CommandedReceiver
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.chair.inputs import Inputs
from app.hardware.chair.packet import DRIVE, STOP, Telemetry, decode_telemetry, encode_hello
from app.hardware.chair.telemetry import ARMED, FAULT, MOST_NONCES, SILENT, ChairTelemetry
from app.hardware.chair.telemetry_sender import PERIOD, TelemetrySender

DRIVER, PAIRED, ASKING, STRANGER = (("somebody", number) for number in range(4))


class Chair:
    """A receiver with a telemetry sender, and a log of each telemetry with its address."""

    def __init__(self, paired=None, inputs=None):
        self.commanded = CommandedReceiver()
        self.sender = TelemetrySender(self.commanded.receiver, KEY.id, self, paired)
        self.inputs = inputs or Inputs(None, None)
        self.sent = []
        self.full = False

    def sendto(self, datagram, address):
        if self.full:
            raise BlockingIOError
        self.sent.append((self.commanded.t, address, decode_telemetry(datagram, KEY)))

    def wait(self, seconds):
        for _ in range(round(seconds / STEP)):
            self.commanded.step()
            self.sender.send(self.commanded.t, self.inputs, False)

    def take_hello(self, address, key_id=KEY.id):
        self.sender.answer_hello(encode_hello(key_id), address, self.commanded.t)

    def drive(self):
        for words in [(0.0, 0.0)] * 30 + [(0.5, 0.0, DRIVE)] * 10:
            assert self.commanded.send(*words)
            self.sender.set_driver(DRIVER)
            self.wait(0.02)

    def receivers(self, since=0.0):
        return {address for t, address, _ in self.sent if t >= since}


@pytest.mark.parametrize(
    "datagram", [None, b"", b"BMIH", encode_hello(KEY.id) + b"\0", encode_hello(KEY.id)[:-1] + b"\1"]
)
def test_nobody_gets_telemetry_when_nobody_is_known_and_what_is_no_hello_is_not_answered(datagram):
    chair = Chair()
    if datagram is not None:
        chair.sender.answer_hello(datagram, STRANGER, chair.commanded.t)
    chair.wait(1.0)
    assert chair.sent == []


def test_the_paired_address_gets_telemetry_ten_times_a_second_at_rest():
    chair = Chair(PAIRED)
    chair.wait(2.0)
    assert chair.receivers() == {PAIRED}
    assert len(chair.sent) == pytest.approx(2.0 / PERIOD, abs=1)


def test_who_drives_gets_telemetry_alone_and_at_each_change_of_state():
    chair = Chair(PAIRED)
    chair.wait(0.1)
    began = chair.commanded.t
    chair.drive()
    assert chair.receivers(began + STEP / 2) == {DRIVER}
    chair.sent.clear()
    chair.commanded.send(flags=STOP)
    chair.wait(STEP)
    assert [telemetry.state for _, _, telemetry in chair.sent] == [0, 0]
    assert chair.receivers() == {DRIVER, PAIRED}


def test_a_hello_is_answered_at_once_and_who_said_it_last_gets_telemetry_at_rest():
    chair = Chair()
    chair.take_hello(STRANGER, KEY.id + 1)
    chair.wait(0.3)
    assert chair.sent == []
    chair.take_hello(STRANGER)
    chair.wait(STEP)
    assert chair.receivers() == {STRANGER}
    chair.wait(0.1)
    chair.take_hello(ASKING)
    chair.wait(0.5)
    assert chair.receivers(chair.commanded.t - 0.4) == {ASKING}


def test_a_hello_while_somebody_drives_is_answered_once():
    chair = Chair()
    chair.drive()
    chair.take_hello(STRANGER)
    chair.wait(0.08)
    assert [address for _, address, _ in chair.sent].count(STRANGER) == 1


def test_a_thousand_hellos_a_second_are_answered_fifty_times():
    chair = Chair(PAIRED)
    for number in range(2000):
        chair.sender.answer_hello(encode_hello(KEY.id), ("somebody", 100 + number), chair.commanded.t)
        if number % 10 == 9:
            chair.wait(STEP)
    assert sum(address != PAIRED for _, address, _ in chair.sent) <= 101


def test_a_network_without_room_is_no_matter():
    chair = Chair(PAIRED)
    chair.full = True
    chair.wait(0.5)
    chair.full = False
    chair.wait(0.2)
    assert chair.sent


@pytest.mark.parametrize(("content", "pressed"), [("0", False), ("0\n", False), ("1", True), ("", True), (" 0", True)])
def test_the_switch_is_a_file_that_begins_with_0_when_it_is_not_pressed(tmp_path, content, pressed):
    file = tmp_path / "switch"
    assert Inputs(file, None).stop_pressed
    file.write_text(content)
    assert Inputs(file, None).stop_pressed == pressed
    assert not Inputs(None, None).stop_pressed


def test_a_pipe_and_a_folder_are_no_switches_and_hold_nobody_up(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for file in (tmp_path / "pipe", tmp_path):
        assert Inputs(file, None).stop_pressed
        assert math.isnan(Inputs(None, file).battery)


@pytest.mark.parametrize(
    ("content", "charge"), [("0.25\n", 0.25), ("1", 1.0), ("1.01", None), ("nan", None), ("", None)]
)
def test_the_battery_is_a_number_from_0_to_1_or_unknown(tmp_path, content, charge):
    file = tmp_path / "battery"
    file.write_text(content)
    told = Inputs(None, file).battery
    assert math.isnan(told) if charge is None else told == charge
    assert math.isnan(Inputs(None, None).battery)
    assert math.isnan(Inputs(None, tmp_path / "none").battery)


EPOCH = 77
A, B = b"nonce--A", b"nonce--B"


def reported(t_ns, nonce=A, state=0, epoch=0, stop_input=0):
    return Telemetry(state, 7, epoch, 0, t_ns, nonce, 0.0, 0.0, 0.5, stop_input, 0)


@pytest.fixture
def telemetry():
    made = ChairTelemetry()
    assert made.accept(reported(1000), 1.0)
    return made


def test_the_chair_s_time_must_grow(telemetry):
    assert not telemetry.accept(reported(1000), 1.01)
    assert not telemetry.accept(reported(999), 1.01)
    assert telemetry.accept(reported(1001), 1.02)
    assert (telemetry.newest.t_ns, telemetry.t) == (1001, 1.02)


def test_another_nonce_is_believed_when_the_chair_was_silent_or_tells_our_epoch(telemetry):
    assert not telemetry.accept(reported(2000, B), 0.99 + SILENT)
    telemetry.begin_epoch(EPOCH)
    assert not telemetry.accept(reported(2000, B, epoch=EPOCH + 1), 1.1)
    assert telemetry.accept(reported(2000, B, epoch=EPOCH), 1.1)
    assert telemetry.accept(reported(1, b"nonce--C"), 1.1 + SILENT + 0.01)


def test_a_restarted_chair_is_believed_after_its_silence(telemetry):
    again = reported(5, B)  # its clock began anew, too
    assert not telemetry.accept(again, 1.2)
    assert telemetry.accept(again, 1.4)
    assert telemetry.newest.nonce == B


def test_a_recording_of_this_arming_rolls_nothing_back(telemetry):
    telemetry.begin_epoch(EPOCH)
    assert telemetry.accept(reported(2000, A, ARMED, EPOCH), 1.1)
    assert telemetry.accept(reported(3000, B, 0, EPOCH), 1.2)  # it disarmed: a new nonce
    assert not telemetry.accept(reported(2000, A, ARMED, EPOCH), 1.25)
    assert not telemetry.accept(reported(2500, A, ARMED, EPOCH), 1.25)  # also when somebody kept it from us until now
    assert not telemetry.accept(reported(2500, A, ARMED, EPOCH), 2.0)
    assert not telemetry.ready


def test_an_earlier_nonce_needs_silence_and_a_later_time(telemetry):
    assert telemetry.accept(reported(5, B), 2.0)
    assert not telemetry.accept(reported(1000), 3.0)
    assert not telemetry.accept(reported(1001), 2.1)
    assert telemetry.accept(reported(1001), 3.0)


def test_ready_is_only_who_tells_this_arming_s_epoch(telemetry):
    assert telemetry.accept(reported(2000, A, ARMED, 0), 1.1)
    assert not telemetry.ready
    telemetry.begin_epoch(EPOCH)
    assert not telemetry.ready
    assert not telemetry.answers
    assert telemetry.accept(reported(2001, A, ARMED, EPOCH), 1.1)
    assert telemetry.ready
    telemetry.begin_epoch(EPOCH + 1)
    assert not telemetry.ready


def test_a_pressed_switch_or_a_fault_inhibits(telemetry):
    telemetry.begin_epoch(EPOCH)
    assert not telemetry.inhibited
    assert telemetry.accept(reported(2000, A, FAULT, EPOCH), 1.1)
    assert (telemetry.inhibited, telemetry.ready, telemetry.switch_seen) == (True, False, False)
    assert telemetry.accept(reported(2001, A, ARMED, EPOCH, stop_input=1), 1.1)
    assert (telemetry.inhibited, telemetry.ready, telemetry.switch_seen) == (True, False, True)
    assert telemetry.accept(reported(2002, A, ARMED, EPOCH), 1.1)
    assert (telemetry.inhibited, telemetry.ready, telemetry.switch_seen) == (False, True, True)


def confirmed(pressed, came, first, t):
    """Return whether a pressed switch counts after the first telemetry of our epoch."""
    telemetry = ChairTelemetry()
    assert telemetry.accept(pressed, came)
    assert (telemetry.switch_seen, telemetry.switch_reported) == (False, True)
    telemetry.begin_epoch(EPOCH)
    assert telemetry.accept(first, t)
    assert telemetry.switch_reported == telemetry.switch_seen != telemetry.switch_refuted
    assert telemetry.ready == telemetry.switch_seen
    return telemetry.switch_seen


S = 1_000_000_000  # ns in a second


def test_a_switch_seen_before_the_arming_counts_when_it_was_pressed_then():
    """One telemetry that somebody had recorded showed a switch, and acceleration mode armed."""
    pressed = reported(1000 * S, stop_input=1)
    assert confirmed(pressed, 10.0, reported(1600 * S, A, ARMED, EPOCH), 610.0)
    assert confirmed(pressed, 10.0, reported(1600 * S, A, ARMED, EPOCH), 609.8)
    assert not confirmed(pressed, 10.0, reported(1002 * S, A, ARMED, EPOCH), 10.5)
    assert not confirmed(pressed, 10.0, reported(1600 * S, B, ARMED, EPOCH), 610.0)


def test_a_switch_that_was_a_recording_keeps_the_chair_from_being_ready_in_all_of_this_arming():
    telemetry = ChairTelemetry()
    assert telemetry.accept(reported(5 * S, stop_input=1), 1.0)
    for number, nonce in enumerate((A, B, b"nonce--C")):
        telemetry.begin_epoch(EPOCH + number)
        assert telemetry.accept(reported((50 + number) * S, nonce, ARMED, EPOCH + number), 1.1 + number)
        assert not telemetry.ready
    assert telemetry.accept(reported(60 * S, b"nonce--C", FAULT, EPOCH + 2, stop_input=1), 5.0)
    assert telemetry.switch_seen


def test_it_remembers_many_nonces_and_not_endlessly_many():
    telemetry = ChairTelemetry()
    for i in range(2 * MOST_NONCES):
        assert telemetry.accept(reported(10, i.to_bytes(8, "little")), i * 1.0)
    assert not telemetry.accept(reported(10, (2 * MOST_NONCES - 500).to_bytes(8, "little")), 1e6)
    assert len(telemetry._nonces) == MOST_NONCES


telemetries = st.builds(
    reported, st.integers(0, 50), st.sampled_from([A, B]), st.integers(0, 3), st.sampled_from([0, EPOCH]), st.just(0)
)


@given(st.lists(st.tuples(telemetries, st.floats(0, 0.5)), max_size=40), st.booleans())
def test_nothing_is_taken_twice_whatever_comes(sequence, with_epoch):
    kept, t, taken = ChairTelemetry(), 0.0, []
    if with_epoch:
        kept.begin_epoch(EPOCH)
    for telemetry, pause in sequence:
        t += pause
        if kept.accept(telemetry, t):
            assert all(telemetry.t_ns > other.t_ns for other in taken if other.nonce == telemetry.nonce)
            if with_epoch and telemetry.epoch == EPOCH:
                assert all(telemetry.t_ns > other.t_ns for other in taken if other.epoch == EPOCH)
            taken.append(telemetry)
            assert kept.newest is telemetry
