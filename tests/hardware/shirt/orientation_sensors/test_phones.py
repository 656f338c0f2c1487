"""Phones as sensors: their angles, their messages, and the shirt that is made of them."""

import math
import random

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.orientation_sensors.phone_page import PhonePage
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from app.hardware.base import HardwareError, PageShirt, SearchingShirt
from app.hardware.registry import parse_shirt
from app.hardware.shirt.orientation_sensors.orientation import angle_between
from app.hardware.shirt.orientation_sensors.orientation_frames import REST_TIME
from app.hardware.shirt.orientation_sensors.phones import (
    MESSAGE,
    PhonesConfig,
    PhonesShirt,
    decode_phone,
    device_orientation,
)
from app.pipeline.channel_health import ChannelHealth
from building import joint_map, profile_of

RATE = 50.0
ROUNDING = math.radians(0.1)
JUNK = 100_000


@given(st.floats(0, 360), st.floats(-180, 180), st.floats(-90, 90))
def test_angles_are_turns_about_z_then_x_then_y_of_the_device(alpha, beta, gamma):
    expected = Rotation.from_euler("ZXY", (alpha, beta, gamma), degrees=True).as_quat()
    assert angle_between(device_orientation(alpha, beta, gamma), expected) < 1e-7


@pytest.mark.parametrize(
    ("angles", "axis", "turned"),
    [
        ((0, 0, 0), (0, 0, 1), (0, 0, 1)),  # flat on a table, the top to the north
        ((90, 0, 0), (0, 1, 0), (-1, 0, 0)),  # turned left: the top points west
        ((0, 90, 0), (0, 0, 1), (0, -1, 0)),  # upright: the screen looks south
        ((0, 0, 90), (0, 0, 1), (1, 0, 0)),  # on its right edge: the screen looks east
        ((0, 90, 45), (0, 1, 0), (0, 0, 1)),  # upright: the last turn leaves the top where it is
    ],
)
def test_a_device_is_held_as_the_specification_says(angles, axis, turned):
    np.testing.assert_allclose(Rotation.from_quat(device_orientation(*angles)).apply(axis), turned, atol=1e-12)


def test_the_orientation_goes_on_where_the_angles_jump():
    """At beta 90 degrees alpha and gamma turn about one axis: a small movement changes both by half a turn."""
    before, after = device_orientation(10.0, 89.9, 0.0), device_orientation(190.0, 89.9, 180.0)
    assert angle_between(before, after) < math.radians(0.5)
    assert angle_between(device_orientation(359.9, 20, 0), device_orientation(0.1, 20, 0)) < math.radians(0.3)


def test_a_message_is_read():
    sample = decode_phone(MESSAGE.pack(1, 0, 0, 7, 8, 9.5, 10.0, -20.0, 30.0))
    assert sample == (7, 8, 9.5, (10.0, -20.0, 30.0))


@pytest.mark.parametrize(
    "message",
    [
        b"",
        b"hello",
        MESSAGE.pack(2, 0, 0, 7, 8, 9.5, 10.0, -20.0, 30.0),
        MESSAGE.pack(1, 1, 0, 7, 8, 9.5, 10.0, -20.0, 30.0),
        MESSAGE.pack(1, 0, 0, 7, 8, float("nan"), 10.0, -20.0, 30.0),
        MESSAGE.pack(1, 0, 0, 7, 8, -1.0, 10.0, -20.0, 30.0),
        MESSAGE.pack(1, 0, 0, 7, 8, 9.5, float("nan"), -20.0, 30.0),
        MESSAGE.pack(1, 0, 0, 7, 8, 9.5, 10.0, -400.0, 30.0),
        MESSAGE.pack(1, 0, 0, 7, 8, 9.5, 10.0, -20.0, float("inf")),
        MESSAGE.pack(1, 0, 0, 7, 8, 9.5, 10.0, -20.0, 30.0) + b"\0",
    ],
)
def test_what_is_no_sample_is_refused(message):
    assert decode_phone(message) is None


@given(st.binary(min_size=MESSAGE.size, max_size=MESSAGE.size))
def test_whatever_comes_is_read_or_refused(message):
    sample = decode_phone(message)
    if sample is not None:
        assert np.linalg.norm(device_orientation(*sample.angles_deg)) == pytest.approx(1.0)


class Worn:
    """A shirt of two phones on a fake clock: number 1 on the trunk, number 3 on the left forearm."""

    def __init__(self):
        self.clock = FakeClock(50.0)
        self.shirt = PhonesShirt(PhonesConfig(kind="phones", trunk="1", left_forearm="3"), self.clock)
        self.shirt.open()
        self.trunk = PhonePage(self.shirt, self.clock, 1)
        self.arm = PhonePage(self.shirt, self.clock, 3, ahead=-20.0)

    def run(self, seconds, pages=None):
        """Let pages send for some time, and return the frames."""
        frames = []
        for _ in range(round(seconds * RATE)):
            for page in (self.trunk, self.arm) if pages is None else pages:
                page.send()
            self.clock.time += 1 / RATE
            frames.append(self.shirt.read(0.0))
        return [frame for frame in frames if frame is not None]


def health_of(shirt):
    """Return what watches over the six channels of a shirt while somebody drives with all of them."""
    maps = [joint_map(joint, channels, (1.0, 0.0, 0.0)) for joint, channels in shirt.layout.channels_of_joint.items()]
    profile = profile_of(shirt.layout, maps, -4.0, 4.0, RATE).model_copy(update={"noise": (0.01,) * 6})
    return ChannelHealth(profile, np.ones(6, dtype=np.bool_), RATE)


