import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import Pose
from app.scene.cameras import (
    EYE_DOWN,
    EYE_HEIGHT,
    FIELD_OF_VIEW,
    LOWEST,
    Camera,
    Orbit,
    chair_placement,
    chase_camera,
    eye_camera,
    first_orbit,
    free_camera,
    top_camera,
    world_placement,
)
from app.scene.head_view import Angles

metres = st.floats(-50, 50)
poses = st.builds(Pose, metres, metres, st.floats(-math.pi, math.pi))
angles = st.floats(-math.pi, math.pi)
cameras = st.builds(Camera, metres, metres, st.floats(0, 30), angles, st.floats(-1.5708, 1.5), angles)


def rotation(wxyz):
    w, x, y, z = wxyz
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def seen_from(camera, point):
    """Return where a point of the plan is for a camera at the origin: x ahead, y left, z up."""
    placed = world_placement(camera)
    return rotation(placed.wxyz) @ np.array(point) + np.array(placed.position)


@given(cameras)
def test_the_camera_itself_lands_at_the_origin(camera):
    assert np.linalg.norm(world_placement(camera).wxyz) == pytest.approx(1.0)
    assert seen_from(camera, camera[:3]) == pytest.approx(np.zeros(3), abs=1e-9)


def about_x(angle):
    return np.array([[1, 0, 0], [0, math.cos(angle), -math.sin(angle)], [0, math.sin(angle), math.cos(angle)]])


def about_y(angle):
    return np.array([[math.cos(angle), 0, math.sin(angle)], [0, 1, 0], [-math.sin(angle), 0, math.cos(angle)]])


def about_z(angle):
    return np.array([[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]])


@given(cameras, st.tuples(metres, metres, metres))
def test_the_world_is_turned_by_the_inverse_of_turning_nodding_and_tilting(camera, point):
    turn = about_z(camera.yaw) @ about_y(-camera.pitch) @ about_x(camera.roll)
    assert rotation(world_placement(camera).wxyz) == pytest.approx(turn.T, abs=1e-12)
    assert seen_from(camera, point) == pytest.approx(turn.T @ (np.array(point) - camera[:3]), abs=1e-9)


@given(poses, st.floats(-1.7, 1.7), st.floats(-1.0, 1.0))
def test_a_head_that_turns_left_brings_what_is_left_into_the_middle(pose, yaw, pitch):
    eye = eye_camera(pose, Angles(yaw, pitch, 0.0))
    up = pitch - EYE_DOWN
    toward = np.array([math.cos(pose.theta + yaw), math.sin(pose.theta + yaw), math.tan(up)])
    seen = seen_from(eye, np.array(eye[:3]) + 3 * toward)
    assert seen[0] > 0
    assert seen[1:] == pytest.approx([0, 0], abs=1e-9)


def test_a_head_tilted_to_its_right_sees_the_floor_rise_on_the_right():
    eye = eye_camera(Pose(0, 0, 0), Angles(0.0, EYE_DOWN, 0.3))
    left, right = seen_from(eye, (5, 1, 1.2)), seen_from(eye, (5, -1, 1.2))
    assert right[2] > left[2]


@given(st.builds(Orbit, angles, st.floats(0.1, 1.57), st.floats(1, 100), metres, metres))
def test_a_free_camera_looks_at_its_point_from_above_the_floor(orbit):
    camera = free_camera(orbit)
    assert camera.z >= LOWEST - 1e-9
    seen = seen_from(camera, (orbit.x, orbit.y, 0.0))
    assert seen[1:] == pytest.approx([0, 0], abs=1e-6)
    assert seen[0] == pytest.approx(max(orbit.distance, seen[0]), rel=1e-6)


@given(st.tuples(metres, metres, st.floats(1, 40), st.floats(1, 40)), poses)
def test_the_first_free_picture_has_the_plan_in_it(size, start):
    x, y, width, depth = size
    bounds = (x, y, x + width, y + depth)
    orbit = first_orbit(bounds, start, 1.5)
    assert first_orbit(bounds, start, 0.75).distance >= orbit.distance
    seen = seen_from(free_camera(orbit), (x + width / 2, y + depth / 2, 0))
    assert seen[0] > 0.5 * math.hypot(width, depth)
    assert math.cos(orbit.azimuth) == pytest.approx(-math.cos(start.theta))


@given(poses, st.floats(0.5, 20), st.floats(-5, 5))
def test_a_point_ahead_of_the_chair_is_ahead_and_one_on_its_left_is_left(pose, ahead, left):
    turned = rotation(chair_placement(pose).wxyz)
    place = turned @ np.array([ahead, left, EYE_HEIGHT]) + np.array(chair_placement(pose).position)
    seen = seen_from(eye_camera(pose), place)
    assert seen[0] > 0
    assert seen[1] == pytest.approx(left, abs=1e-9)
    assert seen[2] > 0  # the eye looks down: what is as high as the eye is in the upper half


@given(poses)
def test_the_chair_is_in_the_lower_half_of_the_chasing_picture_and_inside_it(pose):
    seen = seen_from(chase_camera(pose), (pose.x, pose.y, 0.3))
    assert seen[0] > 1
    assert abs(seen[1]) < 1e-9
    assert -math.tan(FIELD_OF_VIEW["chase"] / 2) < seen[2] / seen[0] < 0


@given(st.tuples(metres, metres, st.floats(1, 60), st.floats(1, 60)), st.floats(0.4, 2.5), st.floats(0, 3))
def test_the_whole_plan_fits_from_above_and_fills_one_side(size, aspect, wall_height):
    x, y, width, depth = size
    bounds = (x, y, x + width, y + depth)
    camera = top_camera(bounds, aspect, wall_height)
    slope = math.tan(FIELD_OF_VIEW["top"] / 2)
    corners = [seen_from(camera, (a, b, wall_height)) for a in bounds[::2] for b in bounds[1::2]]
    across = max(abs(corner[1]) / (corner[0] * slope * aspect) for corner in corners)
    up = max(abs(corner[2]) / (corner[0] * slope) for corner in corners)
    assert max(across, up) <= 1.0
    assert max(across, up) > 0.8


def test_a_long_plan_is_turned_in_an_upright_picture():
    upright, wide = top_camera((0, 0, 20, 10), 0.7), top_camera((0, 0, 20, 10), 1.4)
    assert seen_from(upright, (20, 5, 0))[2] > 1  # x points up
    assert seen_from(wide, (20, 5, 0))[1] < -1  # x points right
