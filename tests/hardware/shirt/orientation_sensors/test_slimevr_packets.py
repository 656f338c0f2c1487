"""The datagrams of SlimeVR's trackers: read as they are sent, and nothing else is taken for one."""

import random
import struct

import numpy as np
import pytest
from hardware.shirt.orientation_sensors.slime_tracker import SlimeTracker
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.shirt.orientation_sensors.slimevr_packets import (
    HANDSHAKE_REPLY,
    HEARTBEAT,
    LONGEST,
    TrackerAcceleration,
    TrackerBattery,
    TrackerFlex,
    TrackerHandshake,
    TrackerRotation,
    TrackerSensor,
    read_packet,
    sensor_acknowledgement,
)

JUNK = 100_000


def head(kind, number=7):
    return struct.pack(">IQ", kind, number)


def test_a_tracker_is_known_by_its_address():
    packet = read_packet(SlimeTracker("0A:00:00:00:00:FF").handshake())
    assert packet == (0, TrackerHandshake("0A:00:00:00:00:FF"))


def test_a_rotation_is_read_with_its_sensor_and_number():
    tracker = SlimeTracker(sensors=(0, 3))
    tracker.orientation[3] = np.array((0.5, -0.5, 0.5, 0.5))
    tracker.packet(0)
    number, (sensor, orientation) = read_packet(tracker.rotation(3))
    assert (number, sensor) == (1, 3)
    np.testing.assert_allclose(orientation, (0.5, -0.5, 0.5, 0.5), atol=1e-7)


@pytest.mark.parametrize(
    ("kind", "content", "expected"),
    [
        (26, struct.pack(">Bf", 2, 412.5), TrackerFlex(2, 412.5)),
        (12, struct.pack(">2f", 3.9, 0.5), TrackerBattery(0.5)),
        (12, struct.pack(">f", 0.25), TrackerBattery(0.25)),  # owoTrack
        (15, bytes([1, 2]), TrackerSensor(1, 2)),
        (15, bytes([0, 1, 8, 0, 0, 0, 3]), TrackerSensor(0, 1)),
        (0, b"", None),
        (4, bytes(12) + bytes([2]), TrackerAcceleration(2)),
        (4, bytes(12), TrackerAcceleration(0)),  # owoTrack
        (19, bytes([255, 60]), None),
        (17, struct.pack(">BB4fB", 0, 2, 0, 0, 0, 1, 0), None),  # a correction by the compass
    ],
)
def test_each_kind_is_read(kind, content, expected):
    assert read_packet(head(kind) + content) == (7, expected)


@pytest.mark.parametrize(("kind", "sensor"), [(1, 0), (16, 1)])
def test_the_rotations_of_phones_are_read(kind, sensor):
    number, content = read_packet(head(kind) + struct.pack(">4f", 0, 0, 0.6, 0.8))
    assert isinstance(content, TrackerRotation)
    assert (number, content.sensor) == (7, sensor)
    np.testing.assert_allclose(content.orientation, (0, 0, 0.6, 0.8), atol=1e-7)


def rotation(*quaternion):
    return head(17) + struct.pack(">BB4fB", 0, 1, *quaternion, 0)


@pytest.mark.parametrize(
    "datagram",
    [
        b"",
        b"hello",
        head(17),
        rotation(0, 0, 0, 0),
        rotation(0, 0, 0, 1.2),
        rotation(0, 0, 0, float("nan")),
        rotation(float("inf"), 0, 0, 1),
        rotation(0, 0, 0, 1)[:-1],
        rotation(0, 0, 0, 1) + bytes(LONGEST),
        struct.pack("<IQ", 17, 7) + rotation(0, 0, 0, 1)[12:],  # little-endian
        head(26) + struct.pack(">Bf", 0, float("nan")),
        head(4) + struct.pack(">3fB", 0, float("nan"), 0, 0),
        head(4) + bytes(8),
        head(12) + struct.pack(">2f", 3.9, 40.0),
        head(100) + bytes(40),  # a bundle, which we do not ask for
        head(3) + bytes(28 + 1 + 6),  # no address
        head(3) + bytes(28) + b"\xff" + bytes(20),  # the firmware's name is longer than the datagram
        HANDSHAKE_REPLY,
    ],
)
def test_what_is_no_packet_is_refused(datagram):
    assert read_packet(datagram) is None


@given(st.binary(max_size=80) | st.builds(lambda kind, rest: head(kind) + rest, st.integers(0, 120), st.binary()))
def test_whatever_comes_is_read_or_refused(datagram):
    packet = read_packet(datagram)
    if packet is not None and isinstance(packet.content, TrackerRotation):
        assert np.linalg.norm(packet.content.orientation) == pytest.approx(1.0)


def test_random_datagrams_are_no_packets():
    source = random.Random(1)
    assert all(read_packet(source.randbytes(12 + i % 40)) is None for i in range(JUNK))


def test_what_is_sent_is_as_the_firmware_reads_it():
    assert bytes([3]) + b"Hey OVR =D 5" == HANDSHAKE_REPLY
    assert bytes.fromhex("00000001 0000000000000000") == HEARTBEAT
    assert sensor_acknowledgement(TrackerSensor(2, 1)) == bytes.fromhex("0000000f0201")
