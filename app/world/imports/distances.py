"""Computes distances on large grids of cells, strip by strip: a whole grid at once needs up to 60 bytes for a cell."""

from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

STRIP: Final = 2_000_000  # cells of a strip without its margins


def wall_distances(free: NDArray[np.bool_], reach: float) -> NDArray[np.float32]:
    """Return the distance of each cell's middle from the nearest middle of a cell that is not free.

    Parameters
    ----------
    free
        (rows, columns); cells beyond the edge are not free.
    reach
        Cells; longer distances are returned as `reach`.

    Returns
    -------
    NDArray
        (rows, columns), in cells; 0 in cells that are not free.
    """
    rows, columns = free.shape
    margin = int(np.ceil(reach))
    height = max(STRIP // max(columns, 1), margin, 1)
    distances = np.empty(free.shape, dtype=np.float32)
    for top in range(0, rows, height):
        bottom = min(top + height, rows)
        first, last = max(top - margin, 0), min(bottom + margin, rows)
        strip = np.pad(free[first:last], ((int(first == 0), int(last == rows)), (1, 1)))
        inner = np.asarray(distance_transform_edt(strip))[int(first == 0) :, 1:-1]
        np.minimum(inner[top - first : bottom - first], reach, out=distances[top:bottom])
    return distances


def grown(cells: NDArray[np.bool_], radius: float) -> NDArray[np.bool_]:
    """Return the cells whose middle is at most `radius` (cells) from the middle of one of `cells`."""
    distances = wall_distances(np.pad(~cells, int(np.ceil(radius)) + 1, constant_values=True), radius + 1.0)
    inner = int(np.ceil(radius)) + 1
    return np.asarray(distances[inner:-inner, inner:-inner] <= radius)


def joined(free: NDArray[np.bool_], side: int, *, beyond: bool) -> NDArray[np.bool_]:
    """Return cells of `side` x `side` cells, free when all of them are; `beyond` the last row and column, or not."""
    if side == 1:
        return free
    rows, columns = free.shape
    padded = np.pad(free, ((0, -rows % side), (0, -columns % side)), constant_values=beyond)
    blocks = padded.reshape(padded.shape[0] // side, side, padded.shape[1] // side, side)
    return np.asarray(blocks.all(axis=(1, 3)))
