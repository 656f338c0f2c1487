"""Contact of the chair with moving things: each stops the chair as a column would, and never pushes it."""

# Compiled in a wheel (hatch_build.py).

import math
from collections.abc import Sequence
from typing import Final

from app.world.footprint import CHAIR_RADIUS
from app.world.movers import Mover, Track

TOUCH: Final = 1e-3  # m; nearer than this counts as touching


class Encounters:
    """Contact of a circle of `radius` (m) with moving things."""

    __slots__ = ("_reaches", "_tracks")

    def __init__(self, movers: Sequence[Mover], radius: float = CHAIR_RADIUS) -> None:
        self._tracks = [Track(mover) for mover in movers]
        self._reaches = [mover.radius + radius for mover in movers]

    def __bool__(self) -> bool:
        """Return whether there are moving things."""
        return bool(self._tracks)

    def slide(self, x: float, y: float, new_x: float, new_y: float, scene_t: float) -> tuple[float, float, bool]:
        """Return the position after a movement from (x, y) towards (new_x, new_y), and whether the chair touches.

        Where the movement would bring the chair nearer to a thing that it touches, only the component along that thing
        is kept. A movement away from it is never restricted.
        """
        touching = False
        for track, reach in zip(self._tracks, self._reaches, strict=True):
            other = track.at(scene_t).pose
            away_x, away_y = new_x - other.x, new_y - other.y
            distance = math.hypot(away_x, away_y)
            if distance > reach + TOUCH:
                continue
            touching = True
            if distance >= reach or distance >= math.hypot(x - other.x, y - other.y) or distance == 0.0:
                continue
            away_x, away_y = away_x / distance, away_y / distance
            inwards = min(0.0, (new_x - x) * away_x + (new_y - y) * away_y)
            new_x, new_y = new_x - inwards * away_x, new_y - inwards * away_y
        return new_x, new_y, touching
