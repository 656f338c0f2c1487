"""Who gets telemetry: the driver, the paired address, the sender of a hello; and hellos cannot flood anybody."""

import math
import os

import pytest
from hardware.chair.commanded_receiver import KEY, STEP, CommandedReceiver

from app.hardware.chair.inputs import Inputs
from app.hardware.chair.packet import DRIVE, STOP, decode_telemetry, encode_hello
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


def test_nobody_gets_telemetry_when_nobody_is_known():
    chair = Chair()
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


@pytest.mark.parametrize("datagram", [b"", b"BMIH", encode_hello(KEY.id) + b"\0", encode_hello(KEY.id)[:-1] + b"\1"])
def test_what_is_no_hello_is_not_answered(datagram):
    chair = Chair()
    chair.sender.answer_hello(datagram, STRANGER, chair.commanded.t)
    chair.wait(0.3)
    assert chair.sent == []


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