@pytest.fixture
def worn():
    made = Worn()
    made.run(1.5 * REST_TIME)
    return made


def test_the_channels_are_the_turn_of_the_forearm_from_the_trunk(worn):
    worn.arm.angles = (30.0, 0.0, 0.0)
    *_, frame = worn.run(0.1)
    np.testing.assert_allclose(frame.values[3:], (0, 0, math.radians(30)), atol=ROUNDING)
    worn.trunk.angles = worn.arm.angles = (70.0, 0.0, 0.0)
    *_, frame = worn.run(0.1)
    np.testing.assert_allclose(frame.values[3:], (0, 0, 0), atol=ROUNDING)


def test_a_limb_at_rest_is_no_broken_sensor_and_one_that_hangs_is_found(worn):
    """Safety S5: browsers round the angles, so that those of a limb at rest are constant."""
    watch = health_of(worn.shirt)
    frames = worn.run(2.0)
    assert np.ptp([frame.values for frame in frames], axis=0).max() == 0.0
    assert [watch.step(frame.values) for frame in frames] == [None] * len(frames)
    hangs = [watch.step(frame.values) for frame in worn.run(0.2, [worn.trunk])]
    assert hangs[:2] == [None] * 2
    assert [bad.tolist() for bad in hangs[4:]] == [[False] * 3 + [True] * 3] * 6


def test_a_page_that_was_asleep_is_in_time_again(worn):
    """Browsers stop the clock of a page while its device sleeps: its messages seem late by as much."""
    worn.clock.time += 30.0
    worn.arm.delay_clock(30.0)
    *_, frame = worn.run(0.1)
    assert worn.shirt.late == 0
    assert np.isfinite(frame.values).all()


def test_a_phone_that_is_silent_is_nan_and_without_any_there_is_no_frame(worn):
    *_, frame = worn.run(0.2, [worn.trunk])
    assert np.isfinite(frame.values).tolist() == [True] * 3 + [False] * 3
    assert "Silent: Left forearm." in str(worn.shirt.description())
    worn.run(0.1, [])
    assert worn.run(1.0, []) == []


def test_messages_that_come_again_late_or_as_junk_are_counted_and_left_out(worn):
    message = worn.arm.message()
    for _ in range(3):
        worn.shirt.add_sample(3, message, worn.clock.now())
    worn.shirt.add_sample(3, b"junk", worn.clock.now())
    worn.shirt.add_sample(9, worn.arm.message(), worn.clock.now())
    assert worn.shirt.refused == 4
    worn.arm.angles = (90.0, 0.0, 0.0)
    worn.arm.send(delay=0.8)
    assert worn.shirt.late == 1
    assert "1 late message left out (the newest took 0.8 s longer" in str(worn.shirt.description())
    worn.arm.angles = (0.0, 0.0, 0.0)
    *_, frame = worn.run(0.02)
    np.testing.assert_allclose(frame.values[3:], (0, 0, 0), atol=ROUNDING)


def test_a_page_that_was_loaded_again_has_to_be_still_first(worn):
    again = PhonePage(worn.shirt, worn.clock, 3, page=78, ahead=3000.0)
    again.angles = (140.0, 0.0, 0.0)  # another north
    frames = worn.run(2 * REST_TIME, [worn.trunk, again])
    assert np.isnan(frames[0].values[3:]).all()
    np.testing.assert_allclose(frames[-1].values, np.zeros(6), atol=ROUNDING)
    assert worn.shirt.late == 0


def test_phones_on_no_part_of_the_body_are_offered_while_they_send(worn):
    assert isinstance(worn.shirt, SearchingShirt)
    other = PhonePage(worn.shirt, worn.clock, 2)
    other.send()
    assert worn.shirt.found == ["2"]
    assert "On no part of the body: phone 2." in str(worn.shirt.description())
    worn.clock.time += 3.0
    assert worn.shirt.found == []


def test_junk_gives_no_frame():
    shirt = PhonesShirt(PhonesConfig(kind="phones", trunk="1"), FakeClock())
    shirt.open()
    source = random.Random(1)
    for i in range(JUNK):
        shirt.add_sample(1 + i % 6, source.randbytes(20 + i % 20), 0.0)
    assert shirt.refused == JUNK
    assert shirt.read(0.5) is None


def test_it_says_what_it_is():
    shirt = PhonesShirt(PhonesConfig(kind="phones", trunk="1", left_forearm="3"), FakeClock())
    assert isinstance(shirt, PageShirt)
    assert str(shirt.description()) == "The phones are not in use."
    shirt.add_sample(1, b"junk", 0.0)
    shirt.open()
    assert shirt.refused == 0
    assert str(shirt.description()).startswith("Phones: 0 of 2 send, 6 sensors. Silent: Trunk and Left forearm.")


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"trunk": "7"}, "'7' is the number of no phone: write one from 1 to 6"),
        ({"trunk": "one"}, "is the number of no phone"),
        ({"trunk": "1", "head": " 1 "}, "the sensor 1 is on two parts of the body"),
        ({"trunk": 1}, "trunk"),
    ],
)
def test_a_wrong_configuration_is_one_sentence(fields, words):
    with pytest.raises(HardwareError) as refused:
        parse_shirt({"kind": "phones", **fields})
    assert words in str(refused.value)
    assert "\n" not in str(refused.value)
