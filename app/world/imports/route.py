"""Proposes a drivable path through a map: between two distant places, with clearance where the map allows it."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import label
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components, dijkstra

from app.world.footprint import CHAIR_RADIUS
from app.world.imports.distances import joined, wall_distances

MARGIN = 0.04  # m beside the chair; no path is proposed through narrower passages
CORNER = 0.71  # cells from a cell's middle to its corner
ROOM_AT_ENDS = 1.0  # m, so that a trial does not begin or end at a wall
ENOUGH = 0.7  # share of the longest way, from which on ends with more room are preferred to a longer way
CLEARANCE = 0.45  # m, kept where the map allows it
COMFORT = 0.8  # m; more clearance than this lowers no cost
DETOUR = 6.0  # cost of a metre with the least clearance, over that of a metre with COMFORT
SIDESTEP = 0.3  # m, largest distance of a straight piece from the cheapest way
SHORTEST = 2.0  # m; shorter paths are not proposed
MOST_NODES = 300_000  # of the graph that is searched
FINEST = 0.06  # m; larger cells are divided, because a door's middle may lie between two cells


class Route(NamedTuple):
    """A proposed path, and the region that it lies in."""

    cells: NDArray[np.float64]  # (n, 2), (column, row) of the path's points, at middles of cells
    region: NDArray[np.bool_]  # (rows, columns), the free cells connected with the path


def propose_route(free: NDArray[np.bool_], resolution: float) -> Route | None:
    """Return a route through the free cells (rows, columns) of `resolution` (m), None when a chair fits nowhere."""
    parts = int(np.ceil(resolution / FINEST))
    fine = np.repeat(np.repeat(free, parts, axis=0), parts, axis=1) if parts > 1 else free
    points = _way(fine, resolution / parts)
    if points is None:
        return None
    cells = (points + 0.5) / parts
    regions, _ = label(free)
    column, row = cells[0].astype(int)
    return Route(cells, regions == regions[row, column])


def _way(free: NDArray[np.bool_], resolution: float) -> NDArray[np.float64] | None:
    """Return the points (n, 2) of a long way as (column, row) of cells; None when a chair fits nowhere."""
    clearance = wall_distances(free, ROOM_AT_ENDS / resolution + 1.0)
    clearance -= CORNER
    clearance *= resolution
    least = CHAIR_RADIUS + max(MARGIN, CORNER * resolution)
    passable = _largest(clearance >= least, resolution)
    if passable is None:
        return None
    grid = _Grid(passable, clearance, least, resolution)
    for room in (ROOM_AT_ENDS, CLEARANCE, least):
        ends = grid.room >= room
        if not ends.any():
            continue
        start = _furthest(grid.costs(int(np.argmax(ends))), ends)
        costs, before = grid.ways(start)
        end = _furthest(costs, ends)
        longest = costs[_furthest(costs, np.ones_like(ends))]
        if room > least and costs[end] < ENOUGH * longest:
            continue
        points = _straighten(grid.steps(before, start, end), clearance, least, resolution)
        if float(np.hypot(*np.diff(points, axis=0).T).sum()) * resolution >= SHORTEST:
            return points
    return None


def _furthest(costs: NDArray[np.float64], among: NDArray[np.bool_]) -> int:
    """Return the node of `among` with the highest cost."""
    return int(np.argmax(np.where(among & np.isfinite(costs), costs, -1.0)))


def _largest(cells: NDArray[np.bool_], resolution: float) -> NDArray[np.bool_] | None:
    """Return the largest connected part, None when it is smaller than a square metre."""
    parts, count = label(cells)
    if count == 0:
        return None
    sizes = np.bincount(parts.ravel())
    sizes[0] = 0
    largest = int(np.argmax(sizes))
    return parts == largest if sizes[largest] * resolution**2 >= 1.0 else None


class _Grid:
    """The passable cells as a graph, whose edges cost more near walls.

    On a large grid a node stands for a square of cells: it is the cell with the most clearance in it.
    """

    def __init__(
        self, passable: NDArray[np.bool_], clearance: NDArray[np.float32], least: float, resolution: float
    ) -> None:
        side = 1
        chosen = passable
        while np.count_nonzero(chosen) > MOST_NODES:
            side += 1
            chosen = _any_in_squares(passable, side)
        number = np.full(chosen.shape, -1)
        number[chosen] = np.arange(np.count_nonzero(chosen))
        if side == 1:
            self.rows, self.columns = np.nonzero(passable)
        else:
            self.rows, self.columns = _roomiest(np.where(passable, clearance, -1.0), side, chosen)
        self.room = clearance[self.rows, self.columns]
        narrow = np.clip((COMFORT - self.room) / (COMFORT - least), 0.0, 1.0)
        price = (1.0 + (DETOUR - 1.0) * narrow**2) * resolution
        starts, ends, costs = [], [], []
        for up, across in ((0, 1), (1, 0), (1, 1), (1, -1)):
            here, there = _beside(number.shape, up, across)
            a, b = number[here], number[there]
            both = (a >= 0) & (b >= 0)
            a, b = a[both], b[both]
            if side > 1:
                clear = self._are_clear(passable, a, b, 2 * side + 1)
                a, b = a[clear], b[clear]
            starts.append(a)
            ends.append(b)
            length = np.hypot(self.rows[a] - self.rows[b], self.columns[a] - self.columns[b])
            costs.append(length * (price[a] + price[b]) / 2)
        n = len(self.rows)
        edges = (np.concatenate(starts), np.concatenate(ends))
        self._graph = coo_matrix((np.concatenate(costs), edges), shape=(n, n)).tocsr()
        if side > 1:
            self._keep_largest()

    def _are_clear(
        self, passable: NDArray[np.bool_], a: NDArray[np.int64], b: NDArray[np.int64], count: int
    ) -> NDArray[np.bool_]:
        """Return whether all cells on the straight lines between the nodes `a` and `b` are passable."""
        clear = np.ones(len(a), dtype=np.bool_)
        for share in np.linspace(0.0, 1.0, count)[1:-1]:
            rows = np.rint(self.rows[a] + share * (self.rows[b] - self.rows[a])).astype(np.intp)
            columns = np.rint(self.columns[a] + share * (self.columns[b] - self.columns[a])).astype(np.intp)
            clear &= passable[rows, columns]
        return clear

    def _keep_largest(self) -> None:
        """Leave out the nodes that are not connected with most others."""
        _, part = connected_components(self._graph, directed=False)
        largest = np.flatnonzero(part == np.argmax(np.bincount(part)))
        self._graph = self._graph[largest][:, largest]
        self.rows, self.columns, self.room = self.rows[largest], self.columns[largest], self.room[largest]

    def costs(self, node: int) -> NDArray[np.float64]:
        """Return the cost of each node's cheapest way from `node`."""
        return np.asarray(dijkstra(self._graph, directed=False, indices=node))

    def ways(self, node: int) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Return the cost of each node's cheapest way from `node`, and the node before it on that way."""
        costs, before = dijkstra(self._graph, directed=False, indices=node, return_predecessors=True)
        return costs, before

    def steps(self, before: NDArray[np.int32], start: int, end: int) -> NDArray[np.int64]:
        """Return the way from `start` to `end`, (n, 2) as (column, row) of cells."""
        nodes = [end]
        while nodes[-1] != start:
            nodes.append(int(before[nodes[-1]]))
        order = np.array(nodes[::-1])
        return np.column_stack([self.columns[order], self.rows[order]])


