"""`bodydrive study`: the paper's experiment with simulated people, faster than real time."""

import dataclasses
import functools
import json
import os
import re
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from app.cli.errors import InputError
from app.cli.output import check_new_folder
from app.cli.study.study_interface import study_interface
from app.cli.study.study_sessions import study_sessions
from app.clock import stopwatch
from app.figures.paper import FigureFormat
from app.figures.study_figures import draw_seeds, draw_study
from app.hardware.body.person_parameters import NOVICE
from app.realtime import collect_seldom
from app.study.experiment import StudyResult, run_study
from app.study.second_process import second_process
from app.study.seeds import MEASURES, run_seeds
from app.study.seeds_files import seeds_summary, sentences, write_seeds
from app.study.sessions import Mode, PersonKind
from app.study.simulated_calibration import StudyMap
from app.study.simulated_trial import StudyTrial
from app.study.study_files import check_folder, summary, write_study
from app.world.floorplan import FloorPlan, load_floorplan
from app.world.scene import bundled_places, find_place

MOST_TRIALS = 1000
STUDY_TRIALS = 22  # the paper's
SESSION_TRIALS = 3
MOST_SESSIONS = 100
MOST_SEEDS = 1000
LARGEST_SEED = 2**31 - 1
MOST_JOBS = 256
OF_A_STUDY = re.compile(
    r"(study\.json|trials\.csv|trajectories\.parquet|(trajectories|errors)(-seed-\d+)?\.(png|svg)"
    r"|sessions\.csv|table\.txt|adaptation\.json|interface_tests\.(csv|json)|interface_table\.txt)"
).fullmatch


def study(
    out: Annotated[Path, typer.Option(help="Folder to write; it must be new or empty.")],
    trials: Annotated[
        int | None, typer.Option(min=1, max=MOST_TRIALS, help="How often the path is driven: 22, or 3 a session.")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, max=LARGEST_SEED, help="The same seed gives the same numbers.")] = 1,
    seeds: Annotated[int, typer.Option(min=1, max=MOST_SEEDS, help="How many people, from --seed on.")] = 1,
    *,
    floorplan: Annotated[str, typer.Option(help="Name of a bundled floor plan, or a JSON file.")] = "clinic",
    path: Annotated[str | None, typer.Option(help="Name of a path in it; the first when not given.")] = None,
    figure_format: Annotated[FigureFormat, typer.Option("--format", help="Of the figures.")] = "png",
    no_learning: Annotated[bool, typer.Option("--no-learning", help="Nothing that is practised stays.")] = False,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace what the folder holds.")] = False,
    adapt: Annotated[
        Mode | None, typer.Option(help="Over sessions: let the calibration follow the person, against a fixed one.")
    ] = None,
    person: Annotated[PersonKind, typer.Option(help="Over sessions: what happens to body or shirt.")] = "deteriorating",
    map_kind: Annotated[
        StudyMap, typer.Option("--map", help="With --adapt: the standard calibration, or what is learnt from the cues.")
    ] = "pca",
    sessions: Annotated[
        int, typer.Option(min=1, max=MOST_SESSIONS, help="How many, with --adapt or --interface-test.")
    ] = 10,
    interface_test: Annotated[
        bool, typer.Option("--interface-test", help="Over sessions: the two-minute test before the trials of each.")
    ] = False,
    jobs: Annotated[
        int | None,
        typer.Option(min=1, max=MOST_JOBS, help="Processes at once; as many as processors when not given."),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")] = False,
) -> None:
    """Let a simulated person calibrate, then drive a path again and again, and score every trial."""
    if seed + seeds - 1 > LARGEST_SEED:
        raise InputError(f"--seed {seed} leaves no room for --seeds {seeds}: the largest seed is {LARGEST_SEED}")
    if adapt is not None and no_learning:
        raise InputError("--no-learning goes without --adapt: over sessions the person is chosen with --person")
    if interface_test and (adapt is not None or no_learning):
        raise InputError("--interface-test goes without --adapt and --no-learning: choose one of them")
    if map_kind != "pca" and adapt is None:
        raise InputError(f"--map {map_kind} goes with --adapt: say how the calibration adapts, or leave it out")
    _check_out(out, overwrite)
    plan = find_floorplan(floorplan)
    collect_seldom()
    processes = jobs or len(os.sched_getaffinity(0))
    started = stopwatch()
    try:
        chosen = plan.path_named(path) if path is not None else plan.paths[0]
    except ValueError as error:
        raise InputError(f"--path: {error}") from error
    if chosen.task.kind in ("turn", "course"):
        raise InputError(
            f"--path {chosen.name}: it has no line to be scored beside, choose a path that is driven along"
        )
    if adapt is not None or interface_test:
        run = study_interface if adapt is None else functools.partial(study_sessions, adapt=adapt, map_kind=map_kind)
        run(
            out,
            person=person,
            sessions=sessions,
            trials=trials or SESSION_TRIALS,
            seeds=range(seed, seed + seeds),
            floorplan=plan,
            path=chosen,
            processes=processes,
            as_json=as_json,
        )
        return
    trials = trials or STUDY_TRIALS
    driver = dataclasses.replace(NOVICE, learns=not no_learning)
    try:
        if seeds == 1:
            progress = None if as_json else _Progress(trials)
            with second_process(processes) as second:
                result = run_study(trials, seed, plan, chosen.name, progress, driver, second)
                draw = functools.partial(draw_study, result, figure_format=figure_format)
                write_study(result, out, draw, overwrite, second)
            document, lines = summary(result), [result.learning[name]["text"] for name in MEASURES]
        else:
            tell = None if as_json else _tell_of_seed
            results = run_seeds(range(seed, seed + seeds), trials, plan, chosen.name, driver, tell, processes)
            write_seeds(results, out, lambda folder: draw_seeds(results, folder, figure_format), overwrite)
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
    typer.echo(f"{trials * seeds} trials in {stopwatch() - started:.1f} s, written to {out}")


def _check_out(out: Path, overwrite: bool) -> None:
    """Raise InputError unless the folder is new or empty, or holds a study that may be overwritten."""
    check_new_folder(out)
    if out.is_dir() and (foreign := sorted(entry.name for entry in out.iterdir() if not OF_A_STUDY(entry.name))):
        raise InputError(f"--out {out} holds '{foreign[0]}', which is no part of a study: name a new or empty folder")
    try:
        check_folder(out, overwrite)
    except ValueError as error:
        raise InputError(f"--out {error}") from error


def find_floorplan(name: str) -> FloorPlan:
    """Return the bundled floor plan or scene at a level of this name, or the one in the file of this name.

    Raises
    ------
    InputError
        When there is neither.
    """
    try:
        place = find_place(name)
        if place is None and not (name and os.path.exists(name)):
            known = ", ".join(bundled_places())
            raise InputError(f"--floorplan '{name}': there is no such floor plan: use {known} or a JSON file")
        return place or load_floorplan(Path(name))
    except ValueError as error:
        raise InputError(f"--floorplan {error}") from error


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


def _tell_of_seed(result: StudyResult) -> None:
    sys.stderr.write(f"seed {result.seed}: {len(result.trials)} trials driven\n")
