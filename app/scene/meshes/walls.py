"""The meshes of walls, skirting and doors: frames, open leaves, and the wall above.

A leaf stands open, flat against the wall beside the door, where there is room. It is only drawn: the chair does not
collide with it. It stands out from the wall little further than a door frame.
"""

import math
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, box, merged, rectangle, standing_box
from app.scene.meshes.paint import Numbers, PaintedPart, joined, painted
from app.scene.meshes.wall_shade import REACH, Pieces, corner_shade
from app.world.clearance import Clearance, Points, nearest_on_segments
from app.world.floorplan import Door, FloorPlan

DOOR_HEIGHT: Final = 2.05  # m
FRAME_WIDTH: Final = 0.066  # m, of a door post inside the clear width, where it hides the wall's end
CASING: Final = 0.04  # m of a post beside the clear width, in front of the wall
FRAME_DEPTH: Final = 0.03  # m by which a frame stands out from the wall
SKIRTING_HEIGHT: Final = 0.1  # m
SKIRTING_DEPTH: Final = 0.012  # m
SKIRTING_END: Final = 0.004  # m beyond the wall's end, where a door post hides it
EDGE: Final = 0.4  # m from the floor, and from the ceiling, to where the light on a wall is whole
FOOT: Final = 0.72  # share of the light at the foot of a wall
UNDER_CEILING: Final = 0.7
BREAKS: Final = (0.0, 0.35 * REACH, REACH)  # m from a corner at which a wall's shade is computed
MOST_PIECES: Final = 1000  # of wall; a plan with more is drawn without dark corners of its walls
MOST_CONTACTS: Final = 20  # other pieces that end at one; beside more of them a piece is drawn without dark corners
TOP, AHEAD, BEHIND, LEFT, RIGHT = 0, 2, 3, 4, 5  # numbers of a box's faces

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


def walls_part(plan: FloorPlan, has_ceiling: bool) -> PaintedPart:
    """Return sides and tops of the walls; the sides are darker in corners, at the floor and under a ceiling."""
    pieces = Pieces(plan)
    heights, edges = _edge_shades(plan.wall_height, has_ceiling)
    sides: list[Mesh] = []
    shades: list[Numbers] = []
    ends, tops = [], []
    for number in range(len(pieces)):
        place = _place(pieces, number)
        length = _drawn_length(pieces, number)
        half, thick = length / 2, plan.wall_thickness / 2
        for side in (-1, 1):
            stations, corners = _corner_shades(pieces, number, side, half)
            sides.append(_upright(stations[::-side], side * thick, heights).moved(*place))
            shades.append(np.outer(edges, corners[::-side]).ravel())
        body = standing_box(length, plan.wall_thickness, 0.0, plan.wall_height)
        ends.append(_faces(body, (AHEAD, BEHIND)).moved(*place))
        tops.append(rectangle(-half, -thick, half, thick, plan.wall_height).moved(*place))
    return joined(
        [
            painted(merged(sides), palette.WALL, plan.lights, np.concatenate(shades)),
            painted(merged(ends), palette.WALL, plan.lights),
            painted(merged(tops), palette.WALL_TOP, plan.lights),
        ]
    )


def skirting_part(plan: FloorPlan) -> PaintedPart:
    """Return the dark boards at the foot of the walls."""
    pieces, wide = Pieces(plan), plan.wall_thickness + 2 * SKIRTING_DEPTH
    boards = [
        _faces(
            standing_box(_drawn_length(pieces, number) + 2 * SKIRTING_END, wide, 0.0, SKIRTING_HEIGHT),
            (TOP, AHEAD, BEHIND, LEFT, RIGHT),
        ).moved(*_place(pieces, number))
        for number in range(len(pieces))
    ]
    return painted(merged(boards), palette.SKIRTING, plan.lights)


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


def _place(pieces: Pieces, number: int) -> tuple[float, float, float, float]:
    """Return the middle of a piece (m), the floor's height, and its heading (rad)."""
    x, y = (pieces.start[number] + pieces.end[number]) / 2
    cos, sin = pieces.along[number]
    return float(x), float(y), 0.0, math.atan2(sin, cos)


def _drawn_length(pieces: Pieces, number: int) -> float:
    """Return the length (m) as drawn: it fills the corners, and ends inside an adjoining wall.

    It ends some millimetres behind the other wall's surface: nearer ones show through, because places on the screen
    are rounded.
    """
    return float(pieces.length[number]) + 0.92 * pieces.thickness


