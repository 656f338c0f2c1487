"""E_diff: the area between a driven line and the prescribed path, segmented where they meet."""

import numpy as np
import shapely
from numpy.typing import NDArray

Points = NDArray[np.float64]

MANY = 2000  # points; a longer trajectory is thinned first
THINNING = 1e-4  # m; no thinned line is further than this from the driven one: at most 0.0001 m2 per metre driven
GRID = 1e-7  # m, to which crossings are rounded, so that nearly equal lines cut each other cleanly
NOTHING = 1e-12  # m, far below the grid
AT_ONCE = 64  # faces, of neighbouring y, looked at together


def area_between(trajectory: Points, path: Points) -> float:
    """Return the area (m2) between `trajectory` (n, 2) and `path` (m, 2), both in m and from start to end.

    The trajectory and the path backwards are closed into one ring. Every face that the ring encloses counts as often as
    the ring winds around it: a loop driven twice counts twice, and crossing the path does not cancel what lies on its
    two sides.
    """
    origin = path[0]
    driven, prescribed = trajectory - origin, path - origin
    if len(driven) > MANY:
        driven = shapely.get_coordinates(
            shapely.simplify(shapely.LineString(driven), THINNING, preserve_topology=False)
        )
    ring = np.vstack([driven, prescribed[::-1], driven[:1]])
    ring[np.abs(ring) < NOTHING] = 0.0  # the noding divides by what is nearly nothing
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

    Counted along a ray from each place towards +x: edges that cross it upwards count +1, downwards -1.
    """
    start, end = ring[:-1], ring[1:]
    low, high = np.minimum(start[:, 1], end[:, 1]), np.maximum(start[:, 1], end[:, 1])
    numbers = np.empty(len(places), dtype=np.int64)
    order = np.argsort(places[:, 1])
    for first in range(0, len(order), AT_ONCE):
        block = order[first : first + AT_ONCE]
        x, y = places[block, 0, np.newaxis], places[block, 1, np.newaxis]
        met = (low <= y[-1]) & (high >= y[0])  # only these edges can be met by a ray of this block
        a, b = start[met], end[met]
        along = b - a
        left = along[:, 0] * (y - a[:, 1]) - along[:, 1] * (x - a[:, 0])
        upwards = (a[:, 1] <= y) & (b[:, 1] > y) & (left > 0)
        downwards = (a[:, 1] > y) & (b[:, 1] <= y) & (left < 0)
        numbers[block] = upwards.sum(axis=1) - downwards.sum(axis=1)
    return numbers
