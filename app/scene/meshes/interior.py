"""The floor tiles of a hall, its ceiling and its lamps, all of known sizes, so that distances can be judged."""

import math
from typing import Final

import numpy as np

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, quads
from app.scene.meshes.paint import Numbers, PaintedPart, joined, painted
from app.scene.meshes.wall_shade import Pieces, corner_shade
from app.world.floorplan import FloorPlan

Bounds = tuple[float, float, float, float]

TILE: Final = 0.5  # m; in very large plans a multiple of it
MOST_TILES: Final = 4000
CEILING_CELL: Final = 1.0  # m between the points at which the ceiling's shade is computed
MOST_CELLS: Final = 2500
LOWEST_CEILING: Final = 2.0  # m; lower walls are partitions, and the ceiling would be near the eyes
LAMP: Final = 0.6  # m, side of a lamp
LAMP_CELL: Final = 2.4  # m; one lamp in each square of this size, where there is room
MOST_LAMPS: Final = 400
LAMP_ROOM: Final = LAMP / 2 + 0.05  # m from a lamp's middle to the nearest wall, at least
LAMP_PLACES: Final = 5  # places tried along each side of a square
LAMP_DEPTH: Final = 0.012  # m by which a lamp hangs below the ceiling


def has_ceiling(plan: FloorPlan) -> bool:
    """Return whether a plan is a room under a ceiling: it has the floor of a hall, and walls as high as a room."""
    return plan.ground.kind == "hall" and bool(plan.walls) and plan.wall_height >= LOWEST_CEILING


def floor_part(plan: FloorPlan, bounds: Bounds) -> PaintedPart:
    """Return a chequered floor, whose lines lie at multiples of the tile's side; darker along the walls."""
    x, y, tile = _lines(bounds, TILE, MOST_TILES)
    column, row = np.meshgrid(np.arange(len(x) - 1), np.arange(len(y) - 1), indexing="ij")
    # Every tile has corners of its own, because its neighbours have another colour.
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    across = np.stack([x[column + right] for right, _ in corners], axis=-1).reshape(-1, 4)
    up = np.stack([y[row + above] for _, above in corners], axis=-1).reshape(-1, 4)
    tiles = np.stack([across, up, np.zeros_like(across)], axis=-1)
    shade = _shade(plan, tiles[..., :2].reshape(-1, 2)).reshape(-1, 4)
    # The tile whose corner is the plan's origin is light, wherever the floor begins.
    first = math.floor(x[0] / tile) + math.floor(y[0] / tile)
    is_dark = ((column + row + first) % 2 == 1).ravel()
    return joined(
        painted(quads(tiles[chosen]), colour, plan.lights, shade[chosen].ravel())
        for chosen, colour in ((~is_dark, palette.FLOOR_TILE), (is_dark, palette.FLOOR))
    )


def ceiling_part(plan: FloorPlan, bounds: Bounds) -> PaintedPart:
    """Return the ceiling with its lamps; it is seen from below only."""
    x, y, _ = _lines(bounds, CEILING_CELL, MOST_CELLS)
    points = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    numbers = np.arange(len(points)).reshape(len(x), len(y))
    corner, right = numbers[:-1, :-1].ravel(), numbers[1:, :-1].ravel()
    across, above = numbers[1:, 1:].ravel(), numbers[:-1, 1:].ravel()
    faces = np.concatenate([np.stack([corner, across, right], axis=-1), np.stack([corner, above, across], axis=-1)])
    mesh = Mesh(np.column_stack([points, np.full(len(points), plan.wall_height)]), faces)
    ceiling = painted(mesh, palette.CEILING, plan.lights, _shade(plan, points))
    return joined([ceiling, painted(_lamps(plan, bounds), palette.LAMP, plan.lights)])


def _lamps(plan: FloorPlan, bounds: Bounds) -> Mesh:
    """Return square lamps: in each cell of the ceiling one, at the place that is farthest from the walls."""
    x_min, y_min, x_max, y_max = bounds
    cell = max(LAMP_CELL, math.sqrt((x_max - x_min) * (y_max - y_min) / MOST_LAMPS))
    columns, rows = max(1, round((x_max - x_min) / cell)), max(1, round((y_max - y_min) / cell))
    shares = (np.arange(LAMP_PLACES) + 0.5) / LAMP_PLACES - 0.5
    aside = np.stack(np.meshgrid(shares, shares, indexing="ij"), axis=-1).reshape(-1, 2)
    aside *= ((x_max - x_min) / columns, (y_max - y_min) / rows)
    middles = np.stack(
        np.meshgrid(
            x_min + (np.arange(columns) + 0.5) * (x_max - x_min) / columns,
            y_min + (np.arange(rows) + 0.5) * (y_max - y_min) / rows,
            indexing="ij",
        ),
        axis=-1,
    ).reshape(-1, 1, 2)
    places = middles + aside
    room = Pieces(plan).distance(places.reshape(-1, 2)).reshape(places.shape[:2])
    # Where there is equally much room, the place nearest to the cell's middle is taken.
    best = np.argmax(room - 1e-3 * np.hypot(*aside.T), axis=1)
    cells = np.arange(len(places))
    chosen = places[cells, best][room[cells, best] >= LAMP_ROOM]
    half = LAMP / 2
    square = np.array([(-half, -half), (-half, half), (half, half), (half, -half)])  # counter-clockwise from below
    corners = chosen[:, np.newaxis, :] + square
    return quads(np.dstack([corners, np.full(corners.shape[:2], plan.wall_height - LAMP_DEPTH)]))


def _shade(plan: FloorPlan, places: Numbers) -> Numbers:
    """Return the share of the light that reaches places (n, 2) of floor or ceiling."""
    return corner_shade(Pieces(plan).distance(places)) if plan.walls else np.ones(len(places))


def _lines(bounds: Bounds, step: float, most: int) -> tuple[Numbers, Numbers, float]:
    """Return the lines of a grid over `bounds` and their distance: `step` (m), a multiple of it when cells are many."""
    x_min, y_min, x_max, y_max = bounds
    step *= max(1, math.ceil(math.sqrt((x_max - x_min) * (y_max - y_min) / most) / step))
    return _multiples(x_min, x_max, step), _multiples(y_min, y_max, step), step


def _multiples(low: float, high: float, step: float) -> Numbers:
    """Return `low`, the multiples of `step` between, and `high`."""
    inner = step * np.arange(math.floor(low / step) + 1, math.ceil(high / step))
    return np.array([low, *inner, high])
