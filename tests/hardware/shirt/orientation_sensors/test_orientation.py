"""The mathematics of orientation sensors, against scipy's and against itself."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from app.hardware.shirt.orientation_sensors.orientation import (
    angle_between,
    drift_rate,
    exponential,
    inverse,
    logarithm,
    mean_orientation,
    nearest_vector,
    product,
    unit_quaternion,
)
from app.hardware.shirt.orientation_sensors.orientation_frames import DRIFT_LIMIT

NUMBERS = st.floats(-1, 1, allow_subnormal=False)
QUATERNIONS = (
    st.tuples(NUMBERS, NUMBERS, NUMBERS, NUMBERS)
    .filter(lambda q: np.linalg.norm(q) > 0.1)
    .map(lambda q: np.array(q) / np.linalg.norm(q))
)
AXES = (
    st.tuples(NUMBERS, NUMBERS, NUMBERS)
    .filter(lambda v: np.linalg.norm(v) > 0.1)
    .map(lambda v: np.array(v) / np.linalg.norm(v))
)
ANGLES = st.floats(0, math.pi) | st.floats(0, 1e-3) | st.floats(math.pi - 1e-3, math.pi)
STEP = 0.5  # s


def is_one_rotation(p, q):
    """Tell whether two quaternions turn alike; q and -q do."""
    return min(np.abs(p - q).max(), np.abs(p + q).max()) < 1e-12


@given(QUATERNIONS, QUATERNIONS)
def test_product_and_inverse_are_those_of_scipy(p, q):
    assert is_one_rotation(product(p, q), (Rotation.from_quat(p) * Rotation.from_quat(q)).as_quat())
    assert is_one_rotation(inverse(q), Rotation.from_quat(q).inv().as_quat())


@given(QUATERNIONS)
def test_the_logarithm_is_that_of_scipy_and_the_same_for_both_signs(q):
    vector = logarithm(q)
    assert np.linalg.norm(vector) <= math.pi + 1e-12
    if np.linalg.norm(vector) < math.pi - 1e-6:  # at pi an axis and its opposite are one rotation
        np.testing.assert_allclose(vector, Rotation.from_quat(q).as_rotvec(), atol=1e-9)
        np.testing.assert_array_equal(logarithm(-q), vector)


@given(AXES, ANGLES)
def test_exponential_and_logarithm_undo_each_other(axis, angle):
    vector = angle * axis
    q = exponential(vector)
    assert np.linalg.norm(q) == pytest.approx(1.0, abs=1e-14)
    assert is_one_rotation(q, Rotation.from_rotvec(vector).as_quat())
    if angle < math.pi - 1e-9:
        np.testing.assert_allclose(logarithm(q), vector, rtol=1e-9, atol=1e-300)
    assert is_one_rotation(exponential(logarithm(q)), q)


@given(AXES, st.integers(-300, -1))
def test_a_small_angle_loses_no_digits(axis, exponent):
    angle = 10.0**exponent
    np.testing.assert_allclose(logarithm(exponential(angle * axis)), angle * axis, rtol=1e-14, atol=1e-15 * angle)


def test_no_rotation_has_the_vector_0_without_a_warning():
    np.testing.assert_array_equal(logarithm(exponential(np.zeros(3))), np.zeros(3))
    np.testing.assert_array_equal(nearest_vector(np.zeros(3), np.zeros(3)), np.zeros(3))


@given(QUATERNIONS, QUATERNIONS, QUATERNIONS, QUATERNIONS, QUATERNIONS)
def test_what_turns_all_sensors_changes_no_channel(turn, trunk, trunk_at_rest, arm, arm_at_rest):
    def channels(turned):
        """Return the channels after all sensors were turned, in the room and since they were at rest."""
        rest = product(inverse(trunk_at_rest), arm_at_rest)
        now = product(inverse(product(turned, trunk)), product(turned, arm))
        return product(inverse(rest), now)

    assert is_one_rotation(channels(turn), channels(np.array([0.0, 0.0, 0.0, 1.0])))


@given(QUATERNIONS, AXES, st.floats(0.01, 3))
def test_how_a_sensor_is_mounted_only_turns_its_channels(mounting, axis, angle):
    moved = exponential(angle * axis)
    rest, now = mounting, product(moved, mounting)
    vector = logarithm(product(inverse(rest), now))
    assert np.linalg.norm(vector) == pytest.approx(angle, abs=1e-9)
    np.testing.assert_allclose(vector, Rotation.from_quat(mounting).inv().apply(angle * axis), atol=1e-9)


@given(AXES, st.floats(0, 0.5), st.floats(-0.3, 0.3))
def test_a_vector_passes_pi_without_a_jump(axis, tilt, first):
    """A limb that turns by one and a half times pi about an axis that itself turns a little."""
    angles = np.linspace(first, 1.5 * math.pi, 400)
    across = np.cross(axis, np.roll(axis, 1) + np.array((0.3, -0.2, 0.1)))
    across /= max(np.linalg.norm(across), 1e-9)
    axes = np.cos(tilt * angles)[:, np.newaxis] * axis + np.sin(tilt * angles)[:, np.newaxis] * across
    true = angles[:, np.newaxis] * axes
    before, course = np.zeros(3), []
    for vector in logarithm(exponential(true)):
        before = nearest_vector(vector, before)
        course.append(before)
    np.testing.assert_allclose(course, true, atol=1e-7)


@given(QUATERNIONS, st.tuples(NUMBERS, NUMBERS, NUMBERS), st.floats(0, 6))
def test_the_nearest_vector_is_the_same_rotation_and_none_is_nearer(q, before, length):
    before = length * np.array(before)
    vector = logarithm(q)
    nearest = nearest_vector(vector, before)
    assert is_one_rotation(exponential(nearest), exponential(vector)) or np.linalg.norm(vector) < 1e-6
    axis = vector / np.linalg.norm(vector) if np.linalg.norm(vector) > 0 else np.zeros(3)
    others = [nearest + math.tau * turns * axis for turns in (-1, 1)]
    assert all(np.linalg.norm(nearest - before) <= np.linalg.norm(other - before) + 1e-9 for other in others)


def test_many_turns_about_one_axis_are_counted_on():
    axis = np.array((0.36, 0.48, 0.8))
    before, angles = np.zeros(3), np.linspace(0, 6 * math.pi, 601)
    for angle in angles:
        before = nearest_vector(logarithm(exponential(angle * axis)), before)
    np.testing.assert_allclose(before, 6 * math.pi * axis, atol=1e-9)


@given(QUATERNIONS, st.integers(0, 1000))
def test_the_mean_of_an_orientation_with_noise_is_that_orientation_whatever_the_signs(q, seed):
    rng = np.random.default_rng(seed)
    noise = rng.normal(0, 0.01, (200, 3))
    noisy = product(q, exponential(np.concatenate((noise, -noise)))) * rng.choice([-1.0, 1.0], (400, 1))
    assert angle_between(mean_orientation(noisy), q) < 1e-4


@pytest.mark.parametrize("rate_deg", [0.0, 1.0, 2.5, 20.0])
def test_drift_is_told_from_movements_there_and_back(rate_deg):
    rng = np.random.default_rng(3)
    t = np.arange(21) * STEP
    yaw = np.outer(np.radians(rate_deg) * t, (0.0, 0.0, 1.0))
    strokes = np.outer(1.2 * np.sin(math.tau * t / 2.0 + 0.3) ** 8, (0.0, 1.0, 0.0))  # a stroke every second
    still = exponential(yaw + rng.normal(0, 1e-3, (21, 3)))
    assert math.degrees(drift_rate(still, STEP)) == pytest.approx(rate_deg, abs=0.3)
    moving = product(exponential(yaw), exponential(strokes))
    assert math.degrees(drift_rate(moving, STEP)) == pytest.approx(rate_deg, rel=0.05, abs=0.3)
    assert (drift_rate(still, STEP) > DRIFT_LIMIT) == (rate_deg > 2.0)


@given(st.tuples(*[st.floats() for _ in range(4)]))
def test_a_quaternion_is_taken_only_when_it_is_one(numbers):
    q = unit_quaternion(*numbers)
    with np.errstate(over="ignore", invalid="ignore"):
        length = np.linalg.norm(np.array(numbers))
    if q is None:
        assert not 0.951 < length < 1.049
    else:
        assert np.linalg.norm(q) == pytest.approx(1.0, abs=1e-12)
        assert 0.949 < length < 1.051
