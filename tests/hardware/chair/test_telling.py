"""Who is told how the chair is: who drives it, who is paired with it, who asks; and asking cannot flood anybody."""

import math
import os

import pytest
from hardware.chair.commanded import KEY, STEP, Commanded

from app.hardware.chair.inputs import Inputs
from app.hardware.chair.packet import DRIVE, STOP, decode_telemetry, encode_hello
from app.hardware.chair.telling import EVERY, Telling

DRIVER, PAIRED, ASKING, STRANGER = (("somebody", number) for number in range(4))


class Told:
    """A receiver that tells, and what it told to whom."""

    def __init__(self, paired=None, inputs=None):
        self.chair = Commanded()
        self.telling = Telling(self.chair.receiver, KEY.id, self, paired)
        self.inputs = inputs or Inputs(None, None)
        self.sent = []
        self.full = False

    def sendto(self, datagram, address):
        if self.full:
            raise BlockingIOError
        self.sent.append((self.chair.t, address, decode_telemetry(datagram, KEY)))

    def wait(self, seconds):
        for _ in range(round(seconds / STEP)):
            self.chair.step()
            self.telling.tell(self.chair.t, self.inputs, False)

    def hear_hello(self, address, key_id=KEY.id):
        self.telling.greet(encode_hello(key_id), address, self.chair.t)

    def drive(self):
        for words in [(0.0, 0.0)] * 30 + [(0.5, 0.0, DRIVE)] * 10:
            assert self.chair.send(*words)
            self.telling.commanded_by(DRIVER)
            self.wait(0.02)

    def told(self, since=0.0):
        return {address for t, address, _ in self.sent if t >= since}


def test_nobody_is_told_when_nobody_is_known():
    telling = Told()
    telling.wait(1.0)
    assert telling.sent == []


def test_the_paired_address_is_told_ten_times_a_second_at_rest():
    telling = Told(PAIRED)
    telling.wait(2.0)
    assert telling.told() == {PAIRED}
    assert len(telling.sent) == pytest.approx(2.0 / EVERY, abs=1)


def test_who_drives_is_told_alone_and_at_each_change_of_state():
    telling = Told(PAIRED)
    telling.wait(0.1)
    began = telling.chair.t
    telling.drive()
    assert telling.told(began + STEP / 2) == {DRIVER}
    telling.sent.clear()
    telling.chair.send(flags=STOP)
    telling.wait(STEP)
    assert [telemetry.state for _, _, telemetry in telling.sent] == [0, 0]
    assert telling.told() == {DRIVER, PAIRED}


def test_a_hello_is_answered_at_once_and_who_said_it_last_is_told_at_rest():
    telling = Told()
    telling.hear_hello(STRANGER, KEY.id + 1)
    telling.wait(0.3)
    assert telling.sent == []
    telling.hear_hello(STRANGER)
    telling.wait(STEP)
    assert telling.told() == {STRANGER}
    telling.wait(0.1)
    telling.hear_hello(ASKING)
    telling.wait(0.5)
    assert telling.told(telling.chair.t - 0.4) == {ASKING}


def test_a_hello_while_somebody_drives_is_answered_once():
    telling = Told()
    telling.drive()
    telling.hear_hello(STRANGER)
    telling.wait(0.08)
    assert [address for _, address, _ in telling.sent].count(STRANGER) == 1


def test_a_thousand_hellos_a_second_are_answered_fifty_times():
    telling = Told(PAIRED)
    for number in range(2000):
        telling.telling.greet(encode_hello(KEY.id), ("somebody", 100 + number), telling.chair.t)
        if number % 10 == 9:
            telling.wait(STEP)
    assert sum(address != PAIRED for _, address, _ in telling.sent) <= 101


@pytest.mark.parametrize("datagram", [b"", b"BMIH", encode_hello(KEY.id) + b"\0", encode_hello(KEY.id)[:-1] + b"\1"])
def test_what_is_no_hello_is_not_answered(datagram):
    telling = Told()
    telling.telling.greet(datagram, STRANGER, telling.chair.t)
    telling.wait(0.3)
    assert telling.sent == []


def test_a_network_without_room_is_no_matter():
    telling = Told(PAIRED)
    telling.full = True
    telling.wait(0.5)
    telling.full = False
    telling.wait(0.2)
    assert telling.sent


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
