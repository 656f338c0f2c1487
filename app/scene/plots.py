"""The clinician's plots in viser's panel: the trajectory over the path, and the cross-track error."""

import math
from typing import Any, Final

import numpy as np
import viser
from numpy.typing import NDArray

from app.geometry import Pose
from app.scene.meshes import palette
from app.scene.trajectory import Place, PointFilter, is_jump
from app.texts import Text
from app.world.floorplan import FloorPlan
from app.world.path import Path

Samples = tuple[NDArray[np.float64], ...]
Range = tuple[float, float]

SEND_EVERY = 0.2  # s
HEIGHT = 150  # pixels
SHAPE = 2.2  # width over height of the trajectory's drawing area, so that x and y have one scale
NO_RANGE: Final[Range] = (-1.0, 1.0)

STROKE: Final = 2  # pixels
GRID: Final = {"stroke": "#e4e8e6", "width": 1}
TEXT: Final = "#53606c"
ZERO_LINE: Final = "#9aa7b1"

# The points that are plotted.
MOST_POINTS = 500  # of the trajectory; with more, every second one is removed
SPAN = 30.0  # s of error that are shown
ERROR_EVERY = 0.1  # s
ERROR_SHOWN = 1.0  # m on each side of the path
WINDOW = 1.5  # m along the path, around the last place, that is searched for the chair's place
MARGIN = 1.5  # m around the path
EDGE = 0.01  # m that the points are kept inside the plot's range


class Plots:
    """A panel with two plots on a 3D server; nothing is sent while the panel is closed."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._open = False
        self._sent_at = -math.inf
        self._series = PlotSeries(None)
        self._x_range: Range = NO_RANGE
        self._panel = server.gui.add_panel(visible=False)
        self._tab = self._panel.add_tab(str(Text("object-plots")))
        self._panel.float()
        self._trajectory_plot = self._add_trajectory_plot(NO_RANGE)
        self._error_plot = self._add_error_plot()

    @property
    def is_open(self) -> bool:
        """Return whether the panel is shown."""
        return self._open

    def open(self, is_open: bool) -> None:
        """Show or hide the panel."""
        self._open = is_open
        if is_open:
            self._send()
        self._panel.visible = is_open

    def show_path(self, plan: FloorPlan | None, path_name: str | None) -> None:
        """Show another path, and remove the trajectory and the error."""
        line = None if plan is None or path_name is None else plan.path_named(path_name).line
        self._series = PlotSeries(line)
        self._x_range, y_range = (NO_RANGE, NO_RANGE) if line is None else trajectory_ranges(line, SHAPE)
        self._trajectory_plot.remove()
        self._trajectory_plot = self._add_trajectory_plot(y_range)
        self.clear()

    def clear(self) -> None:
        """Remove the trajectory and the error: a new trial begins."""
        self._series = PlotSeries(self._series.line)
        self._sent_at = -math.inf
        if self._open:
            self._send()

    def add(self, pose: Pose, t: float) -> None:
        """Add the chair's pose at `t` (s), and send the plots at most five times a second."""
        self._series.add(pose, t)
        if self._open and t - self._sent_at >= SEND_EVERY:
            self._sent_at = t
            self._send()

    def _send(self) -> None:
        self._error_plot.data = self._series.error.plotted()
        self._trajectory_plot.data = self._trajectory()

    def _trajectory(self) -> Samples:
        return trajectory_samples(self._series.line, self._series.points, self._x_range)

    def _add_trajectory_plot(self, y_range: Range) -> viser.GuiUplotHandle:
        with self._tab:
            return self._server.gui.add_uplot(
                self._trajectory(),
                (
                    {},
                    {"stroke": palette.PRESCRIBED_STROKE, "width": STROKE + 1, "points": {"show": False}},
                    {"stroke": palette.DRIVEN_STROKE, "width": STROKE, "points": {"show": False}},
                ),
                title=str(Text("object-plot-driven")),
                # The ranges are fixed: a sliding axis can freeze the plot.
                scales={"x": {"time": False, "range": self._x_range}, "y": {"range": y_range}},
                axes=_axes(),
                cursor={"show": False},
                legend={"show": False},
                height=HEIGHT,
                padding=(0, 10, 0, 0),
                order=1,
            )

    def _add_error_plot(self) -> viser.GuiUplotHandle:
        with self._tab:
            return self._server.gui.add_uplot(
                self._series.error.plotted(),
                (
                    {},
                    {"stroke": ZERO_LINE, "width": 1, "points": {"show": False}},
                    {"stroke": palette.DRIVEN_STROKE, "width": STROKE, "points": {"show": False}},
                ),
                title=str(Text("object-plot-error")),
                scales={"x": {"time": False, "range": (-SPAN, 0.0)}, "y": {"range": (-ERROR_SHOWN, ERROR_SHOWN)}},
                axes=_axes(),
                cursor={"show": False},
                legend={"show": False},
                height=HEIGHT,
                padding=(0, 10, 0, 0),
                order=2,
            )


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
        place, now = (pose.x, pose.y), Place(pose.x, pose.y, t)
        if self._last is not None and is_jump(self._last, now):
            # The chair was put at another place: a new trajectory begins.
            self.points, self.error, self._filter = [], ErrorSamples(), PointFilter()
        self._last = now
        if self._filter.keep(pose):
            self.points.append(place)
            if len(self.points) > MOST_POINTS:
                self.points = [*self.points[:-1:2], self.points[-1]]
        if self.line is not None:
            self.error.add(t, self._cross_track(self.line, place))

    def _cross_track(self, line: Path, place: tuple[float, float]) -> float:
        self._along, across = line.project_near(*place, self._along, WINDOW)
        if abs(across) > ERROR_SHOWN:  # the chair may be near another part of the path: search the whole path
            self._along, across = line.project(*place)
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


def trajectory_samples(line: Path | None, trajectory: list[tuple[float, float]], x_range: Range) -> Samples:
    """Return x of the path's and then the trajectory's points, y of the path, y of the trajectory: (n,) each, in m.

    Each x is clipped to `x_range`. uPlot searches the first and the last point to be drawn by bisection, which is
    correct for x values that do not rise only when all of them lie inside the range.
    """
    path = np.array(line.points if line is not None else [(0.0, math.nan)], dtype=np.float64)
    points = np.array(trajectory, dtype=np.float64).reshape(-1, 2)
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


def _axes() -> tuple[Any, ...]:
    axis = {"stroke": TEXT, "grid": GRID, "ticks": {"show": False}, "font": "11px system-ui, sans-serif"}
    return {**axis, "size": 26}, {**axis, "size": 34}
