"""`bodydrive study`: the paper's experiment with simulated people, faster than real time."""

import os
import re
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.output import check_new_folder
from app.study.choices import FigureChoice, Mode, PersonKind, StudyMap
from app.texts import Text

if TYPE_CHECKING:
    from app.world.floorplan import FloorPlan

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
    out: Annotated[Path, typer.Option(help=help_text("cli-help-study-out"))],
    trials: Annotated[int | None, typer.Option(min=1, max=MOST_TRIALS, help=help_text("cli-help-study-trials"))] = None,
    seed: Annotated[int, typer.Option(min=0, max=LARGEST_SEED, help=help_text("cli-help-study-seed"))] = 1,
    seeds: Annotated[int, typer.Option(min=1, max=MOST_SEEDS, help=help_text("cli-help-study-seeds"))] = 1,
    *,
    floorplan: Annotated[str, typer.Option(help=help_text("cli-help-study-floorplan"))] = "clinic",
    path: Annotated[str | None, typer.Option(help=help_text("cli-help-study-path"))] = None,
    figures: Annotated[FigureChoice, typer.Option("--format", help=help_text("cli-help-study-format"))] = "png",
    no_learning: Annotated[bool, typer.Option("--no-learning", help=help_text("cli-help-study-no-learning"))] = False,
    overwrite: Annotated[bool, typer.Option("--overwrite", help=help_text("cli-help-study-overwrite"))] = False,
    adapt: Annotated[Mode | None, typer.Option(help=help_text("cli-help-study-adapt"))] = None,
    person: Annotated[PersonKind, typer.Option(help=help_text("cli-help-study-person"))] = "deteriorating",
    map_kind: Annotated[StudyMap, typer.Option("--map", help=help_text("cli-help-study-map"))] = "pca",
    sessions: Annotated[int, typer.Option(min=1, max=MOST_SESSIONS, help=help_text("cli-help-study-sessions"))] = 10,
    interface_test: Annotated[
        bool, typer.Option("--interface-test", help=help_text("cli-help-study-interface-test"))
    ] = False,
    jobs: Annotated[int | None, typer.Option(min=1, max=MOST_JOBS, help=help_text("cli-help-study-jobs"))] = None,
    as_json: AsJson = False,
) -> None:
    """Let a simulated person calibrate, then drive a path again and again, and score every trial."""
    from app.cli.study.study_runs import StudyRequest, study_interface, study_sessions, study_trials
    from app.realtime import collect_seldom

    if seed + seeds - 1 > LARGEST_SEED:
        raise InputError(Text("cli-study-seeds", seed=seed, seeds=seeds, largest=LARGEST_SEED))
    if adapt is not None and no_learning:
        raise InputError(Text("cli-study-learning"))
    if interface_test and (adapt is not None or no_learning):
        raise InputError(Text("cli-study-interface"))
    if map_kind != "pca" and adapt is None:
        raise InputError(Text("cli-study-map", map=map_kind))
    _check_out(out, overwrite)
    plan = find_floorplan(floorplan)
    try:
        chosen = plan.path_named(path) if path is not None else plan.paths[0]
    except ValueError as error:
        raise InputError(Text("cli-study-bad-path", problem=error)) from error
    if chosen.task.kind in ("turn", "course"):
        raise InputError(Text("cli-study-path", path=chosen.name))
    collect_seldom()
    run: partial[None]
    if adapt is not None:
        run = partial(study_sessions, person=person, sessions=sessions, adapt=adapt, map_kind=map_kind)
    elif interface_test:
        run = partial(study_interface, person=person, sessions=sessions)
    else:
        run = partial(study_trials, learns=not no_learning, figures=figures, overwrite=overwrite)
    asked = StudyRequest(
        out,
        trials=trials or (STUDY_TRIALS if run.func is study_trials else SESSION_TRIALS),
        seeds=range(seed, seed + seeds),
        floorplan=plan,
        path=chosen,
        processes=jobs or len(os.sched_getaffinity(0)),
        as_json=as_json,
    )
    run(asked)


def _check_out(out: Path, overwrite: bool) -> None:
    """Raise InputError unless the folder is new or empty, or holds a study that may be overwritten."""
    from app.study.study_files import check_folder

    check_new_folder(out)
    if out.is_dir() and (foreign := sorted(entry.name for entry in out.iterdir() if not OF_A_STUDY(entry.name))):
        raise InputError(Text("cli-study-foreign", folder=str(out), file=foreign[0]))
    try:
        check_folder(out, overwrite)
    except ValueError as error:
        raise InputError(Text("cli-study-bad-out", problem=error)) from error


def find_floorplan(name: str) -> "FloorPlan":
    """Return the bundled floor plan or scene at a level of this name, or the one in the file of this name.

    Raises
    ------
    InputError
        When there is neither.
    """
    from app.world.floorplan import load_floorplan
    from app.world.scene import bundled_places, find_place

    try:
        place = find_place(name)
        if place is None and not (name and os.path.exists(name)):
            names = ", ".join(bundled_places())
            raise InputError(Text("cli-study-no-plan", plan=name, names=names))
        return place or load_floorplan(Path(name))
    except ValueError as error:
        raise InputError(Text("cli-study-bad-plan", problem=error)) from error
