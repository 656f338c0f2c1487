"""E_diff: the area between the driven trajectory and the prescribed path, segmented where they meet."""

import numpy as np
from numpy.typing import NDArray

Points = NDArray[np.float64]

MOST_POINTS = 2000  # a longer trajectory is simplified first
TOLERANCE = 1e-4  # m, largest deviation of the simplified trajectory: an error of at most 0.0001 m2 per metre driven
GRID = 1e-7  # m, to which crossings are rounded, so that nearly equal lines cut each other cleanly
ZERO = 1e-12  # m; smaller coordinates are set to 0
BLOCK = 64  # faces, of neighbouring y, that are computed together


def area_between(trajectory: Points, path: Points) -> float:
    """Return the area (m2) between `trajectory` (n, 2) and `path` (m, 2), both in m and from start to end.

    The trajectory, followed by the path backwards, makes one closed ring. Each face that the ring encloses is counted
    as often as the ring winds around it: a loop driven twice counts twice, and areas on the two sides of the path do
    not cancel each other. Two loops around the same place in opposite directions do: the ring does not wind around it.
    """
    import shapely

    origin = path[0]
    driven, prescribed = trajectory - origin, path - origin
    if len(driven) > MOST_POINTS:
        driven = shapely.get_coordinates(
            shapely.simplify(shapely.LineString(driven), TOLERANCE, preserve_topology=False)
        )
    ring = np.vstack([driven, prescribed[::-1], driven[:1]])
    ring[np.abs(ring) < ZERO] = 0.0  # shapely's noding would divide by these coordinates
    ring = ring[np.r_[True, np.any(ring[1:] != ring[:-1], axis=1)]]
    if len(ring) < 3:
        return 0.0
    noded = shapely.unary_union([shapely.LineString(ring)], grid_size=GRID)
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    if not len(faces):
        return 0.0
    inside = shapely.get_coordinates(shapely.point_on_surface(faces))
    return float(np.sum(np.abs(winding_numbers(ring, inside)) * shapely.area(faces)))


def winding_numbers(ring: Points, places: Points) -> NDArray[np.int64]:
    """Return how often the closed `ring` (n, 2) winds around each of `places` (k, 2), counter-clockwise positive.

    A ray goes from each place towards +x: an edge that crosses the ray upwards counts +1, downwards -1.
    """
    start, end = ring[:-1], ring[1:]
    low, high = np.minimum(start[:, 1], end[:, 1]), np.maximum(start[:, 1], end[:, 1])
    numbers = np.empty(len(places), dtype=np.int64)
    order = np.argsort(places[:, 1])
    for first in range(0, len(order), BLOCK):
        block = order[first : first + BLOCK]
        x, y = places[block, 0, np.newaxis], places[block, 1, np.newaxis]
        candidates = (low <= y[-1]) & (high >= y[0])  # only these edges can cross a ray of this block
        a, b = start[candidates], end[candidates]
        along = b - a
        left = along[:, 0] * (y - a[:, 1]) - along[:, 1] * (x - a[:, 0])
        upwards = (a[:, 1] <= y) & (b[:, 1] > y) & (left > 0)
        downwards = (a[:, 1] > y) & (b[:, 1] <= y) & (left < 0)
        numbers[block] = upwards.sum(axis=1) - downwards.sum(axis=1)
    return numbers
