"""The outputs of a receiver without a chair, and the virtual chair's report, byte by byte."""

import importlib
import inspect
import json
import math
import os
import socket
import struct
from itertools import pairwise

import pytest

from app.faults import State
from app.geometry import STANDSTILL, Twist
from app.hardware.base import HardwareError
from app.hardware.chair.outputs import OUTPUTS, OWN_OPTIONS, Lines, OutputRefused, SimulatedDrive, open_output
from app.hardware.chair.readings import NO_READINGS
from app.hardware.chair.receive import _parser
from app.hardware.chair.report import ChairReport, encode_report
from app.messages import Tick


@pytest.fixture
def pipe():
    ends = os.pipe()
    yield ends
    for end in ends:
        os.close(end)


def lines_of(end):
    return [json.loads(line) for line in os.read(end, 1 << 20).decode().splitlines()]


def test_each_change_is_a_line_and_the_same_is_one_every_100_ms(pipe):
    reading, writing = pipe
    output = Lines(writing)
    output.drive(1.0, "disarmed", STANDSTILL, "")
    output.drive(1.01, "disarmed", STANDSTILL, "why")
    output.drive(1.02, "armed", Twist(0.1, -0.2), "")
    assert lines_of(reading) == [
        {"t": 1.0, "state": "disarmed", "v": 0.0, "omega": 0.0, "reason": ""},
        {"t": 1.01, "state": "disarmed", "v": 0.0, "omega": 0.0, "reason": "why"},
        {"t": 1.02, "state": "armed", "v": 0.1, "omega": -0.2, "reason": ""},
    ]
    for step in range(1000):
        output.drive(1.03 + step / 100, "armed", Twist(0.1, -0.2), "")
    said = [1.02] + [line["t"] for line in lines_of(reading)]
    assert max(b - a for a, b in pairwise(said)) <= 0.1 + 1e-6
    assert len(said) <= 130


def test_a_reader_who_does_not_read_misses_lines_and_the_next_one_is_whole(pipe):
    reading, writing = pipe
    output = Lines(writing)
    for step in range(5000):
        output.drive(step / 100, "armed", Twist(step / 1e4, 0.0), "")
    assert all(set(line) == {"t", "state", "v", "omega", "reason"} for line in lines_of(reading))
    output.drive(60.0, "disarmed", STANDSTILL, "it was full")
    assert lines_of(reading)[-1]["reason"] == "it was full"


def test_a_reader_who_left_is_said_to_whoever_drives():
    reading, writing = os.pipe()
    os.close(reading)
    try:
        with pytest.raises(OSError, match="pipe"):
            Lines(writing).drive(1.0, "disarmed", STANDSTILL, "")
    finally:
        os.close(writing)


def test_the_simulated_drive_goes_where_its_wheels_lead(pipe):
    reading, writing = pipe
    drive = SimulatedDrive(writing)
    steps = 314
    for step in range(steps + 1):
        drive.drive(step / 100, "armed", Twist(0.5, 0.5), "")
    assert (drive.left, drive.right) == (pytest.approx(0.3625), pytest.approx(0.6375))
    heading = 0.5 * steps / 100
    assert drive.pose == pytest.approx((math.sin(heading), 1 - math.cos(heading), heading), abs=1e-9)
    drive.drive(3.15, "disarmed", STANDSTILL, "Why.")
    said = os.read(reading, 10_000).decode().splitlines()
    assert [line.partition(":")[0] for line in said] == ["armed"] * 4 + ["disarmed"]
    assert said[-1].endswith("Why.")
    assert not open_output("sim").is_real


def test_the_wheels_of_the_simulated_drive_are_measured(pipe):
    drive = SimulatedDrive(pipe[1])
    assert drive.poll(0.0) == NO_READINGS._replace(v=0.0, omega=0.0)
    drive.drive(0.0, "armed", Twist(0.5, -0.4), "")
    readings = drive.poll(0.01)
    assert (readings.v, readings.omega) == pytest.approx((0.5, -0.4))
    assert "no chair is connected" in drive.description()
    assert "no chair is connected" in Lines(pipe[1]).description()
    assert Lines(pipe[1]).poll(0.0) is NO_READINGS


@pytest.mark.parametrize("word", OUTPUTS)
def test_the_options_of_an_output_are_those_of_its_constructor_and_of_the_command_line(word):
    row = OUTPUTS[word]
    if row.extra:
        pytest.importorskip("cyclonedds.core", reason="not every machine has this library: it is the extra ros2")
    made = inspect.signature(getattr(importlib.import_module(row.module), row.name)).parameters
    given = vars(_parser("receiver").parse_args(["--key-file", "7.key", "--output", word]))
    assert set(OWN_OPTIONS) <= given.keys()
    if row.module != "app.hardware.chair.outputs":  # whose outputs have the handle of the tests' own pipe
        assert list(made) == [*row.needs, *row.takes]
    required = [name for name, parameter in made.items() if parameter.default is inspect.Parameter.empty]
    assert required == list(row.needs)
    assert {*row.needs, *row.takes} <= {*OWN_OPTIONS, "key_file"}


@pytest.mark.parametrize(
    ("word", "given", "why"),
    [
        ("sim", {"tread": 0.5}, "the output sim does not take --tread: leave it out"),
        ("whill", {"device": "x", "tread": 0.5, "topic": "/a"}, "does not take --topic"),
        ("whill", {"device": "x", "tread": 0.5, "chair_document": "x"}, "does not take --chair-document"),
        ("whill", {"tread": 0.5, "device": None}, "the output whill needs --device"),
        ("analog", {"key_file": "x"}, "the output analog needs --device"),
    ],
)
def test_options_of_other_outputs_and_missing_ones_are_refused(word, given, why):
    with pytest.raises(OutputRefused, match=why):
        open_output(word, given)


TICK = Tick(t=12.5, frame_seq=77, x=1.5, y=-2.0, theta=0.25, v=0.5, omega=-0.75, state=State.ARMED)


def test_the_bytes_are_those_of_the_protocol():
    datagram = encode_report(TICK)
    assert len(datagram) == 44
    assert datagram[:8] == b"BMIP" + bytes([1, 2, 0, 0])
    assert struct.unpack("<IQ", datagram[8:20]) == (77, 12_500_000_000)
    assert struct.unpack("<6f", datagram[20:]) == (1.5, -2.0, 0.25, 0.5, -0.75, 0.0)


def test_a_report_arrives_and_nobody_there_is_no_trouble():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listening:
        listening.bind(("127.0.0.1", 0))
        listening.settimeout(5.0)
        report = ChairReport(*listening.getsockname())
        report.send(TICK)
        assert listening.recv(100) == encode_report(TICK)
    for _ in range(5):
        report.send(TICK)
    report.close()


def test_an_address_that_is_none_is_one_sentence():
    with pytest.raises(HardwareError, match=r"reports cannot be sent to .*: give a host and port"):
        ChairReport("not a host", 5000)
