"""Separates the inside of a building from its outside on a grid of free cells, also when entrances are open."""

from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_dilation, label

from app.world.imports.distances import grown, joined, wall_distances

# m, half the widths of openings that are closed: an outside that is as free as the rooms enters through entrances and
# through windows that are drawn as gaps.
HALF_OPENINGS: Final = (0.0, 0.3, 0.45, 0.65, 0.9, 1.2, 1.6, 2.0)
ENOUGH: Final = 0.6  # share of the inside behind the widest openings, from which on no wider opening is closed
CELL: Final = 0.05  # m, least size of the cells of the search for openings
MOST_CELLS: Final = 1_000_000  # of the search for openings


class Inside(NamedTuple):
    """The free cells inside a building."""

    free: NDArray[np.bool_]  # (rows, columns)
    opening: float  # m, width up to which openings to the outside were closed; 0 when none had to be


def inside_of_building(free: NDArray[np.bool_], resolution: float) -> Inside | None:
    """Return the free cells (rows, columns) of `resolution` (m) inside a building; None when there is no building.

    The outside is what can be reached from the edge of the grid through openings wider than a width, which is the
    smallest that leaves most of the rooms inside.
    """
    side = max(1, int(CELL / resolution), int(np.ceil(np.sqrt(free.size / MOST_CELLS))))
    cell = resolution * side
    reach = int(np.ceil(HALF_OPENINGS[-1] / cell)) + 2
    margin = 2 * reach
    coarse = np.pad(joined(free, side, beyond=True), margin, constant_values=True)
    room = wall_distances(coarse, reach) * cell
    # The outside begins in the outermost ring, which is so far away that its room is limited by the grid's end only.
    room[:reach] = room[-reach:] = room[:, :reach] = room[:, -reach:] = np.inf
    widest = _outside(coarse, room, HALF_OPENINGS[-1], cell)
    most = np.count_nonzero(coarse & ~widest)
    if not most:
        return None
    for half in HALF_OPENINGS:
        outside = widest if half == HALF_OPENINGS[-1] else _outside(coarse, room, half, cell)
        if np.count_nonzero(coarse & ~outside) >= ENOUGH * most:
            break
    # Cells beside walls that are joined with wall cells are free and outside, too.
    fine = np.repeat(np.repeat(outside[margin:-margin, margin:-margin], side, axis=0), side, axis=1)
    fine = fine[: free.shape[0], : free.shape[1]] & free
    if side > 1:
        fine = np.asarray(binary_dilation(fine, iterations=2 * side, mask=free))
    return Inside(free & ~fine, 2 * half)


def _outside(free: NDArray[np.bool_], room: NDArray[np.float32], half: float, cell: float) -> NDArray[np.bool_]:
    """Return the free cells that a disc of radius `half` (m) covers on its ways from the edge."""
    parts, _ = label(free & (room > half))
    disc = parts == parts[0, 0]
    return free & (grown(disc, half / cell) if half > 0 else disc)
