"""Rasterises walls into cells."""

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from app.world.imports.wall_pieces import Point

STEP = 0.4  # cells between two points along a wall whose cells are marked


def free_cells(
    walls: list[list[Point]], thickness: float, size: tuple[float, float], resolution: float
) -> NDArray[np.bool_]:
    """Return which cells (rows, columns) of `resolution` (m) from the origin to `size` (m) are free of walls."""
    columns, rows = (int(np.ceil(side / resolution)) + 1 for side in size)
    marked = np.zeros((rows, columns), dtype=np.bool_)
    for wall in walls:
        points = np.array(wall)
        for a, b in pairwise(points):
            count = int(np.hypot(*(b - a)) / (resolution * STEP)) + 2
            places = (a + np.linspace(0.0, 1.0, count)[:, np.newaxis] * (b - a)) / resolution
            at = places.astype(int).clip(0, (columns - 1, rows - 1))
            marked[at[:, 1], at[:, 0]] = True
    if not marked.any():
        return ~marked
    return np.asarray(distance_transform_edt(~marked) * resolution > thickness / 2)
