"""The part of a trial's trajectory that is measured: from its start to where it first reaches the goal."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.world.path import Path
from app.world.progress import LineProgress

Numbers = NDArray[np.float64]

SPACING = 0.25  # m; progress along the path is updated in steps no longer than this


class Cut(NamedTuple):
    """A trajectory from its start to the goal; `last` is the last row of the whole trajectory that is in it."""

    t: Numbers  # (n,) s
    points: Numbers  # (n, 2) m
    last: int
    reached: bool


def cut_at_goal(t: Numbers, points: Numbers, path: Path, goal_radius: float) -> Cut:
    """Return the trajectory up to where it first reaches the goal, or the whole trajectory when it never does.

    The goal is reached when the chair comes within `goal_radius` (m) of the path's end after most of the path was
    covered. The cut is at the place nearest to the path's end before the chair leaves the radius again, between two
    rows if necessary, so that trajectory and path end at the same place. A trial that was ended at the edge of the
    goal's circle ends there.
    """
    goal = np.array(path.points[-1])
    start, along = points[:-1], np.diff(points, axis=0)
    square = (along * along).sum(axis=1)
    share = np.clip(((goal - start) * along).sum(axis=1) / np.where(square > 0, square, 1.0), 0.0, 1.0)
    distance = np.hypot(*(start + share[:, np.newaxis] * along - goal).T)
    rounding = 1e-9
    inside = np.flatnonzero(distance <= goal_radius + rounding)
    inside = inside[inside >= _covered_from(points, path, goal_radius)] if len(inside) else inside
    if not len(inside):
        return Cut(t, points, len(t) - 1, False)
    apart = np.flatnonzero(np.diff(inside) > 1)
    first_stay = inside[: apart[0] + 1] if len(apart) else inside
    nearest = int(first_stay[np.argmin(distance[first_stay])])
    at = share[nearest]
    if at == 0.0:
        return Cut(t[: nearest + 1], points[: nearest + 1], nearest, True)
    end = start[nearest] + at * along[nearest]
    end_t = t[nearest] + at * (t[nearest + 1] - t[nearest])
    return Cut(
        np.append(t[: nearest + 1], end_t),
        np.vstack([points[: nearest + 1], end]),
        nearest + 1 if at == 1.0 else nearest,
        True,
    )


def _covered_from(points: Numbers, path: Path, goal_radius: float) -> int:
    """Return the first piece of the trajectory after which most of the path is covered; their number when none is."""
    progress = LineProgress(path, goal_radius)
    x, y = (float(value) for value in points[0])
    progress.update(x, y)
    for piece, (next_x, next_y) in enumerate(points[1:].tolist()):
        length = math.hypot(next_x - x, next_y - y)
        steps = max(1, math.ceil(length / SPACING))
        for step in range(1, steps + 1):
            progress.update(x + (next_x - x) * step / steps, y + (next_y - y) * step / steps)
        x, y = next_x, next_y
        if progress.covered_most:
            return piece
    return len(points) - 1
