"""Collision of the chair with walls and obstacles: it slides along them and never passes through."""

# Compiled in a wheel (hatch_build.py).

import math
from itertools import pairwise
from typing import Final

import numpy as np

from app.world.floorplan import FloorPlan
from app.world.footprint import CHAIR_RADIUS
from app.world.obstacles import Box, Cylinder

NEAR: Final = 0.8  # m around the chair within which edges are cached; the cache is renewed after half of this distance
STEP: Final = 0.1  # m; longer movements are divided into such steps, so that no wall is skipped
TOUCH: Final = 1e-3  # m; nearer than this counts as touching
ROUNDING: Final = 1e-9  # m; tolerance for rounding errors of distances
PUSHES: Final = 8  # a corner of two walls needs two pushes; after this many the chair stays where it was

# A segment and the distance that the chair's middle keeps from it: start x, start y, unit direction x, direction y,
# length, distance. A cylinder is a segment of length zero.
Edge = tuple[float, float, float, float, float, float]


class Collision:
    """Collision of a circle of `radius` (m) with the walls and obstacles of a floor plan.

    Walls have the plan's thickness and rounded ends that do not extend beyond the drawn ends, so that a doorway is as
    wide as the gap between two walls. The object uses constant memory; only its cache of near edges changes.
    """

    __slots__ = (
        *("_boxes", "_edges", "_edge_table", "_near", "_near_x", "_near_y"),
        *("_free_square", "_free_x", "_free_y", "_left_room", "_left_x", "_left_y", "radius"),
    )

    def __init__(self, floorplan: FloorPlan | None, radius: float = CHAIR_RADIUS) -> None:
        self.radius = radius
        self._edges: list[Edge] = [] if floorplan is None else _edges(floorplan, radius)
        self._boxes = [] if floorplan is None else [o for o in floorplan.obstacles if isinstance(o, Box)]
        self._edge_table = np.array(self._edges, dtype=np.float64).reshape(-1, 6)
        self._near: list[Edge] = []
        self._near_x = self._near_y = math.inf
        self._free_x = self._free_y = 0.0
        self._free_square = -1.0  # squared radius of the circle around (_free_x, _free_y) that touches nothing
        self._left_x = self._left_y = math.nan  # the last result of a movement near edges, and the room there
        self._left_room = 0.0
        if not self._edges:
            self._free_square = math.inf

    def slide(self, x: float, y: float, new_x: float, new_y: float) -> tuple[float, float, bool]:
        """Return the position of a chair after a movement from (x, y) towards (new_x, new_y), and whether it touches.

        Only the component of the movement along a wall is kept. From a position that is already too near to an edge,
        the chair moves only if that does not bring it nearer.
        """
        from_x, from_y = x - self._free_x, y - self._free_y
        to_x, to_y = new_x - self._free_x, new_y - self._free_y
        free = self._free_square
        if from_x * from_x + from_y * from_y < free and to_x * to_x + to_y * to_y < free:
            return new_x, new_y, False
        way_x, way_y = new_x - x, new_y - y
        pieces = max(1, math.ceil(math.hypot(way_x, way_y) / STEP))
        touching = False
        for _ in range(pieces):
            x, y, touching = self._piece(x, y, x + way_x / pieces, y + way_y / pieces)
        return x, y, touching

    def is_free(self, x: float, y: float) -> bool:
        """Return whether a chair at (x, y) overlaps no wall and no obstacle."""
        if any(box.covers(x, y) for box in self._boxes):
            return False
        return _room(self._edges, x, y) >= -TOUCH

    def room(self, x: float, y: float) -> float:
        """Return the distance (m) of a chair at (x, y) to the nearest wall or obstacle, negative when they overlap."""
        return -1.0 if any(box.covers(x, y) for box in self._boxes) else _room(self._edges, x, y)

    def _piece(self, x: float, y: float, new_x: float, new_y: float) -> tuple[float, float, bool]:
        """Make one movement that is short compared with the radius; arguments and results as of `slide`."""
        if math.hypot(x - self._near_x, y - self._near_y) > NEAR / 2:
            self._cache_near_edges(x, y)
        near = self._near
        came_x, came_y = new_x, new_y
        room = math.inf
        for _ in range(PUSHES):
            room, push_x, push_y = _deepest(near, came_x, came_y)
            if room >= -ROUNDING:
                break
            came_x += push_x
            came_y += push_y
        else:
            room = _room(near, came_x, came_y)
        if room > TOUCH and came_x == new_x and came_y == new_y:
            self._free_x, self._free_y = came_x, came_y
            reach = min(room, NEAR - math.hypot(came_x - self._near_x, came_y - self._near_y))
            self._free_square = (reach - TOUCH) ** 2
            return came_x, came_y, False
        left_here = x == self._left_x and y == self._left_y
        before = self._left_room if left_here else _room(near, x, y)
        if before < -ROUNDING:  # already too near: do not push the chair out
            came_x, came_y = new_x, new_y
            room = _room(near, new_x, new_y)
        moved = math.hypot(came_x - x, came_y - y)
        blocked = room < min(before, 0.0) - ROUNDING or moved >= self.radius + min(before, 0.0)
        if blocked:
            came_x, came_y, room = x, y, before
        self._left_x, self._left_y, self._left_room = came_x, came_y, room
        return came_x, came_y, blocked or room <= TOUCH

    def _cache_near_edges(self, x: float, y: float) -> None:
        """Cache the edges within NEAR of the chair; with numpy, because a storey has many edges."""
        self._near_x, self._near_y = x, y
        start_x, start_y, direction_x, direction_y, length, reach = self._edge_table.T
        along = np.clip((x - start_x) * direction_x + (y - start_y) * direction_y, 0.0, length)
        distance = np.hypot(x - start_x - along * direction_x, y - start_y - along * direction_y)
        self._near = [self._edges[index] for index in np.flatnonzero(distance < reach + NEAR).tolist()]


