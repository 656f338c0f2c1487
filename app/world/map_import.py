"""Makes a floor plan of an occupancy map: walls around the free space, and a path to drive in it."""

import re
from pathlib import Path

import numpy as np
from pydantic import ValidationError

from app.sentences import one_sentence
from app.world.boundary import outlines
from app.world.floorplan import MAX_WALLS, FloorPlan
from app.world.occupancy import read_occupancy_map
from app.world.path import Path as Line
from app.world.route import propose_route

WALL_THICKNESS = 0.02  # m; the outline is the surface of what stands there, so hardly any is added to it
SLOWEST = 0.25  # m/s, the mean speed that the time limit allows
SHORTEST_TIME = 60.0  # s
DECIMALS = 4  # of a metre in the plan


def import_ros_map(yaml_file: Path, title: str | None = None, name: str | None = None) -> FloorPlan:
    """Return a floor plan made from a ROS map_server map.

    Only what hangs together with the proposed path is kept; unknown cells count as walls. The walls lie in occupied or
    unknown cells, at most one cell behind the surface, and never in free ones.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    occupancy = read_occupancy_map(yaml_file)
    route = propose_route(occupancy.free, occupancy.resolution)
    if route is None:
        raise ValueError(f"{yaml_file}: a chair fits nowhere in this map, check its resolution and thresholds")
    walls = []
    for loop in outlines(route.region):
        places = occupancy.place(np.array([*loop, loop[0]], dtype=np.float64)).round(DECIMALS).tolist()
        walls.append(places)
    edges = sum(len(wall) - 1 for wall in walls)
    if edges > MAX_WALLS:
        raise ValueError(f"{yaml_file}: this map has {edges} wall pieces, clean it until it has at most {MAX_WALLS}")
    points = occupancy.place(route.cells).round(DECIMALS).tolist()
    length = Line(points).length
    plain = re.sub(r"[^A-Za-z0-9_.-]+", "-", yaml_file.stem).strip("-_.")[:64] or "map"
    document = {
        "name": name or plain,
        "title": title or yaml_file.stem,
        "walls": walls,
        "wall_thickness": WALL_THICKNESS,
        "paths": [
            {
                "name": "main",
                "title": "Across the building",
                "points": points,
                "time_limit": round(max(SHORTEST_TIME, length / SLOWEST)),
                "instruction": "Follow the white line to its end.",
            }
        ],
    }
    try:
        return FloorPlan.model_validate(document)
    except ValidationError as error:
        raise ValueError(one_sentence(error, str(yaml_file))) from error
