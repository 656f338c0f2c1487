"""The meshes of what stands still in a floor plan: walls, doors, ceiling, furniture, marks, ground."""

import math
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, Part, merged, quads, rectangle
from app.scene.meshes.doors import doors_part
from app.scene.meshes.furniture import ModelOf, furniture, no_model
from app.scene.meshes.paint import Numbers, PaintedPart, joined, painted
from app.scene.meshes.palette import Colour
from app.scene.meshes.wall_shade import Pieces, corner_shade
from app.scene.meshes.walls import skirting_part, walls_part
from app.scene.task_marks import gap_parts
from app.world.floorplan import FloorPlan
from app.world.scenery import Dune

BuildingParts = dict[str, Part | PaintedPart]
Bounds = tuple[float, float, float, float]

FURNITURE: Final = "furniture_"  # prefix of the names of its parts
WALLS: Final = "walls"  # name of the part that may be cut at a height
OVERHEAD: Final = "overhead"  # name of the part that hides the way from above: ceiling, lamps, door frames

# Of the ground: the driven surface, and the land around it up to the horizon.
MARGIN: Final = 0.6  # m of floor outside the outer walls
AROUND: Final = 3.0  # m of open ground around the plan, when the plan gives no area
SEAM: Final = 2.5  # m between the seams of asphalt; seams, as ripples and tufts, make speed visible
RIPPLE: Final = 0.6  # m between the crests of sand
TUFTS: Final = 1.0  # per square metre
MOST_TUFTS: Final = 1500
MOST_CRESTS: Final = 120
EDGE: Final = 0.1  # m, width of the line around the driven surface
FAR: Final = (0.0, 20.0, 32.0, 48.0, 70.0, 100.0, 145.0, 210.0, 400.0)  # m from it; paler at each
DUNE_RINGS, DUNE_SIDES = 8, 24

# Heights (m) above the floor, far enough apart not to flicker in the view from the top.
TILES_AT: Final = 0.006
EDGE_AT: Final = 0.01

# Of a hall, all of known sizes, so that distances can be judged.
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


def ground_bounds(plan: FloorPlan) -> Bounds:
    """Return the bounds of the driven surface, m; a hall's floor reaches a little out of its walls."""
    if plan.ground.kind == "hall":
        return _grown(plan.ground.area or plan.bounds, MARGIN)
    return plan.ground.area or _grown(plan.bounds, AROUND)


def ground_parts(plan: FloorPlan) -> dict[str, Part]:
    """Return the parts of open ground, the largest last: parts that may hide them are drawn before.

    Raises
    ------
    ValueError
        For the floor of a hall, which `floor_part` returns.
    """
    bounds = ground_bounds(plan)
    match plan.ground.kind:
        case "hall":
            raise ValueError("a hall has a floor, and no open ground")
        case "sand":
            detail, near, land = Part(_ripples(bounds), palette.SAND_RIPPLE), palette.SAND, palette.SAND
        case "grass":
            detail, near, land = Part(_tufts(bounds), palette.GRASS_TUFT), palette.GRASS, palette.GRASS_TUFT
        case "asphalt":
            detail, near, land = Part(_seams(bounds), palette.ASPHALT_SEAM), palette.ASPHALT, palette.VERGE
    outside = {
        f"land_{number}": Part(_frame(bounds, inner, outer), _paler(land, number / (len(FAR) - 1)))
        for number, (inner, outer) in enumerate(pairwise(FAR))
    }
    dunes = {"dunes": Part(merged(map(_dune, plan.ground.dunes)), land)} if plan.ground.dunes else {}
    edge = Part(_frame(bounds, -EDGE, 0.0).moved(z=EDGE_AT), detail.colour)
    floor = rectangle(*bounds, 0.0)
    return dunes | {"ground_detail": detail, "ground_edge": edge, "ground": Part(floor, near)} | outside


def _seams(bounds: Bounds) -> Mesh:
    """Return the seams between the fields of asphalt."""
    x_min, y_min, x_max, y_max = bounds
    half = 0.015
    x, y = np.arange(x_min + SEAM, x_max, SEAM), np.arange(y_min + SEAM, y_max, SEAM)
    along = _flat(x - half, np.full_like(x, y_min), x + half, np.full_like(x, y_max))
    across = _flat(np.full_like(y, x_min), y - half, np.full_like(y, x_max), y + half)
    return merged([along, across])


def _tufts(bounds: Bounds) -> Mesh:
    """Return patches of darker grass."""
    x_min, y_min, x_max, y_max = bounds
    rng = np.random.default_rng(3)
    count = min(round(TUFTS * (x_max - x_min) * (y_max - y_min)), MOST_TUFTS)
    sides = 7
    turns = np.linspace(0.0, math.tau, sides, endpoint=False)
    reach = rng.uniform(0.08, 0.28, (count, 1)) * rng.uniform(0.6, 1.0, (count, sides))
    x = np.clip(rng.uniform(x_min, x_max, (count, 1)) + reach * np.cos(turns), x_min, x_max)
    y = np.clip(rng.uniform(y_min, y_max, (count, 1)) + 0.7 * reach * np.sin(turns), y_min, y_max)
    points = np.stack([x, y, np.full_like(x, TILES_AT)], axis=-1).reshape(-1, 3)
    fan = np.array([[0, k, k + 1] for k in range(1, sides - 1)])
    return Mesh(points, (sides * np.arange(count)[:, np.newaxis, np.newaxis] + fan).reshape(-1, 3))


