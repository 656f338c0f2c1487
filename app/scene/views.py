"""Where one looks from. The camera never moves: the world is moved in front of it.

A camera looks along x, its left is y, its up is z, as a chair's. The node `/world` gets the inverse of the camera's
pose in the plan; a point of the plan then appears where a camera in that pose would see it.
"""

import math
from typing import Final, Literal, NamedTuple, get_args

from app.geometry import Pose

View = Literal["eye", "chase", "top"]
VIEWS: Final[tuple[View, ...]] = get_args(View)

Bounds = tuple[float, float, float, float]

FIELD_OF_VIEW: Final[dict[View, float]] = {  # rad, vertical
    "eye": math.radians(68),
    "chase": math.radians(50),
    "top": math.radians(30),  # narrow: walls hardly lean outwards
}

EYE_BACK = 0.05  # m behind the middle of the wheels
EYE_HEIGHT = 1.2  # m, of somebody who sits
EYE_DOWN = math.radians(9)
CHASE_BACK = 3.3  # m
CHASE_HEIGHT = 2.9  # m
CHASE_DOWN = math.radians(31)
TOP_MARGIN = 1.22  # of the plan's size: the page lays its cards over the rim of the picture


class Placement(NamedTuple):
    """Turn and place of a node: unit quaternion (w, x, y, z), and metres."""

    wxyz: tuple[float, float, float, float]
    position: tuple[float, float, float]


class Camera(NamedTuple):
    """A camera's pose in the plan: place (m), then heading and how far it looks down (rad)."""

    x: float
    y: float
    z: float
    heading: float
    down: float


def chair_placement(pose: Pose) -> Placement:
    """Return the placement of something that stands on the floor."""
    return Placement((math.cos(pose.theta / 2), 0.0, 0.0, math.sin(pose.theta / 2)), (pose.x, pose.y, 0.0))


def world_placement(camera: Camera) -> Placement:
    """Return the inverse of the camera's pose: where the world goes so that a camera at the origin sees the same."""
    # The camera turns by heading about z, then by `down` about its left axis: q = q_z q_y.
    cos_h, sin_h = math.cos(camera.heading / 2), math.sin(camera.heading / 2)
    cos_d, sin_d = math.cos(camera.down / 2), math.sin(camera.down / 2)
    inverse = (cos_h * cos_d, sin_h * sin_d, -cos_h * sin_d, -sin_h * cos_d)
    # Rows of the inverse rotation are the camera's axes in the plan.
    ch, sh, cd, sd = math.cos(camera.heading), math.sin(camera.heading), math.cos(camera.down), math.sin(camera.down)
    ahead = camera.x * ch * cd + camera.y * sh * cd - camera.z * sd
    left = -camera.x * sh + camera.y * ch
    up = camera.x * ch * sd + camera.y * sh * sd + camera.z * cd
    return Placement(inverse, (-ahead, -left, -up))


def eye_camera(pose: Pose) -> Camera:
    """Return the camera of the patient's eye."""
    return _behind(pose, EYE_BACK, EYE_HEIGHT, EYE_DOWN)


def chase_camera(pose: Pose) -> Camera:
    """Return the camera that follows the chair."""
    return _behind(pose, CHASE_BACK, CHASE_HEIGHT, CHASE_DOWN)


def top_camera(bounds: Bounds, aspect: float, wall_height: float = 0.0) -> Camera:
    """Return the lowest camera above the middle of the plan that sees all of it.

    Parameters
    ----------
    bounds
        Of the plan: x_min, y_min, x_max, y_max in m.
    aspect
        Width over height of the picture; a plan that fits better on its side is turned by a quarter.
    wall_height
        The plan fits at this height (m), where it is nearest to the camera.
    """
    x_min, y_min, x_max, y_max = bounds
    half_x, half_y = TOP_MARGIN * (x_max - x_min) / 2, TOP_MARGIN * (y_max - y_min) / 2
    slope = math.tan(FIELD_OF_VIEW["top"] / 2)
    upright = max(half_y / slope, half_x / (slope * aspect))  # y points up in the picture
    on_its_side = max(half_x / slope, half_y / (slope * aspect))  # x points up in the picture
    height, heading = min((upright, math.pi / 2), (on_its_side, 0.0))
    return Camera((x_min + x_max) / 2, (y_min + y_max) / 2, height + wall_height, heading, math.pi / 2)


def _behind(pose: Pose, back: float, height: float, down: float) -> Camera:
    return Camera(pose.x - back * math.cos(pose.theta), pose.y - back * math.sin(pose.theta), height, pose.theta, down)