def _edge_shades(height: float, has_ceiling: bool) -> tuple[Numbers, Numbers]:
    """Return heights (m), the greatest first, and the share of the light at each of them."""
    edge = min(EDGE, height / 2)
    levels = [(0.0, FOOT), (edge, 1.0)]
    if has_ceiling:
        levels.append((height - edge, 1.0))
    levels.append((height, UNDER_CEILING if has_ceiling else 1.0))
    table = np.array(levels[::-1])
    return table[:, 0], table[:, 1]


def _corner_shades(pieces: Pieces, number: int, side: int, half: float) -> tuple[Numbers, Numbers]:
    """Return the places (m along a piece, from its middle, rising) at which its shade changes, and these shades."""
    ends_of_piece = np.array([-half, half])
    if len(pieces) > MOST_PIECES:
        return ends_of_piece, np.ones(2)
    middle = (pieces.start[number] + pieces.end[number]) / 2
    along = pieces.along[number]
    out = side * np.array([-along[1], along[0]])
    surface = pieces.thickness / 2
    # Ends of all pieces, (n, 2), as seen from this one: how far along it, and how far out from its surface.
    ends = [(corner - middle) for corner in (pieces.start, pieces.end)]
    far = np.stack([end @ along for end in ends], axis=1)
    off = np.stack([end @ out for end in ends], axis=1) - surface
    stands_out = off.max(axis=1) > 2 * surface + 0.05
    near = stands_out & (off.min(axis=1) < REACH)
    near &= (far.min(axis=1) < half + REACH + surface) & (far.max(axis=1) > -half - REACH - surface)
    if not 0 < np.count_nonzero(near) <= MOST_CONTACTS:
        return ends_of_piece, np.ones(2)
    contacts = far[near, np.argmin(off[near], axis=1)]
    breaks = np.array([sign * (surface + each) for each in BREAKS for sign in (-1, 1)])
    stations = np.clip((contacts[:, np.newaxis] + breaks).ravel(), -half, half)
    stations = np.unique(np.round(np.concatenate([ends_of_piece, stations]), 4))
    places = middle + stations[:, np.newaxis] * along + (surface + 0.02) * out
    return stations, corner_shade(pieces.distance(places, near))


def _upright(stations: Numbers, y: float, heights: Numbers) -> Mesh:
    """Return an upright surface at `y` through the places along x (m, columns) and heights (m, rows, falling)."""
    rows, columns = len(heights), len(stations)
    x, z = np.meshgrid(stations, heights)
    points = np.stack([x, np.full_like(x, y), z], axis=-1).reshape(-1, 3)
    numbers = np.arange(rows * columns).reshape(rows, columns)
    corner, below = numbers[:-1, :-1].ravel(), numbers[1:, :-1].ravel()
    across, right = numbers[1:, 1:].ravel(), numbers[:-1, 1:].ravel()
    faces = [np.stack([corner, below, across], axis=-1), np.stack([corner, across, right], axis=-1)]
    return Mesh(points, np.concatenate(faces))


def _faces(body: Mesh, numbers_of_faces: tuple[int, ...]) -> Mesh:
    """Return some faces of a box, with their vertices only."""
    numbers: NDArray[np.int64] = np.concatenate([4 * face + np.arange(4) for face in numbers_of_faces])
    first = 4 * np.arange(len(numbers_of_faces))[:, np.newaxis]
    faces = np.concatenate([first + np.array([0, 1, 2]), first + np.array([0, 2, 3])])
    return Mesh(body.vertices[numbers], faces)


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


def _leaf_offset(wall_thickness: float) -> float:
    """Return the distance (m) between the middle of the wall and the middle of a leaf."""
    return wall_thickness / 2 + LEAF_OFF_WALL + LEAF_THICKNESS / 2


def _leaf_line(door: Door, left: int, out: float) -> list[tuple[float, float]]:
    """Return both ends of a line beside a door, as long as its leaf and `out` m ahead of the middle of the wall."""
    cos, sin = math.cos(door.heading), math.sin(door.heading)
    x, y = door.position
    ends = [left * (door.width / 2 + LEAF_BESIDE), left * (door.width * 1.5 + LEAF_BESIDE)]
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
    out, inner = ahead * _leaf_offset(wall_thickness), door.width / 2 + LEAF_BESIDE
    leaf = standing_box(LEAF_THICKNESS, door.width, LEAF_OVER_FLOOR, height, out, left * (inner + door.width / 2))
    deep, wide, _ = HANDLE
    handle_x = out + ahead * (LEAF_THICKNESS + deep) / 2
    handle_y = left * (inner + door.width - HANDLE_END - wide / 2)
    handle = box(HANDLE, (handle_x, handle_y, HANDLE_HEIGHT))
    place = {"x": door.position[0], "y": door.position[1], "heading": door.heading}
    return leaf.moved(**place), handle.moved(**place)
