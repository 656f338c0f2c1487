"""Traces the outline of a region of cells, simplified to few straight lines that never cut into the region."""

import numpy as np
from numpy.typing import NDArray

Corner = tuple[int, int]  # column, row of a cell's corner

TOLERANCE = 1.0  # cells by which the simplified outline may lie outside the exact one: the height of one step
SMALL = 12  # cells of circumference, up to which an outline is not simplified

# The four sides of a cell at (column, row): the neighbour, then start and end of the edge with the cell on its left.
SIDES = (
    ((0, -1), (0, 0), (1, 0)),
    ((1, 0), (1, 0), (1, 1)),
    ((0, 1), (1, 1), (0, 1)),
    ((-1, 0), (0, 1), (0, 0)),
)


def outlines(region: NDArray[np.bool_]) -> list[list[Corner]]:
    """Return the simplified closed outlines of `region` (rows, columns), each without repeating its first corner.

    The region is on the left of every outline. Cells that meet only at a corner are separated, because nothing can pass
    there.
    """
    return [_simplify(loop) for loop in _loops(region)]


def _loops(region: NDArray[np.bool_]) -> list[list[Corner]]:
    """Return the exact outlines, each straight run as one edge."""
    following: dict[Corner, list[Corner]] = {}
    padded = np.pad(region, 1)
    for (across, up), (from_x, from_y), (to_x, to_y) in SIDES:
        beyond = padded[1 + up : padded.shape[0] - 1 + up, 1 + across : padded.shape[1] - 1 + across]
        rows, columns = np.nonzero(region & ~beyond)
        for row, column in zip(rows.tolist(), columns.tolist(), strict=True):
            following.setdefault((column + from_x, row + from_y), []).append((column + to_x, row + to_y))
    loops = []
    while following:
        start = here = next(iter(following))
        loop, direction = [], (0, 0)
        while True:
            there = _leave(following, here, direction)
            new_direction = there[0] - here[0], there[1] - here[1]
            if new_direction != direction:
                loop.append(here)
            here, direction = there, new_direction
            if here == start and (here not in following or not _turns_left(following[here], here, direction)):
                break
        if _direction(loop[0], loop[1 % len(loop)]) == direction:
            loop = loop[1:]  # the trace began in the middle of a straight run
        loops.append(loop)
    return loops


def _leave(following: dict[Corner, list[Corner]], here: Corner, direction: Corner) -> Corner:
    """Remove an edge that starts at `here`, the left one of two, and return its end."""
    edges = following[here]
    left = here[0] - direction[1], here[1] + direction[0]
    there = left if left in edges else edges[0]
    edges.remove(there)
    if not edges:
        del following[here]
    return there


def _turns_left(edges: list[Corner], here: Corner, direction: Corner) -> bool:
    return (here[0] - direction[1], here[1] + direction[0]) in edges


def _direction(a: Corner, b: Corner) -> Corner:
    return int(np.sign(b[0] - a[0])), int(np.sign(b[1] - a[1]))


def _simplify(loop: list[Corner]) -> list[Corner]:
    """Return `loop` without the corners that can be left out within TOLERANCE, without cutting into the region."""
    circumference = sum(abs(a[0] - b[0]) + abs(a[1] - b[1]) for a, b in zip(loop, loop[1:] + loop[:1], strict=True))
    if circumference <= SMALL:
        return loop
    corners = np.array([*loop, loop[0]], dtype=np.float64)
    kept = [0]
    last = len(loop)
    while kept[-1] < last:
        here = reach = kept[-1]
        reach += 1
        misses = 0
        for there in range(here + 2, last + 1):
            if _can_skip(corners, here, there):
                reach, misses = there, 0
            else:
                misses += 1
                if misses > 4:  # after a corner that cannot be reached, one of the next four may be reachable
                    break
        kept.append(reach)
    simplified = [loop[index] for index in kept[:-1]]
    return simplified if len(simplified) >= 3 else loop


def _can_skip(corners: NDArray[np.float64], here: int, there: int) -> bool:
    """Return whether the corners between two others are within TOLERANCE of their chord, on its left or on it."""
    chord = corners[there] - corners[here]
    length = float(np.hypot(*chord))
    if length == 0.0:
        return False
    away = corners[here + 1 : there] - corners[here]
    left = (chord[0] * away[:, 1] - chord[1] * away[:, 0]) / length
    along = away @ chord / length
    beside = left.min() >= -1e-9 and left.max() <= TOLERANCE + 1e-9
    return bool(beside and along.min() >= -TOLERANCE and along.max() <= length + TOLERANCE)
