"""A map of a hospital's storey as a robot's laser makes it: wings of furnished rooms at corridors."""

import itertools

import numpy as np
from world.scanned_homes import ScannedHome, scan, thickened

RESOLUTION = 0.05  # m
CROSS = 3.0  # m, width of the corridor that joins the wings
DEPTH, CORRIDOR = 5.0, 2.4  # m, of a room and of a wing's corridor
MARGIN = 3.0  # m around the storey


class _Drawn:
    """The occupied cells of a storey that stands a little turned in its map."""

    def __init__(self, size, turn):
        side = int(np.ceil((size + 2 * MARGIN) / RESOLUTION))
        self.cells = np.zeros((side, side), bool)
        self._middle, self._centre = size / 2, side * RESOLUTION / 2
        self._turn = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])

    def placed(self, points):
        return (np.asarray(points, dtype=float) - self._middle) @ self._turn + self._centre

    def line(self, *points):
        for (ax, ay), (bx, by) in itertools.pairwise(self.placed(points) / RESOLUTION):
            count = int(np.hypot(bx - ax, by - ay) * 3) + 2
            self.cells[np.linspace(ay, by, count).astype(int), np.linspace(ax, bx, count).astype(int)] = True


def scanned_hospital(seed, size):
    """Return a storey of `size` x `size` m, with a chair or a piece of furniture or two in most rooms."""
    random = np.random.default_rng(seed)
    drawn = _Drawn(size, float(random.uniform(-0.1, 0.1)))
    drawn.line((0, 0), (size, 0), (size, size), (0, size), (0, 0))
    rooms, stations = [], [(CROSS / 2, y) for y in np.arange(1.0, size, 3.0)]
    wing = 2 * DEPTH + CORRIDOR
    for low in np.arange(CROSS, size - wing, wing):
        near, far = low + DEPTH, low + DEPTH + CORRIDOR
        stations += [(x, (near + far) / 2) for x in np.arange(CROSS, size, 3.0)]
        for door, back in ((near, low), (far, low + wing)):
            rooms += _row_of_rooms(drawn, size, door, back, random)
    stations += [room + step for room in np.array(rooms) for step in ((0, 0), (-0.9, 1.2), (0.9, -1.2))]
    pixels = scan(thickened(drawn.cells, RESOLUTION), drawn.placed(stations), RESOLUTION, random)
    return ScannedHome(np.flipud(pixels), RESOLUTION, drawn.placed(rooms), size, len(rooms) * DEPTH * 4.0)


def _row_of_rooms(drawn, size, door, back, random):
    """Draw rooms along one side of a corridor, and return their middles."""
    edges = [CROSS]
    while size - edges[-1] > 8.0:
        edges.append(edges[-1] + random.uniform(3.0, 5.5))
    edges.append(size)
    drawn.line((CROSS, door), (CROSS, back), (size, back))
    middles = []
    for left, right in itertools.pairwise(edges):
        width, at = random.uniform(1.0, 1.3), random.uniform(left + 1.0, right - 1.0)
        drawn.line((left, door), (at - width / 2, door))
        drawn.line((at + width / 2, door), (right, door), (right, back))
        middle = np.array([(left + right) / 2, (door + back) / 2])
        middles.append(middle)
        for _ in range(random.integers(0, 3)):
            away = np.array([random.uniform(-1, 1), random.choice((-1.6, 1.6))])
            _furniture(drawn, middle + away, random)
    return middles


def _furniture(drawn, middle, random):
    """Draw the four legs of a chair, or the sides of a cupboard."""
    turn, half = random.uniform(0, np.pi), random.uniform(0.2, 0.4)
    corners = [middle + half * np.array([np.cos(turn + k * np.pi / 2), np.sin(turn + k * np.pi / 2)]) for k in range(4)]
    if random.random() < 0.5:
        drawn.line(*corners, corners[0])
    else:
        for corner in corners:
            drawn.line(corner, corner)
