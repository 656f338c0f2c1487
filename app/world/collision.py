"""What walls and obstacles do to a chair that drives into them: it slides along and never gets through."""

import math
from itertools import pairwise

import numpy as np

from app.world.floorplan import FloorPlan
from app.world.kinematics import CHAIR_RADIUS
from app.world.obstacles import Box, Cylinder

NEAR = 0.8  # m around the chair; walls further away are not looked at until it has moved by half of this
STEP = 0.1  # m; a longer way is gone in pieces, each far shorter than the chair's radius, so that no wall is jumped
TOUCH = 1e-3  # m; nearer than this counts as touching
ROUNDING = 1e-9  # m; what floating-point numbers may take from a distance
PUSHES = 8  # a corner of two walls needs two; beyond this the chair stays where it was

# One thing to keep away from: a segment as start, direction (unit), length; then the distance to keep from it.
# A cylinder is a segment of no length.
Edge = tuple[float, float, float, float, float, float]


class Collision:
    """A circle of `radius` (m) among a floor plan's walls and obstacles.

    Walls are as thick as the plan says, with rounded ends that lie within the drawn ones, so that a doorway is as wide
    as its gap. Nothing in it grows; only the cache of what is near changes.
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
        self._free_square = -1.0  # of the circle around (_free_x, _free_y) in which nothing is touched
        self._left_x = self._left_y = math.nan  # where it was last left, and the room there
        self._left_room = 0.0
        if not self._edges:
            self._free_square = math.inf

    def slide(self, x: float, y: float, new_x: float, new_y: float) -> tuple[float, float, bool]:
        """Return where a chair at (x, y) that wants to (new_x, new_y) comes to, and whether it touches anything there.

        The part of the way that leads along a wall is kept, the part that leads into it is not. From a place that is
        already too near to something, only ways that come no nearer are gone.
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
        """Tell whether a chair can stand at (x, y) without being inside anything."""
        if any(box.covers(x, y) for box in self._boxes):
            return False
        return _room(self._edges, x, y) >= -TOUCH

    def room(self, x: float, y: float) -> float:
        """Return the room (m) between a chair at (x, y) and the nearest wall or obstacle, negative inside of it."""
        return -1.0 if any(box.covers(x, y) for box in self._boxes) else _room(self._edges, x, y)

    def _piece(self, x: float, y: float, new_x: float, new_y: float) -> tuple[float, float, bool]:
        """Go a way that is short against the radius."""
        if math.hypot(x - self._near_x, y - self._near_y) > NEAR / 2:
            self._look_around(x, y)
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
        if before < -ROUNDING:  # too near already, so nothing is pushed
            came_x, came_y = new_x, new_y
            room = _room(near, new_x, new_y)
        moved = math.hypot(came_x - x, came_y - y)
        held = room < min(before, 0.0) - ROUNDING or moved >= self.radius + min(before, 0.0)
        if held:
            came_x, came_y, room = x, y, before
        self._left_x, self._left_y, self._left_room = came_x, came_y, room
        return came_x, came_y, held or room <= TOUCH

    def _look_around(self, x: float, y: float) -> None:
        """Keep what the chair could touch before it looks around again; in numpy, since a storey has many edges."""
        self._near_x, self._near_y = x, y
        start_x, start_y, direction_x, direction_y, length, reach = self._edge_table.T
        along = np.clip((x - start_x) * direction_x + (y - start_y) * direction_y, 0.0, length)
        distance = np.hypot(x - start_x - along * direction_x, y - start_y - along * direction_y)
        self._near = [self._edges[index] for index in np.flatnonzero(distance < reach + NEAR).tolist()]


def _room(edges: list[Edge] | tuple[Edge, ...], x: float, y: float) -> float:
    """Return the room (m) to the nearest of `edges`, negative inside."""
    return _deepest(edges, x, y)[0]


def _deepest(edges: list[Edge] | tuple[Edge, ...], x: float, y: float) -> tuple[float, float, float]:
    """Return the room (m) to the nearest of `edges`, negative inside, and the push (m) that would just clear it."""
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
                else:  # on the line itself both sides are as good
                    push_x, push_y = least * direction_y, -least * direction_x
    return least, push_x, push_y


def _edges(floorplan: FloorPlan, radius: float) -> list[Edge]:
    """Return everything that a chair's middle must keep away from."""
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
    """Return one edge, shortened at its ends by the rounding that the wall's thickness adds there."""
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
