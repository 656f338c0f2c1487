"""Frames out of orientations: the posture at rest, silent sensors, sensors that begin anew, and drift."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.shirt.orientation_sensors.body_parts import PARTS, layout_of, reference_of
from app.hardware.shirt.orientation_sensors.orientation import exponential, product
from app.hardware.shirt.orientation_sensors.orientation_frames import (
    DRIFT_TIME,
    REST_PATIENCE,
    REST_TIME,
    OrientationFrames,
)
from app.layout import MAX_CHANNELS, MAX_JOINTS, USUAL_JOINTS, joint_title

RATE = 50.0
PERIOD = 1 / RATE
NUMBERS = st.floats(-1, 1)
VECTORS = st.tuples(NUMBERS, NUMBERS, NUMBERS).map(np.array)
BEND = np.array((0.0, 1.2, 0.0))  # rad


class Body:
    """Sensors whose orientations are sent once a period."""

    def __init__(self, parts, bends=(), from_neighbour=False):
        self.frames = OrientationFrames([*parts, *bends], bends, RATE, from_neighbour)
        self.orientation = {part: exponential(np.array((0.1, 0.2, i))) for i, part in enumerate(parts)}
        self.t = 100.0

    def step(self, **turned):
        """Turn parts in the room by rotation vectors, send all and return the frame."""
        for part, vector in turned.items():
            self.orientation[part] = product(exponential(np.array(vector, float)), self.orientation[part])
        for part, orientation in self.orientation.items():
            if orientation is not None:
                self.frames.take_orientation(part, orientation, self.t)
        self.t += PERIOD
        return self.frames.frame(self.t)

    def hold(self, seconds=REST_TIME):
        """Return the frame after some time without a movement."""
        for _ in range(round(seconds * RATE)):
            frame = self.step()
        return frame


def test_at_rest_all_channels_are_0_and_before_that_there_is_no_frame():
    body = Body(["trunk", "right_forearm"])
    assert body.hold(REST_TIME - PERIOD) is None
    assert body.frames.moving == ["trunk", "right_forearm"]
    np.testing.assert_allclose(body.hold(), np.zeros(6), atol=1e-6)
    assert body.frames.moving == []
    assert body.step().dtype == np.float32


@given(VECTORS, VECTORS)
def test_an_arm_is_measured_from_the_trunk_whichever_way_the_person_turns(turn, bend):
    body = Body(["trunk", "right_forearm"])
    body.hold(2 * REST_TIME)
    body.step(right_forearm=bend)
    before = body.hold(PERIOD)[3:]
    assert np.linalg.norm(before) == pytest.approx(np.linalg.norm(bend), abs=1e-5)
    body.step(trunk=turn, right_forearm=turn)
    np.testing.assert_allclose(body.hold(PERIOD)[3:], before, atol=1e-5)


def test_without_a_sensor_on_the_trunk_an_arm_is_measured_from_the_chair_or_the_room():
    for parts, moves in ((["chair", "left_hand"], False), (["left_hand"], True)):
        body = Body(parts)
        body.hold(2 * REST_TIME)
        frame = body.step(**dict.fromkeys(parts, (0.0, 0.0, 0.4)))
        assert len(frame) == 3
        assert (np.linalg.norm(frame) > 0.3) == moves


def test_a_limb_can_be_measured_from_its_neighbour():
    parts = ["trunk", "right_upper_arm", "right_forearm", "right_hand"]
    assert [reference_of(part, parts, False) for part in parts] == [None, "trunk", "trunk", "trunk"]
    assert [reference_of(part, parts, True) for part in parts] == [None, "trunk", "right_upper_arm", "right_forearm"]
    assert reference_of("right_hand", ["trunk", "right_upper_arm", "right_hand"], True) == "right_upper_arm"
    assert reference_of("right_hand", ["chair", "right_hand"], False) == "chair"
    lifted = dict.fromkeys(parts[1:], BEND)
    from_trunk, from_neighbour = Body(parts), Body(parts, from_neighbour=True)
    for body in (from_trunk, from_neighbour):
        body.hold(2 * REST_TIME)
    moved = [np.linalg.norm(body.step(**lifted).reshape(4, 3), axis=1) for body in (from_trunk, from_neighbour)]
    np.testing.assert_allclose(moved[0], (0, 1.2, 1.2, 1.2), atol=1e-5)
    np.testing.assert_allclose(moved[1], (0, 1.2, 0, 0), atol=1e-5)


def test_a_silent_sensor_is_nan_after_three_periods_and_comes_back():
    body = Body(["trunk", "right_forearm", "left_forearm"])
    body.hold(2 * REST_TIME)
    kept, body.orientation["left_forearm"] = body.orientation["left_forearm"], None
    known = [np.isfinite(body.step()).tolist() for _ in range(4)]
    assert known == [[True] * 9] * 2 + [[True] * 6 + [False] * 3] * 2
    assert body.frames.silent(body.t) == ["left_forearm"]
    body.orientation["left_forearm"] = kept
    np.testing.assert_allclose(body.step(), np.zeros(9), atol=1e-6)


def test_a_sensor_that_gives_signs_keeps_its_orientation_and_none_that_it_never_had():
    body = Body(["trunk", "right_forearm"])
    body.hold(2 * REST_TIME)
    bent = body.step(right_forearm=BEND)
    kept, body.orientation["right_forearm"] = body.orientation["right_forearm"], None
    for _ in range(50):
        assert body.frames.take_sign("right_forearm", body.t)
        np.testing.assert_allclose(body.step(), bent, atol=1e-5)
    assert np.isnan([body.step()[3] for _ in range(4)]).tolist() == [False] * 2 + [True] * 2
    body.frames.forget("right_forearm")
    assert not body.frames.take_sign("right_forearm", body.t)
    assert np.isnan(body.step()[3:]).all()
    body.orientation["right_forearm"] = kept
    np.testing.assert_allclose(body.hold()[3:], np.zeros(3), atol=1e-5)


def test_signs_revive_no_orientation_from_before_a_gap():
    """What was lost meanwhile may have been a movement."""
    body = Body(["trunk", "right_forearm"])
    body.hold(2 * REST_TIME)
    kept, body.orientation["right_forearm"] = body.orientation["right_forearm"], None
    body.hold(2.0)
    for _ in range(50):
        assert not body.frames.take_sign("right_forearm", body.t)
        assert np.isnan(body.step()[3:]).all()
    body.orientation["right_forearm"] = product(exponential(BEND), kept)
    assert np.linalg.norm(body.step()[3:]) == pytest.approx(np.linalg.norm(BEND), abs=1e-5)


def test_without_the_trunk_nothing_that_is_measured_from_it_is_known():
    body = Body(["trunk", "right_forearm"], bends=["left_fingers"])
    body.hold(2 * REST_TIME)
    body.orientation["trunk"] = None
    for _ in range(4):
        body.frames.take_bend("left_fingers", 410.0, body.t)
        frame = body.step()
    assert np.isnan(frame[:6]).all()
    assert frame[6] == 410.0
    body.hold(5 * PERIOD)
    assert body.frames.frame(body.t) is None, "without any sample there is no frame, so that the shirt counts as silent"


def test_a_sensor_that_moves_is_at_rest_when_it_is_still_or_after_ten_seconds():
    body = Body(["right_hand"])
    for i in range(round((REST_PATIENCE - 1.0) * RATE)):
        assert body.step(right_hand=(0, 0.5 * math.cos(i / 5), 0)) is None
    assert body.hold() is not None
    shaking = Body(["right_hand"])
    frames = [shaking.step(right_hand=(0, 0.5 * math.cos(i / 5), 0)) for i in range(round((REST_PATIENCE + 1) * RATE))]
    first = next(i for i, frame in enumerate(frames) if frame is not None)
    assert first / RATE == pytest.approx(REST_PATIENCE, abs=0.1)


def test_a_sensor_that_began_anew_has_to_be_still_again():
    """Its idea of north is another one: without this, its channels would jump, which could be a gesture."""
    body = Body(["trunk", "right_forearm", "left_forearm"])
    body.hold(2 * REST_TIME)
    body.frames.forget("right_forearm")
    frame = body.step(right_forearm=(0, 0, 2.5))
    assert np.isnan(frame[3:6]).all()
    assert np.isfinite(frame[[0, 1, 2, 6, 7, 8]]).all()
    np.testing.assert_allclose(body.hold(), np.zeros(9), atol=1e-6)
    body.frames.forget("trunk")
    assert body.step(trunk=(0, 0, 1.0)) is None, "all others are measured from the trunk"
    np.testing.assert_allclose(body.hold(), np.zeros(9), atol=1e-6)
    body.frames.forget("left_fingers")  # a strain sensor has no posture


def test_a_limb_that_turns_beyond_pi_does_not_jump():
    body = Body(["right_hand"])
    body.hold(2 * REST_TIME)
    course = [body.step(right_hand=(0, 0.05, 0)) for _ in range(90)]
    assert np.abs(np.diff(course, axis=0)).max() < 0.051
    assert np.linalg.norm(course[-1]) == pytest.approx(4.5, abs=1e-4)


def test_what_drifts_is_named():
    body = Body(["trunk", "right_forearm", "left_forearm"])
    slow, fast = (0, 0, math.radians(1.5) * PERIOD), (0, 0, math.radians(3.0) * PERIOD)
    for _ in range(round((DRIFT_TIME - 1) * RATE)):
        body.step(right_forearm=slow, left_forearm=fast)
    assert body.frames.drifting == []
    for _ in range(round(2 * RATE)):
        body.step(right_forearm=slow, left_forearm=fast)
    assert body.frames.drifting == ["left_forearm"]
    body.frames.forget("left_forearm")
    assert body.frames.drifting == []


def test_the_layout_has_the_channels_in_the_order_of_the_frames():
    layout = layout_of("trackers", ["left_hand", "trunk", "chair", "left_fingers"], ["left_fingers"])
    signals = [*(f"trunk_{i}" for i in (1, 2, 3)), *(f"left_wrist_{i}" for i in (1, 2, 3)), "left_fingers_1"]
    assert layout.channel_names == signals
    assert layout.joint_names == ["trunk", "left_wrist", "left_fingers"]
    assert layout.may_stay_constant == [True] * 6 + [False], "a strain sensor always trembles"
    assert [channel.unit for channel in layout.channels] == ["rad"] * 6 + [None]
    body = Body(["trunk", "left_hand"], bends=["left_fingers"])
    body.frames.take_bend("left_fingers", 7.0, body.t)
    assert len(body.step()) == 7


def test_every_part_fits_into_one_layout_and_its_joint_has_a_name_in_each_language():
    layout = layout_of("all", PARTS)
    assert len(layout.channels) <= MAX_CHANNELS
    assert len(layout.joints) == len(PARTS) - 1 <= MAX_JOINTS
    assert set(layout.joint_names) <= set(USUAL_JOINTS)
    assert all(str(joint_title(joint)) == joint.label for joint in layout.joints)
