"""The figures of a study, and of a study with several seeds, as files in a folder."""

from collections.abc import Sequence
from pathlib import Path

from app.figures.paper import Trajectory, errors_figure, save_figure, trajectories_figure
from app.figures.seed_errors import errors_over_seeds_figure
from app.study.choices import FigureFormat
from app.study.experiment import StudyResult
from app.study.seeds import MEASURES, comparable_table


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
