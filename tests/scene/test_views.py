import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import Pose
from app.scene.views import (
    EYE_HEIGHT,
    FIELD_OF_VIEW,
    Camera,
    chair_placement,
    chase_camera,
    eye_camera,
    top_camera,
    world_placement,
)

metres = st.floats(-50, 50)
poses = st.builds(Pose, metres, metres, st.floats(-math.pi, math.pi))
cameras = st.builds(Camera, metres, metres, st.floats(0, 30), st.floats(-math.pi, math.pi), st.floats(-1.5, 1.5708))


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
    """Where a point of the plan is for a camera at the origin: x ahead, y left, z up."""
    placed = world_placement(camera)
    return rotation(placed.wxyz) @ np.array(point) + np.array(placed.position)


@given(cameras)
def test_the_camera_itself_lands_at_the_origin(camera):
    assert np.linalg.norm(world_placement(camera).wxyz) == pytest.approx(1.0)
    assert seen_from(camera, camera[:3]) == pytest.approx(np.zeros(3), abs=1e-9)


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


@given(
    st.tuples(metres, metres, st.floats(1, 60), st.floats(1, 60)),
    st.floats(0.4, 2.5),
    st.floats(0, 3),
)
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