def _squares(cells: NDArray[np.float32], side: int, beyond: float) -> NDArray[np.float32]:
    """Return the cells by squares, (rows, columns, side * side)."""
    rows, columns = cells.shape
    padded = np.pad(cells, ((0, -rows % side), (0, -columns % side)), constant_values=beyond)
    squares = padded.reshape(padded.shape[0] // side, side, padded.shape[1] // side, side)
    return squares.transpose(0, 2, 1, 3).reshape(squares.shape[0], squares.shape[2], side * side)


def _any_in_squares(cells: NDArray[np.bool_], side: int) -> NDArray[np.bool_]:
    return ~joined(~cells, side, beyond=True)


def _roomiest(
    clearance: NDArray[np.float32], side: int, chosen: NDArray[np.bool_]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return the rows and columns of the cell with the most clearance in each chosen square."""
    best = np.argmax(_squares(clearance, side, -1.0), axis=2)[chosen]
    rows, columns = np.nonzero(chosen)
    return rows * side + best // side, columns * side + best % side


def _beside(shape: tuple[int, ...], up: int, across: int) -> tuple[tuple[slice, slice], tuple[slice, slice]]:
    """Return slices of the cells with a neighbour `up` rows and `across` columns away, and of those neighbours."""
    rows, columns = shape[0], shape[1]
    here = slice(0, rows - up), slice(max(-across, 0), columns - max(across, 0))
    there = slice(up, rows), slice(max(across, 0), columns + min(across, 0))
    return here, there


def _straighten(
    steps: NDArray[np.int64], clearance: NDArray[np.float32], least: float, resolution: float
) -> NDArray[np.float64]:
    """Return few points of the way, such that `_is_straight` holds for each piece between two of them."""
    indices, last = [0], len(steps) - 1
    while indices[-1] < last:
        first = indices[-1]
        reach, stride = first + 1, 1
        while stride:  # double the stride while the piece is straight, then halve it
            end = min(reach + stride, last)
            if end > reach and _is_straight(steps[first : end + 1], clearance, least, resolution):
                reach, stride = end, stride * 2
            else:
                stride //= 2
        indices.append(reach)
    return steps[indices].astype(np.float64)


def _is_straight(steps: NDArray[np.int64], clearance: NDArray[np.float32], least: float, resolution: float) -> bool:
    """Return whether a straight line can replace these steps: near them, and with no less clearance than needed."""
    start, chord = steps[0].astype(np.float64), (steps[-1] - steps[0]).astype(np.float64)
    length = float(np.hypot(*chord))
    if length == 0.0:
        return True
    away = steps - start
    beside = np.abs(chord[0] * away[:, 1] - chord[1] * away[:, 0]) / length
    if beside.max() * resolution > SIDESTEP:
        return False
    along = np.linspace(0.0, 1.0, int(length * 2) + 2)[:, np.newaxis]
    cells = np.rint(start + along * chord).astype(np.int64)
    room = float(clearance[steps[:, 1], steps[:, 0]].min()) - resolution  # rounding the line to cells may lose one
    needed = max(min(room, CLEARANCE), least)
    return bool(clearance[cells[:, 1], cells[:, 0]].min() >= needed)
