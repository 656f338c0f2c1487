"""The cameras of the views, and the placements of nodes that show what a camera would see.

viser's camera never moves; the world is moved in front of it. A camera looks along x, its left is y, its up is z, as a
chair's. The node `/world` gets the inverse of the camera's pose in the plan, so that each point of the plan appears
where a camera in that pose would see it.
"""

import math
from typing import Final, Literal, NamedTuple, get_args

from app.geometry import Pose
from app.scene.head_view import AHEAD, Angles

View = Literal["eye", "chase", "top", "free"]
VIEWS: Final[tuple[View, ...]] = get_args(View)

Bounds = tuple[float, float, float, float]
Quaternion = tuple[float, float, float, float]  # w, x, y, z

FIELD_OF_VIEW: Final[dict[View, float]] = {  # rad, vertical; the eye's can be set
    "eye": math.radians(68),
    "chase": math.radians(50),
    "top": math.radians(30),  # narrow: walls hardly lean outwards
    "free": math.radians(50),
}
NEAREST: Final[dict[View, float]] = {  # m, near plane; as far as possible: it limits the resolution of far depths
    "eye": 0.1,
    "chase": 0.4,
    "top": 1.0,
    "free": 0.4,
}

EYE_BACK = 0.05  # m behind the middle of the drive wheels
EYE_HEIGHT = 1.2  # m, of a sitting person
EYE_DOWN = math.radians(9)
CHASE_BACK = 3.3  # m
CHASE_HEIGHT = 2.9  # m
CHASE_DOWN = math.radians(31)
TOP_MARGIN = 1.22  # over the plan's size: cards of the page cover the rim of the picture
FREE_UP = math.radians(35)
WIDE = 4 / 3  # width over height; in a narrower picture the free camera stands farther away
LOWEST = 0.3  # m: a free camera stays above the floor


class Placement(NamedTuple):
    """Orientation and position of a node: unit quaternion (w, x, y, z), and metres."""

    wxyz: Quaternion
    position: tuple[float, float, float]


class Camera(NamedTuple):
    """A camera's pose in the plan: place (m) and angles (rad), with the signs of a head's angles."""

    x: float
    y: float
    z: float
    yaw: float  # from x, left positive
    pitch: float  # up positive
    roll: float = 0.0  # towards its right side positive


class EyeSettings(NamedTuple):
    """Settings of the eye's view."""

    fov_deg: float = 68.0  # vertical
    eye_height: float = EYE_HEIGHT  # m
    roll_share: float = 0.0  # 0..1 of the head's roll
    head: bool = True  # whether the head tracker is followed


class Orbit(NamedTuple):
    """A free camera, which looks at a point on the floor from a direction and a distance."""

    azimuth: float  # rad, of the camera as seen from the point, from x counter-clockwise
    elevation: float  # rad above the floor
    distance: float  # m
    x: float  # m, of the point
    y: float


def chair_placement(pose: Pose) -> Placement:
    """Return the placement of a body on the floor, such as the chair or a mover."""
    return Placement((math.cos(pose.theta / 2), 0.0, 0.0, math.sin(pose.theta / 2)), (pose.x, pose.y, 0.0))


def world_placement(camera: Camera) -> Placement:
    """Return the inverse of the camera's pose: with the world placed there, a camera at the origin sees its picture.

    The camera's rotation is R = Rz(yaw) Ry(-pitch) Rx(roll), in the order of a head that turns, nods and tilts.
    """
    w, x, y, z = _product(
        _product(_about(2, camera.yaw), _about(1, -camera.pitch)),
        _about(0, camera.roll),
    )
    inverse = (w, -x, -y, -z)
    return Placement(inverse, _rotated(inverse, (-camera.x, -camera.y, -camera.z)))


def eye_camera(pose: Pose, head: Angles = AHEAD, height: float = EYE_HEIGHT) -> Camera:
    """Return the camera of the patient's eye, from the chair's pose and the head's angles in the chair."""
    x, y = pose.x - EYE_BACK * math.cos(pose.theta), pose.y - EYE_BACK * math.sin(pose.theta)
    return Camera(x, y, height, pose.theta + head.yaw, head.pitch - EYE_DOWN, head.roll)


def chase_camera(pose: Pose) -> Camera:
    """Return the camera behind and above the chair."""
    x, y = pose.x - CHASE_BACK * math.cos(pose.theta), pose.y - CHASE_BACK * math.sin(pose.theta)
    return Camera(x, y, CHASE_HEIGHT, pose.theta, -CHASE_DOWN)


def top_camera(bounds: Bounds, aspect: float, wall_height: float = 0.0) -> Camera:
    """Return the lowest camera above the middle of the plan that sees the whole plan.

    Parameters
    ----------
    bounds
        Of the plan: x_min, y_min, x_max, y_max in m.
    aspect
        Width over height of the picture; the plan is turned by a quarter when it fits better so.
    wall_height
        Height (m) of the walls; the plan fits into the picture at this height.
    """
    x_min, y_min, x_max, y_max = bounds
    half_x, half_y = TOP_MARGIN * (x_max - x_min) / 2, TOP_MARGIN * (y_max - y_min) / 2
    slope = math.tan(FIELD_OF_VIEW["top"] / 2)
    upright = max(half_y / slope, half_x / (slope * aspect))  # y points up in the picture
    on_its_side = max(half_x / slope, half_y / (slope * aspect))  # x points up in the picture
    height, heading = min((upright, math.pi / 2), (on_its_side, 0.0))
    return Camera((x_min + x_max) / 2, (y_min + y_max) / 2, height + wall_height, heading, -math.pi / 2)


def free_camera(orbit: Orbit) -> Camera:
    """Return the camera of an orbit."""
    out = orbit.distance * math.cos(orbit.elevation)
    x, y = orbit.x + out * math.cos(orbit.azimuth), orbit.y + out * math.sin(orbit.azimuth)
    height = max(orbit.distance * math.sin(orbit.elevation), LOWEST)
    return Camera(x, y, height, orbit.azimuth + math.pi, -math.atan2(height, out))


def first_orbit(bounds: Bounds, start: Pose | None, aspect: float) -> Orbit:
    """Return a free camera that sees most of the plan from behind the start; `aspect` is width over height."""
    x_min, y_min, x_max, y_max = bounds
    distance = 0.7 * max(1.0, WIDE / aspect) * math.hypot(x_max - x_min, y_max - y_min) + 2.0
    azimuth = math.remainder((0.0 if start is None else start.theta) + math.pi, math.tau)
    return Orbit(azimuth, FREE_UP, min(distance, 100.0), (x_min + x_max) / 2, (y_min + y_max) / 2)


def _about(axis: int, angle: float) -> Quaternion:
    """Return the rotation by `angle` (rad) about the axis 0 (x), 1 (y) or 2 (z)."""
    sin = math.sin(angle / 2)
    return (math.cos(angle / 2), sin * (axis == 0), sin * (axis == 1), sin * (axis == 2))


def _product(a: Quaternion, b: Quaternion) -> Quaternion:
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


def _rotated(rotation: Quaternion, point: tuple[float, float, float]) -> tuple[float, float, float]:
    w, x, y, z = rotation
    _, *rotated = _product(_product(rotation, (0.0, *point)), (w, -x, -y, -z))
    return rotated[0], rotated[1], rotated[2]
