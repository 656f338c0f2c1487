"""Maps as a robot's laser makes them: noisy, turned, with unknown cells, leaking through open entrances and windows."""

import itertools
from dataclasses import dataclass

import numpy as np
from PIL import Image

FREE, UNKNOWN, OCCUPIED = 254, 205, 0
RANGE = 12.0  # m, of the laser
RAYS = 1440
STEPS = 64  # along a ray at a time


@dataclass(frozen=True)
class ScannedHome:
    pixels: np.ndarray  # (rows, columns), the first row is the uppermost one
    resolution: float  # m
    rooms: np.ndarray  # (n, 2), a place in each room, m from the lower left corner
    length: float  # m, of the home
    area: float  # m², of the rooms


def scanned_home(seed, resolution):
    """Return a home with two rows of rooms beside a corridor, and an open entrance at the corridor's end."""
    random = np.random.default_rng(seed)
    rooms_in_row = int(random.integers(2, 5))
    widths = random.uniform(2.8, 4.2, rooms_in_row)
    length, depth, corridor = float(widths.sum()), float(random.uniform(3.0, 4.2)), float(random.uniform(1.3, 1.8))
    half = corridor / 2
    edges = np.concatenate([[0.0], np.cumsum(widths)])
    walls = [((0, -half - depth), (length, -half - depth)), ((0, half + depth), (length, half + depth))]
    walls += [((0, -half - depth), (0, half + depth))]
    walls += [((length, -half - depth), (length, -half)), ((length, half), (length, half + depth))]  # open between
    rooms = [((a + b) / 2, side * (half + depth / 2)) for side in (-1, 1) for a, b in itertools.pairwise(edges)]
    for side in (-1, 1):
        walls += [((x, side * half), (x, side * (half + depth))) for x in edges[1:-1]]
        for a, b in itertools.pairwise(edges):
            width, at = random.uniform(0.95, 1.1), random.uniform(a + 0.8, b - 0.8)
            walls += [
                ((a, side * half), (at - width / 2, side * half)),
                ((at + width / 2, side * half), (b, side * half)),
            ]
    stations = [*rooms, *((x, 0.0) for x in np.arange(0.8, length, 2.0))]
    margin = 3.0
    size = length + 2 * margin, 2 * (half + depth) + 2 * margin
    turn = float(random.uniform(-0.2, 0.2))
    cos, sin = np.cos(turn), np.sin(turn)

    def placed(points):
        points = np.asarray(points, dtype=float) - (length / 2, 0.0)
        return points @ np.array([[cos, sin], [-sin, cos]]) + (size[0] / 2, size[1] / 2)

    columns, rows = (int(np.ceil(side / resolution)) for side in size)
    truth = np.zeros((rows, columns), bool)
    for wall in walls:
        (ax, ay), (bx, by) = placed(wall) / resolution
        count = int(np.hypot(bx - ax, by - ay) * 3) + 2
        truth[np.linspace(ay, by, count).astype(int), np.linspace(ax, bx, count).astype(int)] = True
    pixels = scan(thickened(truth, resolution), placed(stations), resolution, random)
    return ScannedHome(np.flipud(pixels), resolution, placed(rooms), length, length * 2 * (half + depth))


def thickened(walls, resolution):
    """Return walls of 0.1 m, so that no ray slips through."""
    thick = walls.copy()
    for step in range(1, int(0.1 / resolution) + 1):
        thick[step:] |= walls[:-step]
        thick[:, step:] |= walls[:, :-step]
    return thick


def scan(walls, stations, resolution, random):
    """Return what a laser sees from the stations (n, 2), m."""
    free, hit = np.zeros(walls.shape, bool), np.zeros(walls.shape, bool)
    ranges = np.arange(0, RANGE, resolution * 0.5)
    for station in stations:
        angles = random.uniform(0, 2 * np.pi) + np.arange(RAYS) * 2 * np.pi / RAYS
        ways = np.cos(angles), np.sin(angles)
        first = _first_hits(walls, free, ranges, station, ways, resolution)
        noise = np.rint(random.normal(0, 0.025, RAYS) / (resolution * 0.5)).astype(int)
        ends = ranges[(first + noise).clip(0, len(ranges) - 1)]
        x, y = ((at + ends * way) / resolution for at, way in zip(station, ways, strict=True))
        ray = np.flatnonzero(first < len(ranges))
        hit[_cells(y, walls.shape[0])[ray], _cells(x, walls.shape[1])[ray]] = True
    hit |= (random.random(walls.shape) < 1e-4 * (resolution / 0.05) ** 2) & free  # spurious returns
    return np.where(hit, OCCUPIED, np.where(free, FREE, UNKNOWN)).astype(np.uint8)


def _first_hits(walls, free, ranges, station, ways, resolution):
    """Return the place in `ranges` where each ray meets a wall, their number where it meets none; mark what is free.

    A ray is followed for a metre or so at a time, until it has met a wall or left the map.
    """
    rows, columns = walls.shape
    first, left = np.full(RAYS, len(ranges)), np.arange(RAYS)
    for begin in range(0, len(ranges), STEPS):
        some = ranges[begin : begin + STEPS]
        x, y = ((at + some * way[left, None]) / resolution for at, way in zip(station, ways, strict=True))
        inside = (x >= 0) & (y >= 0) & (x < columns) & (y < rows)
        at_x, at_y = _cells(x, columns), _cells(y, rows)
        blocked = walls[at_y, at_x] & inside
        met = blocked.any(axis=1)
        here = np.where(met, blocked.argmax(axis=1), len(some))
        seen = (np.arange(len(some)) < here[:, None]) & inside
        free[at_y[seen], at_x[seen]] = True
        first[left[met]] = begin + here[met]
        left = left[~met & inside[:, -1]]
    return first


def _cells(places, count):
    """Return the cells of places along one side of a map of so many cells."""
    return places.clip(0, count - 1).astype(int)


def write_map(home, folder, free_threshold=0.25):
    """Write the map's two files as ROS 2's map saver does, and return the YAML file."""
    Image.fromarray(home.pixels).save(folder / "home.pgm")
    file = folder / "home.yaml"
    file.write_text(
        f"image: /home/robot/maps/home.pgm\nmode: trinary\nresolution: {home.resolution}\norigin: [0.0, 0.0, 0.0]\n"
        f"negate: 0\noccupied_thresh: 0.65\nfree_thresh: {free_threshold}\n"
    )
    return file
