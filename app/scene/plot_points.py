"""The points of the clinician's plots: the trajectory, and the cross-track error of the last half minute."""

import math

import numpy as np
from numpy.typing import NDArray

from app.geometry import Pose
from app.scene.trajectory import Place, PointFilter, is_jump
from app.world.path import Path

MOST_POINTS = 500  # of the trajectory; with more, every second one is removed
SPAN = 30.0  # s of error that are shown
ERROR_EVERY = 0.1  # s
ERROR_SHOWN = 1.0  # m on each side of the path
WINDOW = 1.5  # m along the path, around the last place, that is searched for the chair's place
MARGIN = 1.5  # m around the path
EDGE = 0.01  # m that the points are kept inside the plot's range

Samples = tuple[NDArray[np.float64], ...]
Range = tuple[float, float]


class PlotSeries:
    """The points of a trajectory, and the cross-track error to its path; no error when the path `line` is None."""

    def __init__(self, line: Path | None) -> None:
        self.line = line
        self.points: list[tuple[float, float]] = []
        self.error = ErrorSamples()
        self._filter = PointFilter()
        self._last: Place | None = None
        self._along = 0.0

    def add(self, pose: Pose, t: float) -> None:
        """Add the chair's pose at `t` (s)."""
        here, now = (pose.x, pose.y), Place(pose.x, pose.y, t)
        if self._last is not None and is_jump(self._last, now):
            # The chair was put at another place: a new trajectory begins.
            self.points, self.error, self._filter = [], ErrorSamples(), PointFilter()
        self._last = now
        if self._filter.keep(pose):
            self.points.append(here)
            if len(self.points) > MOST_POINTS:
                self.points = [*self.points[:-1:2], self.points[-1]]
        if self.line is not None:
            self.error.add(t, self._cross_track(self.line, here))

    def _cross_track(self, line: Path, here: tuple[float, float]) -> float:
        self._along, across = line.project_near(*here, self._along, WINDOW)
        if abs(across) > ERROR_SHOWN:  # the chair may be near another part of the path: search the whole path
            self._along, across = line.project(*here)
        return across


class ErrorSamples:
    """The cross-track error of the last half minute, sampled every tenth of a second."""

    def __init__(self) -> None:
        count = round(SPAN / ERROR_EVERY) + 1
        self._before_now = np.linspace(-SPAN, 0.0, count)
        self._values = np.full(count, np.nan)
        self._last: int | None = None

    def add(self, t: float, error: float) -> None:
        """Add the error (m, left positive) at `t` (s), clipped to the range of the plot."""
        number = math.floor(t / ERROR_EVERY)
        if self._last is not None and number > self._last:
            passed = min(number - self._last, len(self._values))
            self._values[:-passed] = self._values[passed:]
            self._values[-passed:] = np.nan
        self._last = number if self._last is None else max(number, self._last)
        self._values[-1] = min(max(error, -ERROR_SHOWN), ERROR_SHOWN)

    def plotted(self) -> Samples:
        """Return the times (s, at most 0 = now), zeros, and the errors (m): (n,) each, NaN where no error is known."""
        return self._before_now, np.zeros_like(self._before_now), self._values.copy()


def trajectory_samples(line: Path | None, driven: list[tuple[float, float]], x_range: Range) -> Samples:
    """Return x of the path's and then the trajectory's points, y of the path, y of the trajectory: (n,) each, in m.

    Each x is clipped to `x_range`. uPlot searches the first and the last point to be drawn by bisection, which is
    correct for x values that do not rise only when all of them lie inside the range.
    """
    path = np.array(line.points if line is not None else [(0.0, math.nan)], dtype=np.float64)
    points = np.array(driven, dtype=np.float64).reshape(-1, 2)
    x = np.clip(np.concatenate([path[:, 0], points[:, 0]]), x_range[0] + EDGE, x_range[1] - EDGE)
    unknown = np.full(len(x), np.nan)
    prescribed, actual = unknown.copy(), unknown.copy()
    prescribed[: len(path)], actual[len(path) :] = path[:, 1], points[:, 1]
    return x, prescribed, actual


def trajectory_ranges(line: Path, shape: float) -> tuple[Range, Range]:
    """Return ranges of x and y (m) that show the whole path to scale in a plot `shape` times as wide as high."""
    (x_min, y_min), (x_max, y_max) = np.min(line.points, axis=0), np.max(line.points, axis=0)
    height = max(y_max - y_min, (x_max - x_min) / shape) + 2 * MARGIN
    width = shape * height
    x, y = (x_min + x_max) / 2, (y_min + y_max) / 2
    return (float(x - width / 2), float(x + width / 2)), (float(y - height / 2), float(y + height / 2))
