"""The bytes of each head tracker, and datagrams that are no poses."""

import math
import socket
import struct
from itertools import pairwise

import pytest
from fake_clock import FakeClock
from hardware.head.flock_unit import FlockUnit, encode
from hardware.head.heads import FreepieCase, OpentrackCase, wait_for
from hypothesis import given
from hypothesis import strategies as st

from app.clock import MonotonicClock
from app.hardware.base import HardwareError
from app.hardware.configs import FlockOfBirdsConfig, OpentrackConfig, RecordedHeadConfig, SimulatedHeadConfig
from app.hardware.head import flock_of_birds, freepie, opentrack
from app.hardware.head.flock_of_birds import FlockOfBirds
from app.hardware.head.recorded import RecordedHead
from app.hardware.head.simulator import SimulatedHead
from app.hardware.registry import HEADS, make_head, parse_head
from folders import SHARED

RECORDING = SHARED / "data" / "upper_body" / "head_pose.csv"
WORD = st.integers(-32768, 32767)


def test_opentrack_in_numbers():
    pose = opentrack.decode(struct.pack("<6d", 10.0, 20.0, 30.0, 90.0, 45.0, -30.0), 5.0)
    assert pose.t == 5.0
    assert pose[1:4] == pytest.approx((-math.pi / 2, math.pi / 4, math.pi / 6))
    assert pose[4:] == pytest.approx((-0.3, 0.1, 0.2))


@pytest.mark.parametrize("place", range(6))
@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf])
def test_opentrack_without_a_number_is_no_pose(place, bad):
    numbers = [0.0] * 6
    numbers[place] = bad
    assert opentrack.decode(struct.pack("<6d", *numbers), 1.0) is None


def test_freepie_keeps_its_angles_where_its_flags_say():
    numbers = [float(i) / 10 for i in range(12)]
    assert freepie.decode(struct.pack("<BB12f", 0, 2, *numbers), 1.0)[1:4] == pytest.approx((-0.0, 0.1, -0.2))
    assert freepie.decode(struct.pack("<BB12f", 0, 3, *numbers), 1.0)[1:4] == pytest.approx((-0.9, 1.0, -1.1))
    assert freepie.decode(struct.pack("<BB12f", 0, 1, *numbers), 1.0) is None, "raw only: no angles"
    assert freepie.decode(struct.pack("<BB12f", 0, 2, math.nan, *numbers[1:]), 1.0) is None


@given(st.tuples(*[WORD] * 6), st.none() | st.integers(1, 14))
def test_a_flock_record_comes_back(words, address):
    record = encode(words, address)
    assert len(record) == (12 if address is None else 13)
    assert [byte >> 7 for byte in record] == [1] + [0] * (len(record) - 1)
    pose = flock_of_birds.decode(record, 2.0)
    x, y, z, azimuth, elevation, roll = ((word & ~3) for word in words)
    inch = 36 * 0.0254 / 32768
    assert pose[4:] == pytest.approx((x * inch, -y * inch, -z * inch))
    assert pose[1:4] == pytest.approx(tuple(a * math.pi / 32768 for a in (-azimuth, elevation, roll)))


@given(st.lists(st.tuples(*[WORD] * 6), min_size=1, max_size=6), st.binary(max_size=20), st.integers(0, 11), st.data())
def test_records_are_found_again_after_a_cut_and_after_noise(records, noise, cut, data):
    wanted = [encode(words) for words in records]
    stream = encode((1, 2, 3, 4, 5, 6))[cut:] + noise + b"".join(wanted)
    cutter, found, at = flock_of_birds.Records(12), [], 0
    while at < len(stream):
        step = data.draw(st.integers(1, 40))
        found += cutter.feed(stream[at : at + step])
        at += step
    assert found[-len(wanted) :] == wanted, "every record after the noise is whole"
    assert all(len(record) == 12 for record in found)


@pytest.mark.parametrize("made", [OpentrackCase, FreepieCase])
def test_junk_is_counted_and_a_second_sender_is_not_heard(made, tmp_path):
    source = made(tmp_path)
    source.head.open()
    source.let_come(0.25, 0.0, 0.0)
    wait_for(source.head, lambda _: True)
    other = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    try:
        own, source.device = source.device, other
        source.let_come(-0.5, 0.0, 0.0)
        source.device = own
        for junk in (b"", b"x", b"\xff" * 47, b"\xff" * 48, b"\xff" * 50, b"\xff" * 51, b"\x00" * 3000):
            source.send(junk)
        source.let_come(0.125, 0.0, 0.0)
        assert wait_for(source.head, lambda pose: pose.yaw != pytest.approx(0.25)).yaw == pytest.approx(0.125)
        assert source.head.junk >= 6
        assert "refused" in str(source.head.description())
    finally:
        other.close()
        source.head.close()
        source.end()


def test_a_flood_does_not_hold_the_loop(tmp_path):
    source = OpentrackCase(tmp_path)
    source.head.open()
    for _ in range(300):
        source.send(b"junk")
    source.head.newest()
    assert source.head.junk <= 64, "the rest waits for the next look"
    source.head.close()
    source.end()


def test_a_taken_port_is_a_sentence(tmp_path):
    source = OpentrackCase(tmp_path)
    source.head.open()
    second = make_head(OpentrackConfig(kind="opentrack", port=source.head.address[1]), MonotonicClock())
    with pytest.raises(HardwareError, match="use an address of this machine and a port that is free"):
        second.open()
    source.head.close()
    source.end()


