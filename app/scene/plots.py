"""The clinician's plots in viser's panel: the trajectory over the path, and the cross-track error."""

import math
from typing import Any, Final

import viser

from app.geometry import Pose
from app.scene.meshes import palette
from app.scene.plot_points import ERROR_SHOWN, SPAN, PlotSeries, Range, Samples, trajectory_ranges, trajectory_samples
from app.world.floorplan import FloorPlan

SEND_EVERY = 0.2  # s
HEIGHT = 150  # pixels
SHAPE = 2.2  # width over height of the trajectory's drawing area, so that x and y have one scale
NO_RANGE: Final[Range] = (-1.0, 1.0)

STROKE: Final = 2  # pixels
GRID: Final[dict[str, Any]] = {"stroke": "#e4e8e6", "width": 1}
TEXT: Final = "#53606c"
ZERO_LINE: Final = "#9aa7b1"


class Plots:
    """A panel with two plots on a 3D server; nothing is sent while the panel is closed."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._open = False
        self._sent_at = -math.inf
        self._series = PlotSeries(None)
        self._x_range: Range = NO_RANGE
        self._panel = server.gui.add_panel(visible=False)
        self._tab = self._panel.add_tab("Plots")
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
                title="Driven over path, m",
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
                title="Off the path in 30 s, m",
                scales={"x": {"time": False, "range": (-SPAN, 0.0)}, "y": {"range": (-ERROR_SHOWN, ERROR_SHOWN)}},
                axes=_axes(),
                cursor={"show": False},
                legend={"show": False},
                height=HEIGHT,
                padding=(0, 10, 0, 0),
                order=2,
            )


def _axes() -> tuple[Any, ...]:
    axis = {"stroke": TEXT, "grid": GRID, "ticks": {"show": False}, "font": "11px system-ui, sans-serif"}
    return {**axis, "size": 26}, {**axis, "size": 34}
