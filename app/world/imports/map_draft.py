"""Imports an occupancy map as a floor plan: walls around the free space, and a proposed path.

The walls are the outlines of a region of cells, simplified to few straight lines that never cut into the region.
"""

from pathlib import Path
from typing import Final, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.texts import Figure, Text
from app.world.floorplan import MAX_WALLS
from app.world.footprint import CHAIR_RADIUS
from app.world.imports.distances import grown, joined, wall_distances
from app.world.imports.draft import Draft, PlanDocument, path_document, plain_name
from app.world.imports.inside import Inside, inside_of_building
from app.world.imports.ros_map import OccupancyMap
from app.world.imports.route import Route, propose_route

WALL_THICKNESS: Final = 0.02  # m; small, because the outline is the surface of the walls
DECIMALS: Final = 4  # of a metre in the plan
FINE: Final = 0.04  # m that a simplified wall may lie behind the surface; one cell where cells are larger
NARROW: Final = (0.0, 0.1, 0.2, 2 * CHAIR_RADIUS - 0.04)  # m; no chair enters such spaces: closing them costs no place
COARSEST: Final = 0.2  # m per cell; in coarser cells doorways close
MOST_CORNERS: Final = 20 * MAX_WALLS  # of exact outlines, to be simplified: more do not become few enough
TOO_MANY: Final = 4 * MAX_WALLS  # pieces, which only coarser cells make few enough
KNOWN_SHARE: Final = 0.99  # share of known cells from which on a map is a drawing: its outside is as white as its rooms
OPEN_EDGE: Final = 0.5  # share of a map's edge that is free, from which on its outside is free
TOLERANCE: Final = 1.0  # cells by which the simplified outline may lie outside the exact one: the height of one step
SMALL: Final = 12  # cells of circumference, up to which an outline is not simplified

Corner = tuple[int, int]  # column, row of a cell's corner
Noun = Literal["map", "picture"]  # what the cells were made of


class _Walls(NamedTuple):
    """The outlines of a plan's region, and what was done to have few enough of them."""

    route: Route
    loops: list[list[Corner]]
    side: int  # cells of the map along one side of a cell of the region
    narrow: float  # m, width up to which narrow spaces were closed


