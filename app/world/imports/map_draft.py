"""Imports an occupancy map as a floor plan: walls around the free space, and a proposed path."""

from pathlib import Path

import numpy as np

from app.world.floorplan import MAX_WALLS
from app.world.imports.boundary import outlines
from app.world.imports.draft import Draft, path_document, plain_name
from app.world.imports.ros_map import OccupancyMap
from app.world.imports.route import propose_route

WALL_THICKNESS = 0.02  # m; small, because the outline is the surface of the walls
DECIMALS = 4  # of a metre in the plan


def draft_of_map(
    occupancy: OccupancyMap, file: Path, title: str | None = None, name: str | None = None, what: str = "map"
) -> Draft:
    """Return a floor plan made of an occupancy map.

    Only the free space connected with the proposed path is kept; unknown cells count as walls. The walls lie in
    occupied or unknown cells, at most one cell behind the surface, never in free cells. `what` names the map's origin
    in sentences.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    route = propose_route(occupancy.free, occupancy.resolution)
    if route is None:
        hint = "resolution" if what == "map" else "scale"
        raise ValueError(f"{file}: a chair fits nowhere in this {what}, check its {hint} and thresholds")
    walls = []
    for loop in outlines(route.region):
        places = occupancy.place(np.array([*loop, loop[0]], dtype=np.float64)).round(DECIMALS).tolist()
        walls.append(places)
    edges = sum(len(wall) - 1 for wall in walls)
    if edges > MAX_WALLS:
        raise ValueError(f"{file}: this {what} has {edges:,} wall pieces, clean it until it has at most {MAX_WALLS:,}")
    points = occupancy.place(route.cells).round(DECIMALS).tolist()
    document = {
        "name": name or plain_name(file.stem),
        "title": title or file.stem[:80],
        "walls": walls,
        "wall_thickness": WALL_THICKNESS,
        "paths": [path_document(points)],
    }
    return Draft(document, (f"{edges} wall pieces.", "The path is a proposal: change it as you like."))
