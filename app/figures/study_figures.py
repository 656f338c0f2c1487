"""The figures of a study, and of a study with several seeds, as files in a folder."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.figures.paper import (
    INK,
    PATH,
    TRAJECTORY,
    Trajectory,
    errors_figure,
    new_figure,
    paper_style,
    save_figure,
    style_axes,
    trajectories_figure,
)
from app.study.choices import FigureFormat
from app.study.experiment import StudyResult
from app.study.seeds import MEASURES, comparable_table

if TYPE_CHECKING:
    from matplotlib.figure import Figure


QUARTILES = (25.0, 75.0)


def draw_study(result: StudyResult, folder: Path, figure_format: FigureFormat, suffix: str = "") -> None:
    """Draw a study as the paper does: the first trajectory and all trajectories over the path, and both errors."""
    driven = [(trial.x, trial.y) for trial in result.trials]
    panels = [("(a) Trial 1", driven[:1])]
    if len(driven) > 1:
        panels.append((f"(b) All {len(driven)} trials", driven))
    over_path = trajectories_figure(result.floorplan, result.path, panels)
    save_figure(over_path, folder / f"trajectories{suffix}.{figure_format}", figure_format)
    errors = errors_figure(
        [trial.number for trial in result.trials],
        [trial.measures["dist"] for trial in result.trials],
        [trial.measures["e_diff"] for trial in result.trials],
        result.path.line.length,
        result.learning,
    )
    save_figure(errors, folder / f"errors{suffix}.{figure_format}", figure_format)


def draw_seeds(results: Sequence[StudyResult], folder: Path, figure_format: FigureFormat) -> None:
    """Draw studies of several seeds together, and the first study on its own."""
    first, last = results[0], len(results[0].trials)
    panels = [
        (f"({letter}) Trial {number}, {len(results)} people", _trajectories_of(results, number))
        for letter, number in zip("ab", dict.fromkeys((1, last)), strict=False)
    ]
    save_figure(
        trajectories_figure(first.floorplan, first.path, panels),
        folder / f"trajectories.{figure_format}",
        figure_format,
    )
    dist, e_diff = (comparable_table(results, measure) for measure in MEASURES)
    numbers = [trial.number for trial in first.trials]
    errors = errors_over_seeds_figure(numbers, dist, e_diff, first.path.line.length)
    save_figure(errors, folder / f"errors.{figure_format}", figure_format)
    draw_study(results[0], folder, figure_format, suffix=f"-seed-{results[0].seed}")


def _trajectories_of(results: Sequence[StudyResult], number: int) -> list[Trajectory]:
    return [(result.trials[number - 1].x, result.trials[number - 1].y) for result in results]


def errors_over_seeds_figure(
    numbers: Sequence[int], dist: NDArray[np.float64], e_diff: NDArray[np.float64], path_length: float
) -> Figure:
    """Draw Dist (m) and E_diff (m2) per trial, (n_seeds, n_trials) each, NaN where the goal was not reached."""
    with paper_style():
        figure, axes = new_figure(7.0, 5.4, 2)
        panels = (
            ("(a) Dist: distance driven", "Dist (m)", dist),
            ("(b) $E_{diff}$: area between trajectory and path", "$E_{diff}$ (m²)", e_diff),
        )
        n = np.asarray(numbers)
        for panel, (title, label, table) in zip(axes, panels, strict=True):
            for index, row in enumerate(table):
                one = "one person" if index == 0 else None
                panel.plot(n, row, color=INK, linewidth=0.5, alpha=0.3, label=one)
            seen = ~np.all(np.isnan(table), axis=0)
            low, high = np.nanpercentile(table[:, seen], QUARTILES, axis=0)
            panel.fill_between(n[seen], low, high, color=TRAJECTORY, alpha=0.15, linewidth=0, label="middle half")
            panel.plot(
                n[seen],
                np.nanmedian(table[:, seen], axis=0),
                "o-",
                color=TRAJECTORY,
                markersize=4,
                linewidth=1.4,
                label=f"median of {len(table)}",
            )
            panel.set_title(title, loc="left")
            panel.set_ylabel(label)
            style_axes(panel, numbers)
        axes[0].axhline(path_length, color=PATH, linewidth=1.0, linestyle="--", label="length of the path")
        axes[1].set_ylim(bottom=0.0)
        axes[0].legend(frameon=False, loc="upper right", ncols=2)
        axes[1].set_xlabel("trial")
        return figure
