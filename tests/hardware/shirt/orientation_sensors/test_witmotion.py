"""The bytes of WitMotion's Bluetooth sensors."""

import struct

import numpy as np
import pytest
from hardware.shirt.orientation_sensors.fake_bleak import FakeSensor
from hypothesis import assume, given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from app.hardware.shirt.orientation_sensors.orientation import angle_between
from app.hardware.shirt.orientation_sensors.witmotion import (
    HEADS,
    SensorDecoder,
    SensorMotion,
    SensorVoltage,
    sensor_orientation,
    set_up_commands,
)

ANGLE = st.floats(-180, 180)
PITCH = st.floats(-90, 90)


def frame(roll=0.0, pitch=0.0, yaw=0.0):
    sensor = FakeSensor("A1:B2:C3:D4:E5:F6")
    sensor.angles = (roll, pitch, yaw)
    return sensor.motion()


def test_a_frame_of_the_data_sheet_has_the_angles_of_its_last_six_bytes():
    # 90, -45 and 1 step of 180/32768 degrees, low byte first
    sent = bytes.fromhex("5561 0100 0200 0008 0000 0000 0000 0040 00e0 0100".replace(" ", ""))
    (motion,) = SensorDecoder().feed(sent)
    assert motion == SensorMotion(sent[2:], pytest.approx((90.0, -45.0, 180 / 32768)))


def test_an_answer_has_the_voltage_of_the_battery():
    answer = struct.pack("<BBHH14x", 0x55, 0x71, 0x64, 385)
    assert SensorDecoder().feed(answer) == [SensorVoltage(3.85)]
    other = struct.pack("<BBHH14x", 0x55, 0x71, 0x3A, 385)  # a register that was not asked for
    assert SensorDecoder().feed(other) == []


def test_what_newer_sensors_send_behind_the_angles_is_left_out():
    decoder = SensorDecoder()
    for _ in range(3):
        assert len(decoder.feed(frame(10.0) + bytes(8))) == 1
    assert decoder.junk == 0


def test_an_impossible_pitch_is_no_measurement():
    assert SensorDecoder().feed(frame(pitch=120.0)) == []


@given(st.lists(st.tuples(ANGLE, PITCH, ANGLE), min_size=1, max_size=5), st.integers(2, 19))
def test_frames_come_whole_several_at_once_or_in_two_parts(postures, cut):
    frames = [frame(*(0.9999 * angle for angle in posture)) for posture in postures]
    expected = [sent[2:] for sent in frames]
    whole = SensorDecoder()
    assert [motion.content for motion in whole.feed(b"".join(frames))] == expected
    parts = [part for sent in frames for part in (sent[:cut], sent[cut:])]
    assume(all(part[:2] not in HEADS for part in parts[1::2]))
    split = SensorDecoder()
    assert [motion.content for part in parts for motion in split.feed(part)] == expected
    assert (whole.junk, split.junk) == (0, 0)


def test_the_rest_of_a_frame_that_was_lost_is_none():
    decoder = SensorDecoder()
    assert decoder.feed(frame()[:12]) == []
    assert len(decoder.feed(frame(5.0))) == 1
    decoder.feed(frame()[:12])
    decoder.begin_anew()
    assert decoder.feed(frame()[12:]) == []
    assert decoder.junk == 1


@given(st.lists(st.binary(max_size=64), max_size=20))
def test_junk_is_counted_and_never_more_than_was_sent(pieces):
    decoder = SensorDecoder()
    for piece in pieces:
        assert len(decoder.feed(piece)) <= 4
    assert decoder.junk <= len(pieces)


def test_a_hundred_thousand_pieces_of_junk_make_no_frame():
    dice = np.random.default_rng(5)
    pieces = dice.integers(0, 0x55, (100_000, 20), dtype=np.uint8)
    decoder = SensorDecoder()
    assert [found for piece in pieces if (found := decoder.feed(piece.tobytes()))] == []
    assert decoder.junk == 100_000


@given(ANGLE, PITCH, ANGLE)
def test_the_angles_turn_about_z_then_y_then_x(roll, pitch, yaw):
    expected = Rotation.from_euler("ZYX", (yaw, pitch, roll), degrees=True).as_quat()
    assert angle_between(sensor_orientation(roll, pitch, yaw), expected) < 1e-6


@pytest.mark.parametrize(("rate", "code"), [(10.0, 6), (12.5, 7), (50.0, 8), (60.0, 9), (100.0, 9), (500.0, 9)])
def test_a_sensor_is_told_a_rate_that_is_high_enough_and_not_to_keep_it(rate, code):
    unlock, command = set_up_commands(rate)
    assert unlock.hex() == "ffaa6988b5"
    assert command == bytes((0xFF, 0xAA, 0x03, code, 0x00))
