"""Computes the clearance between a path and the walls and obstacles of a floor plan."""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.world.obstacles import Box, Cylinder, Obstacle

Points = NDArray[np.float64]

ROUNDING = 1e-6  # m: far more than distances differ by rounding
PARALLEL = 1e-300  # m2: smallest cross product of two pieces that are not parallel; their crossing divides by it


class NarrowestPoint(NamedTuple):
    """The point of a path nearest to a wall or an obstacle."""

    distance: float  # m, from the path to the surface; 0 or less when the path goes through it
    x: float  # m, of the point on the path
    y: float  # m
    obstacle: Obstacle | None  # None: a wall


NO_SURFACE = NarrowestPoint(np.inf, 0.0, 0.0, None)


class Clearance:
    """Computes the distances between paths and the walls and obstacles of a floor plan."""

    def __init__(
        self, walls: Sequence[Sequence[tuple[float, float]]], thickness: float, obstacles: Sequence[Obstacle]
    ) -> None:
        edges = [(*a, *b) for wall in walls for a, b in pairwise(wall)]
        self._walls = np.array(edges, dtype=np.float64).reshape(-1, 4)
        self._low, self._high = _box_round(self._walls)
        self._half_thickness = thickness / 2
        self._obstacles = obstacles
        self._middles = np.array([obstacle.position for obstacle in obstacles], dtype=np.float64).reshape(-1, 2)
        self._reaches = np.array([_reach(obstacle) for obstacle in obstacles])

    def along(self, points: Sequence[tuple[float, float]]) -> NarrowestPoint:
        """Return the narrowest point along the line through `points`."""
        narrowest = NO_SURFACE
        for a, b in pairwise(points):
            piece = np.array([*a, *b])
            narrowest = min(narrowest, self._from_walls(piece, narrowest.distance), key=_distance)
            least = self._least_distances(piece)
            for number in np.flatnonzero(least <= narrowest.distance).tolist():
                if least[number] <= narrowest.distance:
                    narrowest = min(narrowest, _from_obstacle(piece, self._obstacles[number]), key=_distance)
        return narrowest

    def _least_distances(self, piece: Points) -> Points:
        """Return the distance (m) of `piece` (4,) from a circle round each obstacle: the obstacle is not nearer."""
        pieces = np.broadcast_to(piece, (len(self._middles), 4))
        away = nearest_on_segments(self._middles, pieces) - self._middles
        return np.asarray(np.hypot(away[:, 0], away[:, 1]) - self._reaches)

    def _from_walls(self, piece: Points, limit: float) -> NarrowestPoint:
        """Return the point of `piece` (4,) nearest to a wall, unless all walls are further away than `limit` (m)."""
        low, high = _box_round(piece[np.newaxis])
        gaps = np.maximum(0.0, np.maximum(self._low - high, low - self._high))  # between two boxes, along x and y
        near = np.hypot(gaps[:, 0], gaps[:, 1]) <= limit + self._half_thickness + ROUNDING
        if not near.any():
            return NO_SURFACE
        distances, places = between_segments(piece, self._walls[near])
        nearest = int(np.argmin(distances))
        x, y = places[nearest]
        return NarrowestPoint(float(distances[nearest]) - self._half_thickness, float(x), float(y), None)


def _box_round(segments: Points) -> tuple[Points, Points]:
    """Return the lower left and the upper right corner (n, 2) of the upright box round each segment (n, 4)."""
    return np.minimum(segments[:, :2], segments[:, 2:]), np.maximum(segments[:, :2], segments[:, 2:])


def _distance(place: NarrowestPoint) -> float:
    return place.distance


def _reach(obstacle: Obstacle) -> float:
    """Return the radius (m) of a circle round an obstacle, a little larger than it needs to be."""
    radius = obstacle.radius if isinstance(obstacle, Cylinder) else math.hypot(*obstacle.size) / 2
    return radius + ROUNDING


def _from_obstacle(piece: Points, obstacle: Obstacle) -> NarrowestPoint:
    if isinstance(obstacle, Cylinder):
        place = nearest_on_segments(np.array(obstacle.position), piece[np.newaxis])[0]
        distance = float(np.hypot(*(place - obstacle.position))) - obstacle.radius
    else:
        distance, place = _from_box(piece, obstacle)
    return NarrowestPoint(distance, float(place[0]), float(place[1]), obstacle)


def _from_box(piece: Points, box: Box) -> tuple[float, Points]:
    if box.covers(piece[0], piece[1]):
        return 0.0, piece[:2]
    corners = np.array(box.corners())
    distances, places = between_segments(piece, np.hstack([corners, np.roll(corners, -1, axis=0)]))
    nearest = int(np.argmin(distances))
    return float(distances[nearest]), places[nearest]


def nearest_on_segments(point: Points, segments: Points) -> Points:
    """Return the point (n, 2) of each segment (n, 4) nearest to `point`: (2,) for all segments, or (n, 2) for each."""
    start, along = segments[:, :2], segments[:, 2:] - segments[:, :2]
    square = (along * along).sum(axis=1)
    share = ((point - start) * along).sum(axis=1) / np.where(square > 0, square, 1.0)
    return np.asarray(start + np.clip(share, 0.0, 1.0)[:, np.newaxis] * along)


def between_segments(piece: Points, segments: Points) -> tuple[Points, Points]:
    """Return the distance (n,) of `piece` (4,) to each of `segments` (n, 4), and the piece's nearest points (n, 2)."""
    start, end = piece[:2], piece[2:]
    candidates = [np.broadcast_to(start, (len(segments), 2)), np.broadcast_to(end, (len(segments), 2))]
    other_points = [nearest_on_segments(start, segments), nearest_on_segments(end, segments)]
    for corner in (segments[:, :2], segments[:, 2:]):
        candidates.append(nearest_on_segments(corner, piece[np.newaxis]))
        other_points.append(corner)
    places, other_array = np.stack(candidates), np.stack(other_points)
    distances = np.hypot(*np.moveaxis(places - other_array, -1, 0))
    best = np.argmin(distances, axis=0)
    rows = np.arange(len(segments))
    crossing, crossing_places = _crossings(piece, segments)
    distance = np.where(crossing, 0.0, distances[best, rows])
    return distance, np.where(crossing[:, np.newaxis], crossing_places, places[best, rows])


def _crossings(piece: Points, segments: Points) -> tuple[NDArray[np.bool_], Points]:
    """Return which of the segments (n, 4) cross the piece (4,), as (n,), and the crossings (n, 2)."""
    start, along = piece[:2], piece[2:] - piece[:2]
    others, other_along = segments[:, :2], segments[:, 2:] - segments[:, :2]
    denominator = along[0] * other_along[:, 1] - along[1] * other_along[:, 0]
    across = np.abs(denominator) > PARALLEL
    safe = np.where(across, denominator, 1.0)
    away = others - start
    share = (away[:, 0] * other_along[:, 1] - away[:, 1] * other_along[:, 0]) / safe
    other_share = (away[:, 0] * along[1] - away[:, 1] * along[0]) / safe
    crossing = across & (share >= 0) & (share <= 1) & (other_share >= 0) & (other_share <= 1)
    return crossing, start + share[:, np.newaxis] * along
