"""The meshes of walls and skirting."""

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, merged, rectangle, standing_box
from app.scene.meshes.paint import Numbers, PaintedPart, joined, painted
from app.scene.meshes.wall_shade import REACH, Pieces, corner_shade
from app.world.floorplan import FloorPlan

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
