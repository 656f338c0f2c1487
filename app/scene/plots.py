"""The clinician's plots inside viser's view: the trajectory over the path, and the error, in one panel."""

import math
from typing import Any, Final

import numpy as np
import viser
from numpy.typing import NDArray

from app.geometry import Pose
from app.scene import palette
from app.scene.trajectory import Thinned
from app.world.floorplan import FloorPlan
from app.world.path import Path

MOST_POINTS = 500  # of the trajectory; beyond, every second one is left out
SPAN = 30.0  # s of error shown; the axis stands still, because one that slides can freeze
ERROR_EVERY = 0.1  # s
SEND_EVERY = 0.2  # s
ERROR_SHOWN = 1.0  # m on each side
WINDOW = 1.5  # m along the path within which the chair is looked for
HEIGHT = 150  # pixels
SHAPE = 2.2  # width over height of the trajectory's drawing area: a metre is as long along x as along y
MARGIN = 1.0  # m around the plan

Samples = tuple[NDArray[np.float64], ...]
STROKE: Final = 2  # pixels
GRID: Final[dict[str, Any]] = {"stroke": "#e4e8e6", "width": 1}
TEXT: Final = "#53606c"
ZERO_LINE: Final = "#9aa7b1"


class Plots:
    """One panel with two plots on a 3D server; while it is closed nothing is sent."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._open = False
        self._line: Path | None = None
        self._plan: FloorPlan | None = None
        self._panel = server.gui.add_panel(visible=False)
        self._tab = self._panel.add_tab("Plots")
        self._panel.float()
        self._trajectory_plot: viser.GuiUplotHandle | None = None
        self._error = ErrorSamples()
        self._error_plot = self._add_error_plot()
        self.clear()

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
        """Take the plan and the path that is being driven; forgets what was driven."""
        self._plan = plan
        self._line = None if plan is None or path_name is None else plan.path_named(path_name).line
        if self._trajectory_plot is not None:
            self._trajectory_plot.remove()
            self._trajectory_plot = None
        if plan is not None:
            self._trajectory_plot = self._add_trajectory_plot(plan)
        self.clear()

    def clear(self) -> None:
        """Forget what was driven: a new trial begins."""
        self._thinned = Thinned()
        self._driven: list[tuple[float, float]] = []
        self._along = 0.0
        self._error = ErrorSamples()
        self._sent_at = -math.inf
        if self._open:
            self._send()

    def add(self, pose: Pose, t: float) -> None:
        """Take the chair's pose at `t` (s)."""
        if self._thinned.keep(pose):
            self._driven.append((pose.x, pose.y))
            if len(self._driven) > MOST_POINTS:
                self._driven = [*self._driven[:-1:2], self._driven[-1]]
        if self._line is not None:
            self._along, across = self._line.project_near(pose.x, pose.y, self._along, WINDOW)
            self._error.add(t, across)
        if self._open and t - self._sent_at >= SEND_EVERY:
            self._sent_at = t
            self._send()

    def _send(self) -> None:
        self._error_plot.data = self._error.plotted()
        if self._trajectory_plot is not None:
            self._trajectory_plot.data = trajectory_samples(self._line, self._driven)

    def _add_trajectory_plot(self, plan: FloorPlan) -> viser.GuiUplotHandle:
        x_range, y_range = trajectory_ranges(plan)
        with self._tab:
            return self._server.gui.add_uplot(
                trajectory_samples(self._line, []),
                (
                    {},
                    {"stroke": palette.PRESCRIBED_STROKE, "width": STROKE + 1, "points": {"show": False}},
                    {"stroke": palette.DRIVEN_STROKE, "width": STROKE, "points": {"show": False}},
                ),
                title="Driven (red) over path (blue), m",
                # The trajectory's x goes to and fro. uPlot draws points in their order as long as the range of x
                # is given and wider than every x.
                scales={"x": {"time": False, "range": x_range}, "y": {"range": y_range}},
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
                self._error.plotted(),
                (
                    {},
                    {"stroke": ZERO_LINE, "width": 1, "points": {"show": False}},
                    {"stroke": palette.DRIVEN_STROKE, "width": STROKE, "points": {"show": False}},
                ),
                title="Off the path, m (left up), last 30 s",
                scales={
                    "x": {"time": False, "range": (-SPAN, 0.0)},
                    "y": {"range": (-ERROR_SHOWN, ERROR_SHOWN)},
                },
                axes=_axes(),
                cursor={"show": False},
                legend={"show": False},
                height=HEIGHT,
                padding=(0, 10, 0, 0),
                order=2,
            )


class ErrorSamples:
    """The last half minute of the cross-track error, one sample a tenth of a second."""

    def __init__(self) -> None:
        count = round(SPAN / ERROR_EVERY) + 1
        self._before_now = np.linspace(-SPAN, 0.0, count)
        self._values = np.full(count, np.nan)
        self._last: int | None = None

    def add(self, t: float, error: float) -> None:
        """Take the error (m, left positive) at `t` (s); an error beyond the plot is drawn at its edge."""
        number = math.floor(t / ERROR_EVERY)
        if self._last is not None and number > self._last:
            passed = min(number - self._last, len(self._values))
            self._values[:-passed] = self._values[passed:]
            self._values[-passed:] = np.nan
        self._last = number if self._last is None else max(number, self._last)
        self._values[-1] = min(max(error, -ERROR_SHOWN), ERROR_SHOWN)

    def plotted(self) -> Samples:
        """Return seconds before now, zero, and the error: (n,) each, NaN where there is none."""
        return self._before_now, np.zeros_like(self._before_now), self._values.copy()


def trajectory_samples(line: Path | None, driven: list[tuple[float, float]]) -> Samples:
    """Return x (n,) of path and trajectory one after the other, y of the path, y of the trajectory (m)."""
    path = np.array(line.points if line is not None else [], dtype=np.float64).reshape(-1, 2)
    points = np.array(driven, dtype=np.float64).reshape(-1, 2)
    x = np.concatenate([path[:, 0], points[:, 0]])
    nothing = np.full(len(x), np.nan)
    prescribed, actual = nothing.copy(), nothing.copy()
    prescribed[: len(path)], actual[len(path) :] = path[:, 1], points[:, 1]
    return x, prescribed, actual


def trajectory_ranges(plan: FloorPlan) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the ranges of x and y (m) that show the whole plan undistorted in a plot of `SHAPE`."""
    x_min, y_min, x_max, y_max = plan.bounds
    height = max(y_max - y_min, (x_max - x_min) / SHAPE) + 2 * MARGIN
    width = SHAPE * height
    x, y = (x_min + x_max) / 2, (y_min + y_max) / 2
    return (x - width / 2, x + width / 2), (y - height / 2, y + height / 2)


def _axes() -> tuple[Any, ...]:
    axis = {"stroke": TEXT, "grid": GRID, "ticks": {"show": False}, "font": "11px system-ui, sans-serif"}
    return {**axis, "size": 26}, {**axis, "size": 34}