def _ripples(bounds: Bounds) -> Mesh:
    """Return the lee sides of low sand ripples: wavy bands whose width varies along their length."""
    x_min, y_min, x_max, y_max = bounds
    rng = np.random.default_rng(5)
    step = max(RIPPLE, (x_max - x_min) / MOST_CRESTS)
    y = np.linspace(y_min, y_max, max(2, min(round((y_max - y_min) / 0.4), 80)))
    bands = []
    for crest in np.arange(x_min, x_max, step):
        bend, swell = rng.uniform(0, math.tau, 2)
        middle = crest + 0.22 * step * np.sin(0.9 * y + bend) + 0.5 * np.sin(0.25 * y)
        half = 0.2 * step * np.maximum(0.0, 0.25 + np.sin(0.7 * y + swell) * np.cos(0.31 * y - swell))
        left, right = (np.clip(side, x_min, x_max) for side in (middle - half, middle + half))
        is_visible = (left[:-1] < right[:-1]) | (left[1:] < right[1:])
        z = np.full(len(y), TILES_AT)
        a, b = np.stack([left, y, z], axis=-1), np.stack([right, y, z], axis=-1)
        bands.append(quads(np.stack([a[:-1], b[:-1], b[1:], a[1:]], axis=1)[is_visible]))
    return merged(bands)


def _dune(dune: Dune) -> Mesh:
    """Return a hill with a flat foot."""
    out = np.linspace(0.0, 1.0, DUNE_RINGS + 1)[1:]
    turns = np.linspace(0.0, math.tau, DUNE_SIDES, endpoint=False)
    height = dune.height * np.cos(out * math.pi / 2) ** 2
    x = dune.radius * np.outer(out, np.cos(turns)) + dune.position[0]
    y = dune.radius * np.outer(out, np.sin(turns)) + dune.position[1]
    z = np.broadcast_to(height[:, np.newaxis], x.shape)
    top = np.array([[*dune.position, dune.height]])
    points = np.concatenate([top, np.stack([x, y, z], axis=-1).reshape(-1, 3)])
    side = np.arange(DUNE_SIDES)
    next_side = (side + 1) % DUNE_SIDES
    faces = [np.stack([np.zeros_like(side), 1 + side, 1 + next_side], axis=1)]
    for ring in range(DUNE_RINGS - 1):
        inner, outer = 1 + ring * DUNE_SIDES, 1 + (ring + 1) * DUNE_SIDES
        faces.append(np.stack([inner + side, outer + side, outer + next_side], axis=1))
        faces.append(np.stack([inner + side, outer + next_side, inner + next_side], axis=1))
    return Mesh(points, np.concatenate(faces))


def _frame(bounds: Bounds, inner: float, outer: float) -> Mesh:
    """Return the frame between `inner` and `outer` metres outside of `bounds`."""
    a, b, c, d = _grown(bounds, inner)
    e, f, g, h = _grown(bounds, outer)
    return merged(rectangle(*side, 0.0) for side in ((e, f, g, b), (e, d, g, h), (e, b, a, d), (c, b, g, d)))


def _flat(
    x: NDArray[np.float64], y: NDArray[np.float64], x_end: NDArray[np.float64], y_end: NDArray[np.float64]
) -> Mesh:
    """Return horizontal rectangles just above the floor; (n,) each."""
    z = np.full(len(x), TILES_AT)
    corners = [(x, y, z), (x_end, y, z), (x_end, y_end, z), (x, y_end, z)]
    return quads(np.stack([np.stack(corner, axis=-1) for corner in corners], axis=1))


def _grown(bounds: Bounds, by: float) -> Bounds:
    x_min, y_min, x_max, y_max = bounds
    return x_min - by, y_min - by, x_max + by, y_max + by


def _paler(colour: Colour, share: float) -> Colour:
    red, green, blue = (round(a + share * (b - a)) for a, b in zip(colour, palette.HORIZON, strict=True))
    return red, green, blue


def building_parts(plan: FloorPlan, model_of: ModelOf = no_model) -> BuildingParts:
    """Return the parts of walls, doors, ceiling, furniture, marks and ground, in the order in which they are drawn.

    Parts that hide much come first, so that few pixels are painted twice: on a tablet, pixels cost more time than
    triangles.
    """
    standing = sorted(furniture(plan.obstacles, model_of).items())
    pieces = {f"{FURNITURE}{'_'.join(map(str, colour))}": Part(mesh, colour) for colour, mesh in standing}
    return _wall_parts(plan) | _overhead_parts(plan) | pieces | gap_parts(plan.gaps) | _floor_parts(plan)


def _wall_parts(plan: FloorPlan) -> BuildingParts:
    return {WALLS: walls_part(plan, has_ceiling(plan))} if plan.walls else {}


def _overhead_parts(plan: FloorPlan) -> BuildingParts:
    parts = []
    if plan.doors:
        parts.append(doors_part(plan, has_ceiling(plan)))
    if has_ceiling(plan):
        parts.append(ceiling_part(plan, ground_bounds(plan)))
    return {OVERHEAD: joined(parts)} if parts else {}


def _floor_parts(plan: FloorPlan) -> BuildingParts:
    """Return the floor of a hall, or open ground, and the skirting of the walls on it."""
    skirting = [skirting_part(plan)] if plan.walls else []
    if plan.ground.kind == "hall":
        return {"floor": joined([*skirting, floor_part(plan, ground_bounds(plan))])}
    return ({"skirting": joined(skirting)} if skirting else {}) | ground_parts(plan)
