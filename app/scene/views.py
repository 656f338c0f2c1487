"""Where one looks from. The camera never moves: the world is moved in front of it.

A camera looks along x, its left is y, its up is z, as a chair's. The node `/world` gets the inverse of the camera's
pose in the plan; a point of the plan then appears where a camera in that pose would see it.
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
NEAREST: Final[dict[View, float]] = {  # m: as far as nothing comes nearer, so that depths far away can be told apart
    "eye": 0.1,
    "chase": 0.4,
    "top": 1.0,
    "free": 0.4,
}

EYE_BACK = 0.05  # m behind the middle of the wheels
EYE_HEIGHT = 1.2  # m, of somebody who sits
EYE_DOWN = math.radians(9)
CHASE_BACK = 3.3  # m
CHASE_HEIGHT = 2.9  # m
CHASE_DOWN = math.radians(31)
TOP_MARGIN = 1.22  # of the plan's size: the page lays its cards over the rim of the picture
FREE_UP = math.radians(35)
WIDE = 4 / 3  # a narrower picture is looked at from farther away
LOWEST = 0.3  # m: a free camera stays above the floor


class Placement(NamedTuple):
    """Turn and place of a node: unit quaternion (w, x, y, z), and metres."""

    wxyz: Quaternion
    position: tuple[float, float, float]


class Camera(NamedTuple):
    """A camera's pose in the plan: place (m), then its angles (rad) as those of a head."""

    x: float
    y: float
    z: float
    yaw: float  # from x, left positive
    pitch: float  # up positive
    roll: float = 0.0  # towards its right side positive


class EyeSettings(NamedTuple):
    """How the patient's eye looks."""

    fov_deg: float = 68.0  # vertical
    eye_height: float = EYE_HEIGHT  # m
    roll_share: float = 0.0  # 0..1 of the head's roll
    head: bool = True  # whether the head tracker is followed


class Orbit(NamedTuple):
    """A free camera: it looks at a point on the floor, from a direction and a distance."""

    azimuth: float  # rad, of the camera as seen from the point, from x counter-clockwise
    elevation: float  # rad above the floor
    distance: float  # m
    x: float  # m, of the point
    y: float


def chair_placement(pose: Pose) -> Placement:
    """Return the placement of something that stands on the floor."""
    return Placement((math.cos(pose.theta / 2), 0.0, 0.0, math.sin(pose.theta / 2)), (pose.x, pose.y, 0.0))


def world_placement(camera: Camera) -> Placement:
    """Return the inverse of the camera's pose: where the world goes so that a camera at the origin sees the same.

    The camera's turn is R = Rz(yaw) Ry(-pitch) Rx(roll): a head that turns, then nods, then tilts.
    """
    w, x, y, z = _product(
        _product(_about(2, camera.yaw), _about(1, -camera.pitch)),
        _about(0, camera.roll),
    )
    inverse = (w, -x, -y, -z)
    return Placement(inverse, _turned(inverse, (-camera.x, -camera.y, -camera.z)))


def eye_camera(pose: Pose, head: Angles = AHEAD, height: float = EYE_HEIGHT) -> Camera:
    """Return the camera of the patient's eye: the chair's pose, and the head's angles in it."""
    x, y = pose.x - EYE_BACK * math.cos(pose.theta), pose.y - EYE_BACK * math.sin(pose.theta)
    return Camera(x, y, height, pose.theta + head.yaw, head.pitch - EYE_DOWN, head.roll)


def chase_camera(pose: Pose) -> Camera:
    """Return the camera that follows the chair."""
    x, y = pose.x - CHASE_BACK * math.cos(pose.theta), pose.y - CHASE_BACK * math.sin(pose.theta)
    return Camera(x, y, CHASE_HEIGHT, pose.theta, -CHASE_DOWN)


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
    return Camera((x_min + x_max) / 2, (y_min + y_max) / 2, height + wall_height, heading, -math.pi / 2)


def free_camera(orbit: Orbit) -> Camera:
    """Return the camera that looks at the orbit's point."""
    out = orbit.distance * math.cos(orbit.elevation)
    x, y = orbit.x + out * math.cos(orbit.azimuth), orbit.y + out * math.sin(orbit.azimuth)
    height = max(orbit.distance * math.sin(orbit.elevation), LOWEST)
    return Camera(x, y, height, orbit.azimuth + math.pi, -math.atan2(height, out))


def first_orbit(bounds: Bounds, start: Pose | None, aspect: float) -> Orbit:
    """Return a free camera that sees most of the plan, from behind the start; `aspect` is the picture's."""
    x_min, y_min, x_max, y_max = bounds
    distance = 0.7 * max(1.0, WIDE / aspect) * math.hypot(x_max - x_min, y_max - y_min) + 2.0
    azimuth = math.remainder((0.0 if start is None else start.theta) + math.pi, math.tau)
    return Orbit(azimuth, FREE_UP, min(distance, 100.0), (x_min + x_max) / 2, (y_min + y_max) / 2)


def _about(axis: int, angle: float) -> Quaternion:
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


def _turned(turn: Quaternion, point: tuple[float, float, float]) -> tuple[float, float, float]:
    w, x, y, z = turn
    _, *turned = _product(_product(turn, (0.0, *point)), (w, -x, -y, -z))
    return turned[0], turned[1], turned[2]