def _room(edges: list[Edge] | tuple[Edge, ...], x: float, y: float) -> float:
    """Return the distance (m) to the nearest of `edges`, negative when too near."""
    return _deepest(edges, x, y)[0]


def _deepest(edges: list[Edge] | tuple[Edge, ...], x: float, y: float) -> tuple[float, float, float]:
    """Return the distance (m) to the nearest of `edges`, negative when too near, and the push (m) that clears it."""
    least = math.inf
    push_x = push_y = 0.0
    for start_x, start_y, direction_x, direction_y, length, reach in edges:
        away_x, away_y = x - start_x, y - start_y
        along = away_x * direction_x + away_y * direction_y
        if along > 0.0:
            along = along if along < length else length
            away_x -= along * direction_x
            away_y -= along * direction_y
        distance = math.sqrt(away_x * away_x + away_y * away_y)
        if distance - reach < least:
            least = distance - reach
            if least < 0.0:
                if distance > 0.0:
                    push_x, push_y = -least * away_x / distance, -least * away_y / distance
                else:  # on the line itself: push to either side
                    push_x, push_y = least * direction_y, -least * direction_x
    return least, push_x, push_y


def _edges(floorplan: FloorPlan, radius: float) -> list[Edge]:
    """Return the edges that a chair's middle keeps a distance from: walls, sides of boxes, cylinders."""
    half = floorplan.wall_thickness / 2
    edges: list[Edge] = []
    for wall in floorplan.walls:
        last = len(wall) - 2
        for index, (a, b) in enumerate(pairwise(wall)):
            edges.append(_edge(a, b, radius + half, half if index == 0 else 0.0, half if index == last else 0.0))
    for obstacle in floorplan.obstacles:
        if isinstance(obstacle, Cylinder):
            edges.append(_edge(obstacle.position, obstacle.position, radius + obstacle.radius))
        else:
            corners = obstacle.corners()
            edges += [_edge(a, b, radius) for a, b in pairwise([*corners, corners[0]])]
    return edges


def _edge(
    a: tuple[float, float], b: tuple[float, float], reach: float, cut_start: float = 0.0, cut_end: float = 0.0
) -> Edge:
    """Return the edge from `a` to `b`, shortened at its ends (m) by the radius of the wall's rounded ends."""
    length = math.dist(a, b)
    if length <= cut_start + cut_end:
        cut_start = cut_end = 0.0
    if length == 0.0:
        return a[0], a[1], 1.0, 0.0, 0.0, reach
    direction_x, direction_y = (b[0] - a[0]) / length, (b[1] - a[1]) / length
    return (
        a[0] + cut_start * direction_x,
        a[1] + cut_start * direction_y,
        direction_x,
        direction_y,
        length - cut_start - cut_end,
        reach,
    )