def test_in_a_group_a_unit_is_configured_and_only_its_records_count():
    unit = FlockUnit(address=2)
    head = FlockOfBirds(FlockOfBirdsConfig(kind="flock_of_birds", device=unit.device, address=2), MonotonicClock())
    try:
        head.open()
        unit.wait_for(lambda: unit.streams)
        assert bytes(unit.commands) == b"?P\x32\x02P\x23\x01\xf2Y@"
        unit.send((0, 0, 0, 8192, 0, 0), address=1)
        unit.send((0, 0, 0, -8192, 0, 0))
        assert wait_for(head, lambda _: True).yaw == pytest.approx(math.pi / 4)
        unit.send_bytes(b"\x05\x06")  # in the middle of nothing
        unit.send((0, 0, 0, 4096, 0, 0))
        assert wait_for(head, lambda pose: pose.yaw < 0).yaw == pytest.approx(-math.pi / 8)
        head.close()
        unit.wait_for(lambda: not unit.streams)
    finally:
        head.close()
        unit.end()


def test_a_flock_whose_line_is_pulled_says_so_and_asks_nobody_to_wait():
    unit = FlockUnit()
    head = FlockOfBirds(FlockOfBirdsConfig(kind="flock_of_birds", device=unit.device), MonotonicClock())
    head.open()
    unit.send((0, 0, 0, 0, 0, 0))
    pose = wait_for(head, lambda _: True)
    unit.unplug()
    for _ in range(200):
        assert head.newest() == pose
        if "was lost" in str(head.description()):
            break
    assert "check its cable" in str(head.description())
    head.close()


def test_a_device_that_is_not_there_is_a_sentence():
    config = FlockOfBirdsConfig(kind="flock_of_birds", device="/dev/ttyUSB9")
    with pytest.raises(HardwareError, match="check cable, power"):
        FlockOfBirds(config, MonotonicClock()).open()


def recorded(tmp_path, content, **changes):
    file = tmp_path / "head.csv"
    file.write_text(content)
    clock = FakeClock(0.0)
    return RecordedHead(RecordedHeadConfig(kind="recorded", file=str(file), **changes), clock), clock


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("t,yaw_deg\n0,1\n5,2\n", "pitch_deg"),
        ("t,yaw_deg,pitch_deg,roll_deg\n0,1,1,1\n1,1,1,1\n", "needs at least 2 s"),
        ("t,yaw_deg,pitch_deg,roll_deg\n0,1,1,1\n3,x,1,1\n", "head.csv"),
        ("t,yaw_deg,pitch_deg,roll_deg\n5,1,1,1\n3,1,1,1\n", "times that grow"),
    ],
)
def test_what_is_no_recorded_head_is_a_sentence(tmp_path, content, words):
    with pytest.raises(HardwareError, match=words):
        recorded(tmp_path, content)[0].open()


ROUND = "t,yaw_deg,pitch_deg,roll_deg\n0,0,0,0\n1,90,0,0\n2,170,0,0\n3,-170,0,0\n"


def test_a_recorded_head_goes_round_without_a_jump(tmp_path):
    head, clock = recorded(tmp_path, ROUND)
    head.open()
    before = head.newest()
    for _ in range(1200):
        clock.time += 0.01
        pose = head.newest()
        assert abs(math.remainder(pose.yaw - before.yaw, math.tau)) < 0.035
        before = pose


def test_a_recorded_head_that_is_played_once_grows_old_at_its_end(tmp_path):
    head, clock = recorded(tmp_path, ROUND, loop=False)
    head.open()
    clock.time = 10.0
    assert head.newest().t == 3.0


@pytest.mark.skipif(not RECORDING.exists(), reason="the recording of a real head is not there")
def test_a_real_head_is_played(tmp_path):
    clock = FakeClock(0.0)
    head = RecordedHead(RecordedHeadConfig(kind="recorded", file=str(RECORDING)), clock)
    head.open()
    yaws = []
    for _ in range(900):
        clock.time += 0.1
        yaws.append(head.newest().yaw)
    assert 0.2 < max(yaws) - min(yaws) < 3.5


def test_the_simulated_head_begins_straight_ahead_and_moves_smoothly():
    clock = FakeClock(0.0)
    head = SimulatedHead(SimulatedHeadConfig(kind="simulator", seed=3), clock)
    head.open()
    poses = [head.newest()]
    for _ in range(2000):
        clock.time += 0.01
        poses.append(head.newest())
    assert poses[0][1:4] == (0.0, 0.0, 0.0)
    assert max(abs(b.yaw - a.yaw) for a, b in pairwise(poses)) < 0.02
    assert 0.2 < max(abs(pose.yaw) for pose in poses) <= 0.5


@pytest.mark.parametrize("document", [None, {}, {"kind": "nose"}, {"kind": "opentrack", "port": -1}, {"kind": 3}])
def test_what_is_no_configuration_is_a_sentence(document):
    with pytest.raises(HardwareError, match=r"head tracker|port"):
        parse_head(document)


def test_every_word_of_the_table_has_its_driver():
    more = {"flock_of_birds": {"device": "/dev/ttyUSB0"}, "recorded": {"file": "/dev/null"}}
    for kind in HEADS:
        head = make_head(parse_head({"kind": kind, **more.get(kind, {})}), FakeClock())
        assert str(head.description()).endswith(".")
