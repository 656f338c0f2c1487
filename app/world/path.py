"""The geometry of a prescribed path: points and headings along it, and the projection of a point on it."""

# Compiled in a wheel (hatch_build.py).

import math
from bisect import bisect_right
from collections.abc import Sequence
from itertools import accumulate, pairwise

from app.texts import Text

SHORTEST_PIECE = 1e-9  # m; points closer than this are one point


class Path:
    """A line of straight pieces through points (m); repeated points count once.

    Attributes
    ----------
    points : tuple of (x, y), m
    length : float, m

    Raises
    ------
    ValueError
        When fewer than two different points are left, or one is not finite.
    """

    __slots__ = ("_directions", "_lengths", "_starts", "length", "points")

    def __init__(self, points: Sequence[Sequence[float]]) -> None:
        distinct: list[tuple[float, float]] = []
        for point in points:
            x, y = float(point[0]), float(point[1])
            if not (math.isfinite(x) and math.isfinite(y)):
                raise ValueError(Text("plan-path-not-finite"))
            if not distinct or math.hypot(x - distinct[-1][0], y - distinct[-1][1]) > SHORTEST_PIECE:
                distinct.append((x, y))
        if len(distinct) < 2:
            raise ValueError(Text("plan-path-too-short"))
        self.points = tuple(distinct)
        self._lengths = [math.dist(a, b) for a, b in pairwise(distinct)]
        self._starts = list(accumulate(self._lengths, initial=0.0))
        self._directions = [
            ((b[0] - a[0]) / n, (b[1] - a[1]) / n) for (a, b), n in zip(pairwise(distinct), self._lengths, strict=True)
        ]
        self.length = self._starts[-1]

    def point_at(self, s: float) -> tuple[float, float]:
        """Return the point (x, y) at `s` metres along the path; an end of the path for an `s` beyond it."""
        s = min(max(s, 0.0), self.length)
        piece = self._piece_at(s)
        x, y = self.points[piece]
        direction_x, direction_y = self._directions[piece]
        along = s - self._starts[piece]
        return x + along * direction_x, y + along * direction_y

    def heading_at(self, s: float) -> float:
        """Return the heading (rad) of the path at `s` metres; at a corner, that of the piece that begins there."""
        direction_x, direction_y = self._directions[self._piece_at(min(max(s, 0.0), self.length))]
        return math.atan2(direction_y, direction_x)

    def project(self, x: float, y: float) -> tuple[float, float]:
        """Return where the path is nearest to (x, y): metres along it, and the distance to it, left positive."""
        return self._nearest(x, y, 0.0, self.length)

    def project_near(self, x: float, y: float, s_hint: float, window: float) -> tuple[float, float]:
        """Return `project`, restricted to the path from `s_hint - window` to `s_hint + window` (m).

        Near a crossing of the path with itself, the hint (the previous s) decides on which part the chair is.
        """
        s_hint = min(max(s_hint, 0.0), self.length)
        return self._nearest(x, y, max(s_hint - window, 0.0), min(s_hint + window, self.length))

    def _piece_at(self, s: float) -> int:
        return min(bisect_right(self._starts, s) - 1, len(self._lengths) - 1)

    def _nearest(self, x: float, y: float, s_from: float, s_to: float) -> tuple[float, float]:
        best, best_s, best_piece = math.inf, s_from, 0
        for piece in range(self._piece_at(s_from), self._piece_at(s_to) + 1):
            start = self._starts[piece]
            point_x, point_y = self.points[piece]
            direction_x, direction_y = self._directions[piece]
            away_x, away_y = x - point_x, y - point_y
            along = away_x * direction_x + away_y * direction_y
            low, high = max(s_from - start, 0.0), min(s_to - start, self._lengths[piece])
            along = low if along < low else min(along, high)
            away_x -= along * direction_x
            away_y -= along * direction_y
            square = away_x * away_x + away_y * away_y
            if square < best:
                best, best_s, best_piece = square, start + along, piece
        distance = math.sqrt(best)
        return best_s, distance if self._left_of(x, y, best_s, best_piece) else -distance

    def _left_of(self, x: float, y: float, s: float, piece: int) -> bool:
        """Return whether a point is left of the path; at a corner, by the mean direction of both pieces."""
        direction_x, direction_y = self._directions[piece]
        base_x, base_y = self.points[piece]
        if piece + 1 < len(self._directions) and s >= self._starts[piece + 1]:
            direction_x += self._directions[piece + 1][0]
            direction_y += self._directions[piece + 1][1]
            base_x, base_y = self.points[piece + 1]
        elif piece > 0 and s <= self._starts[piece]:
            direction_x += self._directions[piece - 1][0]
            direction_y += self._directions[piece - 1][1]
        return direction_x * (y - base_y) - direction_y * (x - base_x) >= 0.0