def draft_of_map(
    occupancy: OccupancyMap,
    file: Path,
    title: str | None = None,
    name: str | None = None,
    noun: Noun = "map",
    *,
    outside: bool = False,
) -> Draft:
    """Return a floor plan made of an occupancy map.

    Only the free space connected with the proposed path is kept, and only the inside of a building unless `outside`;
    unknown cells count as walls. The walls lie in occupied or unknown cells, at most one cell behind the surface, never
    in free cells. A map with too many wall pieces is made simpler and then coarser. Sentences name what the cells were
    made of by `noun`.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    inside = Inside(occupancy.free, 0.0)
    if not outside and _has_open_edge(occupancy):
        building = inside_of_building(occupancy.free, occupancy.resolution)
        if building is None:
            raise ValueError(Text("plan-map-no-building", file=str(file), noun=noun))
        inside = building
    walls = _walls(inside.free, occupancy.resolution, file, noun)
    cell = OccupancyMap(walls.route.region, occupancy.resolution * walls.side, occupancy.origin)
    placed = [cell.place(np.array([*loop, loop[0]], dtype=np.float64)).round(DECIMALS).tolist() for loop in walls.loops]
    document: PlanDocument = {
        "name": name or plain_name(file.stem),
        "title": title or file.stem[:80],
        "walls": placed,
        "wall_thickness": WALL_THICKNESS,
        "paths": [path_document(cell.place(walls.route.cells).round(DECIMALS).tolist())],
    }
    sentences = [*_size_sentences(occupancy, walls, noun), *_change_sentences(occupancy, inside, walls)]
    return Draft(document, (*sentences, Text("plan-path-is-proposal")))


def _has_open_edge(occupancy: OccupancyMap) -> bool:
    """Return whether free cells at the edge are outside of a building.

    A scan ends where its robot saw nothing more, and its rooms may lie at its edge.
    """
    free = occupancy.free
    edge = np.concatenate([free[0], free[-1], free[1:-1, 0], free[1:-1, -1]])
    is_drawing = occupancy.unknown <= (1.0 - KNOWN_SHARE) * free.size
    return bool(edge.any() if is_drawing else edge.mean() > OPEN_EDGE)


def _walls(free: NDArray[np.bool_], resolution: float, file: Path, noun: Noun) -> _Walls:
    """Return outlines of at most MAX_WALLS pieces: of the cells as they are, without narrow spaces, or coarser."""
    side, least = 1, 0
    while side == 1 or resolution * side <= COARSEST:
        size = resolution * side
        route = propose_route(joined(free, side, beyond=False), size)
        if route is None:
            break
        for narrow in NARROW if side == 1 else NARROW[-1:]:
            region = _without_narrow_spaces(route.region, narrow / size)
            pieces = corner_count(region)
            if pieces <= MOST_CORNERS:
                loops = outlines(region, max(TOLERANCE, FINE / size))
                pieces = sum(map(len, loops))
            if pieces <= MAX_WALLS:
                return _Walls(Route(route.cells, region), loops, side, narrow)
            least = min(least or pieces, pieces)
            if pieces > TOO_MANY:
                break
        side *= 2
    if least:
        share = Figure(100 * MAX_WALLS / least)
        raise ValueError(
            Text("plan-map-walls-too-many", file=str(file), noun=noun, count=least, most=MAX_WALLS, share=share)
        )
    raise ValueError(Text("plan-map-too-narrow", file=str(file), noun=noun))


def _without_narrow_spaces(free: NDArray[np.bool_], width: float) -> NDArray[np.bool_]:
    """Return the free cells that a disc of a diameter (cells) covers where it fits."""
    if width == 0:
        return free
    return free & grown(wall_distances(free, width / 2 + 2.0) > width / 2, width / 2)


def _size_sentences(occupancy: OccupancyMap, walls: _Walls, noun: Noun) -> list[Text]:
    rows, columns = occupancy.free.shape
    area, cell = occupancy.resolution**2, occupancy.resolution * walls.side
    used_rows, used_columns = (np.flatnonzero(walls.route.region.any(axis=axis)) for axis in (1, 0))
    width, height = (float(used[-1] - used[0] + 1) * cell for used in (used_columns, used_rows))
    free = np.count_nonzero(walls.route.region) * cell**2
    sentences = [
        Text("plan-wall-pieces", count=sum(map(len, walls.loops))),
        Text(
            "plan-map-size",
            noun=noun,
            width=Figure(width, 1),
            height=Figure(height, 1),
            free=Figure(free, 1),
            whole_width=Figure(columns * occupancy.resolution, 1),
            whole_height=Figure(rows * occupancy.resolution, 1),
        ),
    ]
    if noun == "map":
        sentences.append(Text("plan-map-unknown", area=Figure(occupancy.unknown * area, 1)))
    return sentences


def _change_sentences(occupancy: OccupancyMap, inside: Inside, walls: _Walls) -> list[Text]:
    sentences = []
    if inside.opening > 0:
        sentences.append(Text("plan-map-open", width=Figure(inside.opening, 1)))
    if walls.narrow > 0:
        sentences.append(Text("plan-map-narrow-closed", width=Figure(walls.narrow, 1)))
    if walls.side > 1:
        size = Figure(occupancy.resolution * walls.side, 2)
        sentences.append(Text("plan-map-cells-joined", side=walls.side, size=size))
    return sentences


def outlines(region: NDArray[np.bool_], tolerance: float = TOLERANCE) -> list[list[Corner]]:
    """Return the simplified closed outlines of `region` (rows, columns), each without repeating its first corner.

    The region is on the left of every outline. Cells that meet only at a corner are separated, because nothing can pass
    there. `tolerance` (cells) is how far a simplified outline may lie outside the exact one.
    """
    return [_simplify(loop, tolerance) for loop in exact_outlines(region)]


def corner_count(region: NDArray[np.bool_]) -> int:
    """Return the number of corners of the exact outlines."""
    return sum(len(rows) for rows, _, _ in _corners(region))


def exact_outlines(region: NDArray[np.bool_]) -> list[list[Corner]]:
    """Return the exact outlines of `region`, each straight run as one edge.

    Every corner has one horizontal and one vertical edge. Along a line of the grid, corners are start and end of an
    edge in turn: their order gives the edges.
    """
    groups = _corners(region)
    if not groups:
        return []
    rows, columns, quadrants = (np.concatenate(parts) for parts in zip(*groups, strict=True))
    # Two corners may share a place: the one whose edge comes from below or from the left is sorted before the other.
    east, north = quadrants % 2, quadrants // 2
    across = _partners(np.lexsort((east, columns, rows)))
    upward = _partners(np.lexsort((north, rows, columns)))
    places = list(zip(columns.tolist(), rows.tolist(), strict=True))
    # The region lies on the left of an edge to the east when the cells above the edge belong to the region.
    above = _is_region_above(region, rows, columns, east).tolist()
    loops, unseen = [], [True] * len(places)
    for first in range(len(places)):
        # Begin with an edge that is followed along its direction, so that the region is on the left.
        if not unseen[first] or (places[across[first]] > places[first]) != above[first]:
            continue
        loop, corner = [], first
        while unseen[corner]:
            partner = across[corner]
            unseen[corner] = unseen[partner] = False
            loop += [places[corner], places[partner]]
            corner = upward[partner]
        loops.append(loop)
    return loops


def _corners(region: NDArray[np.bool_]) -> list[tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]]:
    """Return the corners of the outlines as rows, columns and quadrants, in groups of one quadrant.

    A corner's quadrant says where its two edges lead: 0 west and south, 1 east and south, 2 west and north, 3 east and
    north. Such a corner is convex when the cell in that quadrant is the only one of the two beside its edges' far sides
    that belongs to the region, or concave when it is the only one that does not.
    """
    padded = np.pad(region, 1)
    cells = padded[:-1, :-1], padded[:-1, 1:], padded[1:, :-1], padded[1:, 1:]  # south-west, -east, north-west, -east
    groups = []
    for quadrant, cell in enumerate(cells):
        beside, over = cells[quadrant ^ 1], cells[quadrant ^ 2]
        opposite = cells[quadrant ^ 3]
        convex = cell & ~beside & ~over
        concave = ~cell & beside & over & opposite
        rows, columns = np.nonzero(convex | concave)
        groups.append((rows, columns, np.full(len(rows), quadrant)))
    return groups


def _partners(order: NDArray[np.intp]) -> list[int]:
    """Return for each corner the other end of its edge, given the order of the corners along the lines of the grid."""
    partners = np.empty(len(order), dtype=np.intp)
    partners[order[::2]], partners[order[1::2]] = order[1::2], order[::2]
    return partners.tolist()


def _is_region_above(
    region: NDArray[np.bool_], rows: NDArray[np.int64], columns: NDArray[np.int64], east: NDArray[np.int64]
) -> NDArray[np.bool_]:
    """Return whether the cell above each corner's horizontal edge, next to the corner, belongs to the region."""
    padded = np.pad(region, 1)
    return np.asarray(padded[rows + 1, columns + east])


