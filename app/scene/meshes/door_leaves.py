"""The leaves of the doors: open, flat against the wall beside the door, where there is room for them.

A leaf is only drawn: the chair does not collide with it. It stands out from the wall little further than a door frame.
"""

import math
from itertools import pairwise
from typing import Final

import numpy as np

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, box, merged, standing_box
from app.scene.meshes.paint import PaintedPart, joined, painted
from app.world.clearance import Clearance, Points, nearest_on_segments
from app.world.floorplan import Door, FloorPlan

THICKNESS: Final = 0.04  # m
OFF_WALL: Final = 0.03  # m between the wall and the leaf
BESIDE: Final = 0.05  # m between the clear width and the leaf: the door post is there
OVER_FLOOR: Final = 0.01  # m
FREE_WAY: Final = 0.42  # m between a leaf and every path: the half of a chair, and some room
HANDLE: Final = (0.05, 0.13, 0.025)  # m, out from the leaf, along it, upwards
HANDLE_HEIGHT: Final = 1.05  # m
HANDLE_END: Final = 0.06  # m from the free edge of the leaf
FIT: Final = 1e-6  # m


def leaves_part(plan: FloorPlan, height: float) -> PaintedPart | None:
    """Return the leaves of a plan's doors, `height` m high, with their handles; None where no door has room for one."""
    walls = np.array([(*a, *b) for wall in plan.walls for a, b in pairwise(wall)], dtype=np.float64).reshape(-1, 4)
    solid = Clearance(plan.walls, plan.wall_thickness, plan.obstacles)
    leaves, handles = [], []
    for door in plan.doors:
        sides = _free_sides(door, plan, walls, solid)
        if sides:
            leaf, handle = _leaf(door, plan.wall_thickness, height, *sides)
            leaves.append(leaf)
            handles.append(handle)
    if not leaves:
        return None
    return joined(
        [
            painted(merged(leaves), palette.DOOR_LEAF, plan.lights),
            painted(merged(handles), palette.DOOR_HANDLE, plan.lights),
        ]
    )


def _free_sides(door: Door, plan: FloorPlan, walls: Points, solid: Clearance) -> tuple[int, int] | None:
    """Return on which side of the wall, and of the door, the leaf is furthest from all paths; None where none is free.

    The first is 1 ahead of the door, along its way through, and -1 behind it; the second is 1 on the left of that way.
    """
    found = []
    for ahead in (-1, 1):
        for left in (1, -1):
            line = _line(door, left, ahead * _middle(plan.wall_thickness))
            if not _is_in_wall(_line(door, left, 0.0), walls, plan.wall_thickness):
                continue
            if solid.along(line).distance < OFF_WALL + THICKNESS / 2 - FIT:
                continue
            leaf = Clearance([line], THICKNESS, ())
            way = min(leaf.along(path.points).distance for path in plan.paths)
            if way >= FREE_WAY:
                found.append((way, ahead, left))
    return max(found)[1:] if found else None


def _middle(wall_thickness: float) -> float:
    """Return the distance (m) between the middle of the wall and the middle of a leaf."""
    return wall_thickness / 2 + OFF_WALL + THICKNESS / 2


def _line(door: Door, left: int, out: float) -> list[tuple[float, float]]:
    """Return both ends of a line beside a door, as long as its leaf and `out` m ahead of the middle of the wall."""
    cos, sin = math.cos(door.heading), math.sin(door.heading)
    x, y = door.position
    ends = [left * (door.width / 2 + BESIDE), left * (door.width * 1.5 + BESIDE)]
    return [(x + out * cos - end * sin, y + out * sin + end * cos) for end in ends]


def _is_in_wall(line: list[tuple[float, float]], walls: Points, thickness: float) -> bool:
    """Return whether one wall runs along the whole line: else an opening or the next door is behind a leaf there."""
    inside = np.ones(len(walls), dtype=np.bool_)
    for end in line:
        away = nearest_on_segments(np.broadcast_to(end, (len(walls), 2)), walls) - end
        inside &= np.hypot(away[:, 0], away[:, 1]) < thickness / 2
    return bool(inside.any())


def _leaf(door: Door, wall_thickness: float, height: float, ahead: int, left: int) -> tuple[Mesh, Mesh]:
    """Return a leaf and its handle."""
    out, inner = ahead * _middle(wall_thickness), door.width / 2 + BESIDE
    leaf = standing_box(THICKNESS, door.width, OVER_FLOOR, height, out, left * (inner + door.width / 2))
    deep, wide, _ = HANDLE
    handle_x = out + ahead * (THICKNESS + deep) / 2
    handle_y = left * (inner + door.width - HANDLE_END - wide / 2)
    handle = box(HANDLE, (handle_x, handle_y, HANDLE_HEIGHT))
    place = {"x": door.position[0], "y": door.position[1], "heading": door.heading}
    return leaf.moved(**place), handle.moved(**place)
