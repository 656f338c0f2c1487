"""How far along the path a chair has come: the same judgement live, in the score and in the study."""

import math

from app.world.path import Path

WINDOW = 2.0  # m of path, back and ahead, in which the chair is looked for first
NEARER = 1.0  # m by which another stretch of the path must be nearer before the chair counts as being there
BIN = 0.25  # m, the grain in which the path counts as covered
MOST = 0.5  # share of the path that must be covered before its end can be reached


class Progress:
    """Follows a chair along a path, update by update.

    A path may pass itself or end where it began, so its end counts as reached only after most of it was covered.

    Attributes
    ----------
    s : float, m along the path
    cross_track : float, m, left positive
    reached : bool
    """

    __slots__ = ("_bins", "_count", "_goal_square", "cross_track", "path", "reached", "s")

    def __init__(self, path: Path, goal_radius: float) -> None:
        self.path = path
        self._goal_square = goal_radius * goal_radius
        self._bins = bytearray(max(1, math.ceil(path.length / BIN)))
        self._count = 0
        self.s = 0.0
        self.cross_track = 0.0
        self.reached = False

    @property
    def covered(self) -> float:
        """Share of the path that the chair has been beside, 0..1."""
        return self._count / len(self._bins)

    @property
    def covered_most(self) -> bool:
        """Whether enough was covered for the end to count."""
        return self.covered >= MOST

    def update(self, x: float, y: float) -> None:
        """Take note of where the chair is now (m); between two updates it moves much less than 2 m."""
        before = self.s
        s, cross_track = self.path.project_near(x, y, before, WINDOW)
        if abs(cross_track) > NEARER:
            elsewhere, distance = self.path.project(x, y)
            if abs(distance) < abs(cross_track) - NEARER:
                s, cross_track = elsewhere, distance
        self.s, self.cross_track = s, cross_track
        self._cover(before if abs(s - before) <= WINDOW else s, s)
        if not self.reached and self.covered_most:
            goal_x, goal_y = self.path.points[-1]
            self.reached = (x - goal_x) ** 2 + (y - goal_y) ** 2 <= self._goal_square

    def _cover(self, a: float, b: float) -> None:
        last = len(self._bins) - 1
        low, high = min(int(min(a, b) / BIN), last), min(int(max(a, b) / BIN), last)
        for index in range(low, high + 1):
            if not self._bins[index]:
                self._bins[index] = 1
                self._count += 1
