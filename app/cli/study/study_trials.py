"""`bodydrive study` without sessions: trial after trial of one simulated person, or of one for each seed."""

import dataclasses
import json
import sys
from collections.abc import Sequence
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import typer

from app.cli.errors import InputError
from app.clock import stopwatch
from app.figures.study_figures import draw_seeds, draw_study
from app.hardware.body.person_parameters import NOVICE
from app.study.choices import FigureChoice
from app.study.experiment import StudyResult, run_study
from app.study.second_process import second_process
from app.study.seeds import MEASURES, run_seeds
from app.study.seeds_files import seeds_summary, sentences, write_seeds
from app.study.simulated_trial import StudyTrial
from app.study.study_files import summary, write_study
from app.world.floorplan import FloorPlan, PrescribedPath


def study_trials(
    out: Path,
    *,
    learns: bool,
    trials: int,
    seeds: Sequence[int],
    floorplan: FloorPlan,
    path: PrescribedPath,
    figures: FigureChoice,
    overwrite: bool,
    processes: int,
    as_json: bool,
) -> None:
    """Run every seed; write tables and figures into `out`.

    Raises
    ------
    InputError
        When the folder cannot be written, a calibration could not be made, or the figures cannot be drawn.
    """
    if figures != "none" and find_spec("matplotlib") is None:
        raise InputError(
            f"--format {figures}: figures need the library matplotlib, install it with "
            "pip install 'bodydrive[figures]', or leave them out with --format none"
        )
    started = stopwatch()
    driver = dataclasses.replace(NOVICE, learns=learns)
    try:
        if len(seeds) == 1:
            progress = None if as_json else _Progress(trials)
            with second_process(processes, draws=figures != "none") as second:
                result = run_study(trials, seeds[0], floorplan, path.name, progress, driver, second)
                draw = _no_figures if figures == "none" else partial(draw_study, result, figure_format=figures)
                write_study(result, out, draw, overwrite, second)
            document, lines = summary(result), [result.learning[name]["text"] for name in MEASURES]
        else:
            report = None if as_json else _report_seed
            results = run_seeds(seeds, trials, floorplan, path.name, driver, report, processes)
            draw = _no_figures if figures == "none" else partial(draw_seeds, results, figure_format=figures)
            write_seeds(results, out, draw, overwrite)
            document, lines = seeds_summary(results), sentences(results)
    except ValueError as error:
        raise InputError(str(error)) from error
    except OSError as error:
        raise InputError(f"--out {out} cannot be written ({error.strerror}): choose another place") from error
    if as_json:
        typer.echo(json.dumps({"out": str(out), **document}, allow_nan=False))
        return
    for sentence in lines:
        typer.echo(sentence)
    typer.echo(f"{trials * len(seeds)} trials in {stopwatch() - started:.1f} s, written to {out}")


def _no_figures(_folder: Path) -> None:
    """Draw nothing."""


class _Progress:
    """Reports the progress on stderr."""

    def __init__(self, trials: int) -> None:
        self._trials = trials

    def __call__(self, trial: StudyTrial) -> None:
        measures: dict[str, Any] = trial.measures
        reached = "" if measures["reached"] else ", goal not reached"
        sys.stderr.write(
            f"trial {trial.number} of {self._trials}: distance driven {measures['dist']:.1f} m, "
            f"area off the path {measures['e_diff']:.2f} m², {measures['time']:.0f} s{reached}\n"
        )


def _report_seed(result: StudyResult) -> None:
    sys.stderr.write(f"seed {result.seed}: {len(result.trials)} trials driven\n")
