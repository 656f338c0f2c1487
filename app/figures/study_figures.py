"""The figures of a study: all trajectories over the path, and the two errors from trial to trial; as files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.scoring.learning import CurveDocument
from app.source import STUDY_SOURCE, source_description
from app.study.choices import FigureFormat
from app.study.experiment import StudyResult
from app.study.seeds import MEASURES, comparable_table
from app.texts import Figure as Number
from app.texts import Text
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.obstacles import Cylinder

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

QUARTILES = (25.0, 75.0)

Trajectory = tuple[NDArray[np.float64], NDArray[np.float64]]

WALL = "#b8bcc2"
OBSTACLE = "#dfe1e5"
PATH = "#1f5fbf"
TRAJECTORY = "#c8281e"
INK = "#22262b"
DOTS_PER_INCH = 200
MARK_SIZE = 6.0  # points
STYLE = {
    "font.family": "sans-serif",
    "font.size": 9.0,
    "axes.titlesize": 10.0,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.linewidth": 0.8,
    "xtick.color": INK,
    "ytick.color": INK,
    "svg.hashsalt": "bodydrive",  # equal studies give equal files
}


def draw_study(result: StudyResult, folder: Path, figure_format: FigureFormat, suffix: str = "") -> None:
    """Draw a study as the paper does: the first trajectory and all trajectories over the path, and both errors."""
    trajectories = [(trial.x, trial.y) for trial in result.trials]
    panels = [(Text("study-panel-trial", letter="a", number=1), trajectories[:1])]
    if len(trajectories) > 1:
        panels.append((Text("study-panel-all", letter="b", count=len(trajectories)), trajectories))
    over_path = _trajectories_figure(result.floorplan, result.path, panels)
    _save_figure(over_path, folder / f"trajectories{suffix}.{figure_format}", figure_format)
    errors = _errors_figure(
        [trial.number for trial in result.trials],
        [trial.measures["dist"] for trial in result.trials],
        [trial.measures["e_diff"] for trial in result.trials],
        result.path.line.length,
        result.learning,
    )
    _save_figure(errors, folder / f"errors{suffix}.{figure_format}", figure_format)


def draw_seeds(results: Sequence[StudyResult], folder: Path, figure_format: FigureFormat) -> None:
    """Draw studies of several seeds together, and the first study on its own."""
    first, last = results[0], len(results[0].trials)
    panels = [
        (
            Text("study-panel-people", letter=letter, number=number, count=len(results)),
            _trajectories_of(results, number),
        )
        for letter, number in zip("ab", dict.fromkeys((1, last)), strict=False)
    ]
    _save_figure(
        _trajectories_figure(first.floorplan, first.path, panels),
        folder / f"trajectories.{figure_format}",
        figure_format,
    )
    dist, e_diff = (comparable_table(results, measure) for measure in MEASURES)
    numbers = [trial.number for trial in first.trials]
    errors = _errors_over_seeds_figure(numbers, dist, e_diff, first.path.line.length)
    _save_figure(errors, folder / f"errors.{figure_format}", figure_format)
    draw_study(results[0], folder, figure_format, suffix=f"-seed-{results[0].seed}")


def _trajectories_of(results: Sequence[StudyResult], number: int) -> list[Trajectory]:
    return [(result.trials[number - 1].x, result.trials[number - 1].y) for result in results]


def _errors_over_seeds_figure(
    numbers: Sequence[int], dist: NDArray[np.float64], e_diff: NDArray[np.float64], path_length: float
) -> Figure:
    """Draw Dist (m) and E_diff (m2) per trial, (n_seeds, n_trials) each, NaN where the goal was not reached."""
    with _paper_style():
        figure, axes = _new_figure(7.0, 5.4, 2)
        panels = (
            (Text("study-panel-dist", letter="a"), "Dist (m)", dist),
            (Text("study-panel-area", letter="b", symbol="$E_{diff}$"), "$E_{diff}$ (m²)", e_diff),
        )
        n = np.asarray(numbers)
        for panel, (title, label, table) in zip(axes, panels, strict=True):
            for index, row in enumerate(table):
                label_of_first = Text("study-one-person") if index == 0 else None
                panel.plot(n, row, color=INK, linewidth=0.5, alpha=0.3, label=label_of_first)
            is_reached = ~np.all(np.isnan(table), axis=0)
            low, high = np.nanpercentile(table[:, is_reached], QUARTILES, axis=0)
            band = Text("study-middle-half")
            panel.fill_between(n[is_reached], low, high, color=TRAJECTORY, alpha=0.15, linewidth=0, label=band)
            panel.plot(
                n[is_reached],
                np.nanmedian(table[:, is_reached], axis=0),
                "o-",
                color=TRAJECTORY,
                markersize=4,
                linewidth=1.4,
                label=Text("study-median", count=len(table)),
            )
            panel.set_title(str(title), loc="left")
            panel.set_ylabel(label)
            _style_axes(panel, numbers)
        axes[0].axhline(path_length, color=PATH, linewidth=1.0, linestyle="--", label=Text("study-path-length"))
        axes[1].set_ylim(bottom=0.0)
        axes[0].legend(frameon=False, loc="upper right", ncols=2)
        axes[1].set_xlabel(str(Text("study-trial")))
        return figure


def _trajectories_figure(
    floorplan: FloorPlan, path: PrescribedPath, panels: Sequence[tuple[Text, Sequence[Trajectory]]]
) -> Figure:
    """Draw trajectories, each (x, y) in m, in red over the prescribed path in blue, within the walls.

    One panel for each of `panels`: its title and its trajectories.
    """
    with _paper_style():
        return _draw_trajectories(floorplan, path, panels)


def _draw_trajectories(
    floorplan: FloorPlan, path: PrescribedPath, panels: Sequence[tuple[Text, Sequence[Trajectory]]]
) -> Figure:
    x_min, y_min, x_max, y_max = floorplan.bounds
    width = 7.0
    height = min(9.0, max(2.5, width * (y_max - y_min) / max(x_max - x_min, 1e-9) + 0.5))
    figure, axes = _new_figure(width, height * len(panels), len(panels))
    for panel, (title, trajectories) in zip(axes, panels, strict=True):
        _draw_panel(panel, floorplan, path, trajectories)
        panel.set_title(str(title), loc="left")
    legend = [
        _line_of(PATH, 1.8, Text("study-prescribed-path", length=Number(path.line.length, 1))),
        _line_of(TRAJECTORY, 0.8, Text("study-trajectory")),
    ]
    figure.legend(handles=legend, loc="outside upper center", ncols=2, frameon=False)
    axes[-1].set_xlabel("x (m)")
    return figure


def _draw_panel(axes: Axes, floorplan: FloorPlan, path: PrescribedPath, trajectories: Sequence[Trajectory]) -> None:
    x_min, y_min, x_max, y_max = floorplan.bounds
    for wall in floorplan.walls:
        axes.plot(*zip(*wall, strict=True), color=WALL, linewidth=2.0, solid_capstyle="round", zorder=1)
    _draw_obstacles(axes, floorplan)
    alpha = max(0.25, 1.0 / max(1.0, len(trajectories) ** 0.4))
    for x, y in trajectories:
        axes.plot(x, y, color=TRAJECTORY, linewidth=0.8, alpha=alpha, zorder=3)
    axes.plot(*zip(*path.points, strict=True), color=PATH, linewidth=1.8, zorder=4)
    (start_x, start_y), (goal_x, goal_y) = path.points[0], path.points[-1]
    axes.plot([start_x], [start_y], "o", color=PATH, markersize=6, zorder=5)
    axes.plot([goal_x], [goal_y], "s", color=PATH, markersize=6, zorder=5)
    margin = 0.02 * max(x_max - x_min, y_max - y_min)
    axes.set_xlim(x_min - margin, x_max + margin)
    axes.set_ylim(y_min - margin, y_max + margin)
    axes.set_aspect("equal")
    axes.set_ylabel("y (m)")


def _errors_figure(
    numbers: Sequence[int],
    dist: Sequence[float],
    e_diff: Sequence[float],
    path_length: float,
    curves: Mapping[str, CurveDocument],
) -> Figure:
    """Draw Dist (m) and E_diff (m2) per trial, each with its learning curve and 95 % band where there is one."""
    with _paper_style():
        return _draw_errors(numbers, dist, e_diff, path_length, curves)


def _draw_errors(
    numbers: Sequence[int],
    dist: Sequence[float],
    e_diff: Sequence[float],
    path_length: float,
    curves: Mapping[str, CurveDocument],
) -> Figure:
    figure, axes = _new_figure(7.0, 5.4, 2)
    panels = (
        (Text("study-panel-dist", letter="a"), "Dist (m)", dist, curves.get("dist")),
        (Text("study-panel-area", letter="b", symbol="$E_{diff}$"), "$E_{diff}$ (m²)", e_diff, curves.get("e_diff")),
    )
    for panel, (title, label, values, curve) in zip(axes, panels, strict=True):
        fit = curve["fit"] if curve else None
        if fit:
            band = (fit["n"], fit["low"], fit["high"])
            panel.fill_between(*band, color=TRAJECTORY, alpha=0.12, linewidth=0, label=Text("study-band"))
            panel.plot(fit["n"], fit["value"], color=TRAJECTORY, linewidth=1.2, label=Text("study-learning-curve"))
        panel.plot(numbers, values, "o-", color=INK, markersize=4, linewidth=0.7, label=Text("study-trial"))
        panel.set_title(str(title), loc="left")
        panel.set_ylabel(label)
        _style_axes(panel, numbers)
    axes[0].axhline(path_length, color=PATH, linewidth=1.0, linestyle="--", label=Text("study-path-length"))
    axes[1].set_ylim(bottom=0.0)
    axes[0].legend(frameon=False, loc="upper right")
    axes[1].set_xlabel(str(Text("study-trial")))
    return figure


def _style_axes(axes: Axes, numbers: Sequence[int]) -> None:
    """Set the limits, frame, grid and whole numbers of a panel over trials."""
    axes.set_xlim(min(numbers) - 0.5, max(numbers) + 0.5)
    axes.locator_params(axis="x", integer=True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(axis="y", color=OBSTACLE, linewidth=0.6)
    axes.set_axisbelow(True)


def _save_figure(figure: Figure, file: Path, file_format: FigureFormat) -> None:
    """Write a figure of a study, marked as simulated; equal figures give equal bytes."""
    metadata = {"Date": None} if file_format == "svg" else {"Software": None}
    with _paper_style():
        figure.text(
            0.995, 0.005, source_description(STUDY_SOURCE), ha="right", va="bottom", size=MARK_SIZE, color="0.4"
        )
        figure.savefig(file, format=file_format, dpi=DOTS_PER_INCH, metadata=metadata)


def _paper_style() -> AbstractContextManager[None]:
    """Return a context with the style of all figures of a study, for drawing and saving."""
    from matplotlib import rc_context

    return rc_context(STYLE)


def _new_figure(width: float, height: float, rows: int) -> tuple[Figure, tuple[Axes, ...]]:
    """Return a figure (inches) with `rows` axes, one below the other, that needs no window system."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(rows, 1, sharex=True, squeeze=False)
    return figure, tuple(axes[:, 0])


def _draw_obstacles(axes: Axes, floorplan: FloorPlan) -> None:
    from matplotlib.patches import Circle, Polygon

    for obstacle in floorplan.obstacles:
        shape = (
            Circle(obstacle.position, obstacle.radius)
            if isinstance(obstacle, Cylinder)
            else Polygon(obstacle.corners())
        )
        shape.set(facecolor=OBSTACLE, edgecolor=WALL, linewidth=0.8, zorder=1)
        axes.add_patch(shape)


def _line_of(colour: str, width: float, label: Text) -> Line2D:
    """Return a line for a legend."""
    from matplotlib.lines import Line2D

    return Line2D([], [], color=colour, linewidth=width, label=str(label))
