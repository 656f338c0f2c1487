"""Imports an occupancy map as a floor plan: walls around the free space, and a proposed path."""

from pathlib import Path
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.number_format import percent
from app.world.floorplan import MAX_WALLS
from app.world.imports.boundary import TOLERANCE, Corner, corner_count, outlines
from app.world.imports.distances import grown, joined, wall_distances
from app.world.imports.draft import Draft, PlanDocument, path_document, plain_name
from app.world.imports.inside import Inside, inside_of_building
from app.world.imports.ros_map import OccupancyMap
from app.world.imports.route import Route, propose_route

WALL_THICKNESS: Final = 0.02  # m; small, because the outline is the surface of the walls
DECIMALS: Final = 4  # of a metre in the plan
FINE: Final = 0.04  # m that a simplified wall may lie behind the surface; one cell where cells are larger
NARROW: Final = (
    0.0,
    0.1,
    0.2,
    0.6,
)  # m; spaces that a chair of 0.64 m cannot enter: closing them takes no place from it
COARSEST: Final = 0.2  # m per cell; in coarser cells doorways close
MOST_CORNERS: Final = 20 * MAX_WALLS  # of exact outlines, to be simplified: more do not become few enough
TOO_MANY: Final = 4 * MAX_WALLS  # pieces, which only coarser cells make few enough
KNOWN_SHARE: Final = 0.99  # share of known cells from which on a map is a drawing: its outside is as white as its rooms
OPEN_EDGE: Final = 0.5  # share of a map's edge that is free, from which on its outside is free


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
    noun: str = "map",
    *,
    outside: bool = False,
) -> Draft:
    """Return a floor plan made of an occupancy map.

    Only the free space connected with the proposed path is kept, and only the inside of a building unless `outside`;
    unknown cells count as walls. The walls lie in occupied or unknown cells, at most one cell behind the surface, never
    in free cells. A map with too many wall pieces is made simpler and then coarser. `noun` names the map's origin in
    sentences.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    inside = Inside(occupancy.free, 0.0)
    if not outside and _has_open_edge(occupancy):
        building = inside_of_building(occupancy.free, occupancy.resolution)
        if building is None:
            raise ValueError(
                f"{file}: all that is free in this {noun} is connected to its edge, so that it shows no building, "
                "choose to use the outside as well (--outside)"
            )
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
    return Draft(document, (*sentences, "The path is a proposal: change it as you like."))


def _has_open_edge(occupancy: OccupancyMap) -> bool:
    """Return whether free cells at the edge are outside of a building.

    A scan ends where its robot saw nothing more, and its rooms may lie at its edge.
    """
    free = occupancy.free
    edge = np.concatenate([free[0], free[-1], free[1:-1, 0], free[1:-1, -1]])
    is_drawing = occupancy.unknown <= (1.0 - KNOWN_SHARE) * free.size
    return bool(edge.any() if is_drawing else edge.mean() > OPEN_EDGE)


def _walls(free: NDArray[np.bool_], resolution: float, file: Path, noun: str) -> _Walls:
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
        raise ValueError(
            f"{file}: this {noun} has {least:,} wall pieces when it is made as simple as it can be, and at most "
            f"{MAX_WALLS:,} are taken, keep about {percent(MAX_WALLS / least)} of it and paint the rest as wall, "
            "or paint over speckles and furniture"
        )
    hint = "resolution" if noun == "map" else "scale"
    raise ValueError(f"{file}: a chair fits nowhere in this {noun}, check its {hint} and thresholds")


def _without_narrow_spaces(free: NDArray[np.bool_], width: float) -> NDArray[np.bool_]:
    """Return the free cells that a disc of a diameter (cells) covers where it fits."""
    if width == 0:
        return free
    return free & grown(wall_distances(free, width / 2 + 2.0) > width / 2, width / 2)


def _size_sentences(occupancy: OccupancyMap, walls: _Walls, noun: str) -> list[str]:
    rows, columns = occupancy.free.shape
    area, cell = occupancy.resolution**2, occupancy.resolution * walls.side
    used_rows, used_columns = (np.flatnonzero(walls.route.region.any(axis=axis)) for axis in (1, 0))
    width, height = (float(used[-1] - used[0] + 1) * cell for used in (used_columns, used_rows))
    free = np.count_nonzero(walls.route.region) * cell**2
    sentences = [
        f"{sum(map(len, walls.loops)):,} wall pieces.",
        f"The plan is {width:.1f} x {height:.1f} m large, with {free:.1f} m² free; the whole {noun} is "
        f"{columns * occupancy.resolution:.1f} x {rows * occupancy.resolution:.1f} m.",
    ]
    if noun == "map":
        sentences.append(f"{occupancy.unknown * area:.1f} m² of the map are unknown and count as wall.")
    return sentences


def _change_sentences(occupancy: OccupancyMap, inside: Inside, walls: _Walls) -> list[str]:
    sentences = []
    if inside.opening > 0:
        sentences.append(
            f"The building is open to the outside: its openings of up to {inside.opening:.1f} m are closed in the plan."
        )
    if walls.narrow > 0:
        sentences.append(f"There were too many wall pieces: spaces narrower than {walls.narrow} m are closed.")
    if walls.side > 1:
        sentences.append(
            f"{walls.side} x {walls.side} cells are joined to cells of {occupancy.resolution * walls.side:.2f} m; "
            "walls may be thicker by that."
        )
    return sentences
