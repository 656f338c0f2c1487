"""The figure of a study with several seeds: both measures over trials, each person's and the median."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from app.figures.paper import INK, PATH, TRAJECTORY, new_figure, paper_style, style_axes

if TYPE_CHECKING:
    from matplotlib.figure import Figure

QUARTILES = (25.0, 75.0)


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
