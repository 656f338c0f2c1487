"""The meshes of doors: frames, open leaves, and the wall above.

A leaf stands open, flat against the wall beside the door, where there is room. It is only drawn: the chair does not
collide with it. It stands out from the wall little further than a door frame.
"""

import math
from itertools import pairwise
from typing import Final

import numpy as np

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, box, merged, standing_box
from app.scene.meshes.paint import PaintedPart, joined, painted
from app.scene.meshes.walls import EDGE, UNDER_CEILING
from app.world.clearance import Clearance, Points, nearest_on_segments
from app.world.floorplan import Door, FloorPlan

DOOR_HEIGHT: Final = 2.05  # m
FRAME_WIDTH: Final = 0.066  # m, of a door post inside the clear width, where it hides the wall's end
CASING: Final = 0.04  # m of a post beside the clear width, in front of the wall
FRAME_DEPTH: Final = 0.03  # m by which a frame stands out from the wall

# Of the leaves of doors.
LEAF_THICKNESS: Final = 0.04  # m
LEAF_OFF_WALL: Final = 0.03  # m between the wall and the leaf
LEAF_BESIDE: Final = 0.05  # m between the clear width and the leaf: the door post is there
LEAF_OVER_FLOOR: Final = 0.01  # m
LEAF_CLEARANCE: Final = 0.42  # m between a leaf and every path: the half of a chair, and some room
HANDLE: Final = (0.05, 0.13, 0.025)  # m, out from the leaf, along it, upwards
HANDLE_HEIGHT: Final = 1.05  # m
HANDLE_END: Final = 0.06  # m from the free edge of the leaf
LEAF_FIT: Final = 1e-6  # m


def doors_part(plan: FloorPlan, has_ceiling: bool) -> PaintedPart:
    """Return the door frames with open leaves, and the wall above the doors."""
    frames = painted(merged(_frame(door, plan.wall_thickness) for door in plan.doors), palette.DOOR, plan.lights)
    leaves = leaves_part(plan, min(DOOR_HEIGHT, plan.wall_height) - FRAME_WIDTH)
    doors = frames if leaves is None else joined([frames, leaves])
    if plan.wall_height <= DOOR_HEIGHT:
        return doors
    above = merged(
        standing_box(plan.wall_thickness * 0.98, door.width, DOOR_HEIGHT, plan.wall_height).moved(
            *door.position, heading=door.heading
        )
        for door in plan.doors
    )
    shade = np.where((above.vertices[:, 2] > plan.wall_height - EDGE) & has_ceiling, UNDER_CEILING, 1.0)
    return joined([doors, painted(above, palette.WALL, plan.lights, shade)])


def _frame(door: Door, thickness: float) -> Mesh:
    """Return two posts and a head, which hide the ends of the walls and reach round them by CASING."""
    deep, half = thickness + 2 * FRAME_DEPTH, door.width / 2
    wide = FRAME_WIDTH + CASING
    middle = half - FRAME_WIDTH + wide / 2
    return merged(
        [
            standing_box(deep, wide, 0.0, DOOR_HEIGHT + CASING - wide, y=-middle),
            standing_box(deep, wide, 0.0, DOOR_HEIGHT + CASING - wide, y=middle),
            box((deep, door.width + 2 * CASING, wide), (0.0, 0.0, DOOR_HEIGHT + CASING - wide / 2)),
        ]
    ).moved(*door.position, heading=door.heading)


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
    free_sides = []
    for ahead in (-1, 1):
        for left in (1, -1):
            line = _leaf_line(door, left, ahead * _leaf_offset(plan.wall_thickness))
            if not _is_in_wall(_leaf_line(door, left, 0.0), walls, plan.wall_thickness):
                continue
            if solid.along(line).distance < LEAF_OFF_WALL + LEAF_THICKNESS / 2 - LEAF_FIT:
                continue
            leaf = Clearance([line], LEAF_THICKNESS, ())
            clearance = min(leaf.along(path.points).distance for path in plan.paths)
            if clearance >= LEAF_CLEARANCE:
                free_sides.append((clearance, ahead, left))
    return max(free_sides)[1:] if free_sides else None


def _leaf_width(door: Door) -> float:
    """Return the width (m) of a leaf: the clear width of its door."""
    return door.width


def _leaf_offset(wall_thickness: float) -> float:
    """Return the distance (m) between the middle of the wall and the middle of a leaf."""
    return wall_thickness / 2 + LEAF_OFF_WALL + LEAF_THICKNESS / 2


def _leaf_line(door: Door, left: int, out: float) -> list[tuple[float, float]]:
    """Return both ends of a line beside a door, as long as its leaf and `out` m ahead of the middle of the wall."""
    cos, sin = math.cos(door.heading), math.sin(door.heading)
    x, y = door.position
    inner = door.width / 2 + LEAF_BESIDE
    ends = [left * inner, left * (inner + _leaf_width(door))]
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
    out, inner, width = ahead * _leaf_offset(wall_thickness), door.width / 2 + LEAF_BESIDE, _leaf_width(door)
    leaf = standing_box(LEAF_THICKNESS, width, LEAF_OVER_FLOOR, height, out, left * (inner + width / 2))
    deep, wide, _ = HANDLE
    handle_x = out + ahead * (LEAF_THICKNESS + deep) / 2
    handle_y = left * (inner + width - HANDLE_END - wide / 2)
    handle = box(HANDLE, (handle_x, handle_y, HANDLE_HEIGHT))
    place = {"x": door.position[0], "y": door.position[1], "heading": door.heading}
    return leaf.moved(**place), handle.moved(**place)
