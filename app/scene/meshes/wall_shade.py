"""How far places are from walls, and how dark corners are: less light comes to where surfaces meet."""

import math
from itertools import pairwise
from typing import Final

import numpy as np
from numpy.typing import NDArray

from app.world.floorplan import FloorPlan

Numbers = NDArray[np.float64]

REACH: Final = 0.7  # m from a corner to where the light is whole again
CORNER: Final = 0.55  # share of the light that reaches a corner
MOST_PAIRS: Final = 20_000_000  # of places and pieces of wall; a plan with more is drawn without dark corners
SHORTEST: Final = 1e-6  # m


class Pieces:
    """The straight pieces of a plan's walls.

    Attributes
    ----------
    start, end : (n, 2) array
        Ends of their middle lines, m.
    along : (n, 2) array
        Unit vectors from start to end.
    length : (n,) array
        m.
    """

    def __init__(self, plan: FloorPlan) -> None:
        edges = [(*a, *b) for wall in plan.walls for a, b in pairwise(wall) if math.dist(a, b) >= SHORTEST]
        table = np.array(edges, dtype=np.float64).reshape(-1, 4)
        self.thickness = plan.wall_thickness
        self.start, self.end = table[:, :2], table[:, 2:]
        self.length = np.hypot(*(self.end - self.start).T)
        self.along = (self.end - self.start) / self.length[:, np.newaxis]

    def __len__(self) -> int:
        """Return the number of pieces."""
        return len(self.length)

    def distance(self, places: Numbers, chosen: NDArray[np.bool_] | None = None) -> Numbers:
        """Return the distance (n,) of places (n, 2) to the nearest wall's surface; at most REACH, inside a wall 0.

        Only the pieces that are `chosen` count, when given.
        """
        nearest = np.full(len(places), REACH + self.thickness / 2)
        numbers = range(len(self)) if chosen is None else np.flatnonzero(chosen)
        if len(places) * len(numbers) <= MOST_PAIRS:
            for number in numbers:
                away = places - self.start[number]
                at = np.clip(away @ self.along[number], 0.0, self.length[number])
                away -= at[:, np.newaxis] * self.along[number]
                np.minimum(nearest, np.hypot(away[:, 0], away[:, 1]), out=nearest)
        return np.maximum(nearest - self.thickness / 2, 0.0)


def corner_shade(distance: Numbers) -> Numbers:
    """Return the share of the light at a distance (m) from a corner."""
    depth = np.clip(1.0 - distance / REACH, 0.0, 1.0)
    shade: Numbers = 1.0 - (1.0 - CORNER) * depth * depth
    return shade