def _simplify(loop: list[Corner], tolerance: float) -> list[Corner]:
    """Return `loop` without the corners that can be left out within the tolerance, without cutting into the region."""
    circumference = sum(abs(a[0] - b[0]) + abs(a[1] - b[1]) for a, b in zip(loop, loop[1:] + loop[:1], strict=True))
    if circumference <= SMALL:
        return loop
    corners = np.array([*loop, loop[0]], dtype=np.float64)
    indices = [0]
    last = len(loop)
    while indices[-1] < last:
        start = reach = indices[-1]
        reach += 1
        misses = 0
        for end in range(start + 2, last + 1):
            if _can_skip(corners, start, end, tolerance):
                reach, misses = end, 0
            else:
                misses += 1
                if misses > 4:  # after a corner that cannot be reached, one of the next four may be reachable
                    break
        indices.append(reach)
    simplified = [loop[index] for index in indices[:-1]]
    return simplified if len(simplified) >= 3 else loop


def _can_skip(corners: NDArray[np.float64], start: int, end: int, tolerance: float) -> bool:
    """Return whether the corners between two others are within the tolerance of their chord, on its left or on it."""
    chord = corners[end] - corners[start]
    length = float(np.hypot(*chord))
    if length == 0.0:
        return False
    away = corners[start + 1 : end] - corners[start]
    left = (chord[0] * away[:, 1] - chord[1] * away[:, 0]) / length
    along = away @ chord / length
    beside = left.min() >= -1e-9 and left.max() <= tolerance + 1e-9
    return bool(beside and along.min() >= -tolerance and along.max() <= length + tolerance)
