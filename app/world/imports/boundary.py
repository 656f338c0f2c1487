"""Traces the outline of a region of cells, simplified to few straight lines that never cut into the region."""

import numpy as np
from numpy.typing import NDArray

Corner = tuple[int, int]  # column, row of a cell's corner

TOLERANCE = 1.0  # cells by which the simplified outline may lie outside the exact one: the height of one step
SMALL = 12  # cells of circumference, up to which an outline is not simplified


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
