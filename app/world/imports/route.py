"""Proposes a drivable path through a map: between two distant places, with clearance where the map allows it."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt, label
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

from app.world.kinematics import CHAIR_RADIUS

MARGIN = 0.04  # m beside the chair; no path is proposed through narrower passages
CORNER = 0.71  # cells from a cell's middle to its corner
ROOM_AT_ENDS = 1.0  # m, so that a trial does not begin or end at a wall
CLEARANCE = 0.45  # m, kept where the map allows it
COMFORT = 0.8  # m; more clearance than this lowers no cost
DETOUR = 6.0  # cost of a metre with the least clearance, over that of a metre with COMFORT
SIDESTEP = 0.3  # m, largest distance of a straight piece from the cheapest way
SHORTEST = 2.0  # m; shorter paths are not proposed


class Route(NamedTuple):
    """A proposed path, and the region that it lies in."""

    cells: NDArray[np.float64]  # (n, 2), (column, row) of the path's points, at middles of cells
    region: NDArray[np.bool_]  # (rows, columns), the free cells connected with the path


def propose_route(free: NDArray[np.bool_], resolution: float) -> Route | None:
    """Return a route through the free cells (rows, columns) of `resolution` (m), None when a chair fits nowhere."""
    padded = np.pad(free, 1)
    clearance = (np.asarray(distance_transform_edt(padded))[1:-1, 1:-1] - CORNER) * resolution
    least = CHAIR_RADIUS + max(MARGIN, CORNER * resolution)
    passable = _largest(clearance >= least, resolution)
    if passable is None:
        return None
    ends_at = next(ends for room in (ROOM_AT_ENDS, CLEARANCE, least) if (ends := passable & (clearance >= room)).any())
    grid = _Grid(passable, clearance, least, resolution)
    one = grid.furthest(int(grid.number[ends_at][0]), ends_at)
    other = grid.furthest(one, ends_at)
    steps = grid.way(one, other)
    points = _straighten(steps, clearance, least, resolution)
    length = float(np.hypot(*np.diff(points, axis=0).T).sum()) * resolution
    if length < SHORTEST:
        return None
    regions, _ = label(free)
    column, row = steps[0]
    return Route(points + 0.5, regions == regions[row, column])


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
    """The passable cells as a graph, whose edges cost more near walls."""

    def __init__(
        self, passable: NDArray[np.bool_], clearance: NDArray[np.float64], least: float, resolution: float
    ) -> None:
        self.number = np.full(passable.shape, -1)
        self.number[passable] = np.arange(np.count_nonzero(passable))
        self.rows, self.columns = np.nonzero(passable)
        narrow = np.clip((COMFORT - clearance) / (COMFORT - least), 0.0, 1.0)
        price = (1.0 + (DETOUR - 1.0) * narrow**2) * resolution
        starts, ends, costs = [], [], []
        for up, across in ((0, 1), (1, 0), (1, 1), (1, -1)):
            here, there = _beside(passable.shape, up, across)
            a, b = self.number[here], self.number[there]
            both = (a >= 0) & (b >= 0)
            starts.append(a[both])
            ends.append(b[both])
            costs.append(np.hypot(up, across) * (price[here] + price[there])[both] / 2)
        n = len(self.rows)
        edges = (np.concatenate(starts), np.concatenate(ends))
        self.graph = coo_matrix((np.concatenate(costs), edges), shape=(n, n)).tocsr()

    def furthest(self, cell: int, among: NDArray[np.bool_]) -> int:
        """Return the cell of `among` with the highest cost from `cell`."""
        cost = dijkstra(self.graph, directed=False, indices=[cell])[0]
        candidates = self.number[among]
        reached = np.where(np.isfinite(cost[candidates]), cost[candidates], -1.0)
        return int(candidates[int(np.argmax(reached))])

    def way(self, start: int, end: int) -> NDArray[np.int64]:
        """Return the cheapest way from `start` to `end`, (n, 2) as (column, row) of cells."""
        _, before = dijkstra(self.graph, directed=False, indices=[start], return_predecessors=True)
        cells = [end]
        while cells[-1] != start:
            cells.append(int(before[0, cells[-1]]))
        order = np.array(cells[::-1])
        return np.column_stack([self.columns[order], self.rows[order]])


def _beside(shape: tuple[int, ...], up: int, across: int) -> tuple[tuple[slice, slice], tuple[slice, slice]]:
    """Return slices of the cells with a neighbour `up` rows and `across` columns away, and of those neighbours."""
    rows, columns = shape[0], shape[1]
    here = slice(0, rows - up), slice(max(-across, 0), columns - max(across, 0))
    there = slice(up, rows), slice(max(across, 0), columns + min(across, 0))
    return here, there


def _straighten(
    steps: NDArray[np.int64], clearance: NDArray[np.float64], least: float, resolution: float
) -> NDArray[np.float64]:
    """Return few points of the way, such that `_is_straight` holds for each piece between two of them."""
    kept, last = [0], len(steps) - 1
    while kept[-1] < last:
        here = kept[-1]
        reach, stride = here + 1, 1
        while stride:  # double the stride while the piece is straight, then halve it
            there = min(reach + stride, last)
            if there > reach and _is_straight(steps[here : there + 1], clearance, least, resolution):
                reach, stride = there, stride * 2
            else:
                stride //= 2
        kept.append(reach)
    return steps[kept].astype(np.float64)


def _is_straight(steps: NDArray[np.int64], clearance: NDArray[np.float64], least: float, resolution: float) -> bool:
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
