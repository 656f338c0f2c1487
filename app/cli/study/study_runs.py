"""The runs of `bodydrive study`: trial after trial, sessions with a fixed and an adapted map, or two-minute tests."""

import csv
import dataclasses
import json
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple, TypeVar

import typer

from app.cli.errors import InputError
from app.cli.output import unwritable
from app.clock import stopwatch
from app.figures.study_figures import draw_seeds, draw_study
from app.hardware.body.person_parameters import NOVICE
from app.source import STUDY_SOURCE, source_description
from app.study.choices import FigureChoice, Mode, PersonKind, StudyMap
from app.study.comparison import compare, table
from app.study.experiment import StudyResult, run_study
from app.study.interface_sessions import InterfaceSession, interface_summary, interface_table, run_interface_seeds
from app.study.second_process import second_process
from app.study.seeds import MEASURES, run_seeds
from app.study.seeds_files import seeds_summary, sentences, write_seeds
from app.study.sessions import StudySessionTrial, run_participants
from app.study.simulated_trial import StudyTrial
from app.study.study_files import summary, write_study
from app.texts import Figure, Text, text_of
from app.world.floorplan import FloorPlan, PrescribedPath

SESSION_ROWS, SESSION_TABLE, SESSION_SUMMARY = "sessions.csv", "table.txt", "adaptation.json"
TEST_ROWS, TEST_TABLE, TEST_SUMMARY = "interface_tests.csv", "interface_table.txt", "interface_tests.json"

Row = TypeVar("Row")


class StudyRequest(NamedTuple):
    """What every kind of study is asked for."""

    out: Path
    trials: int  # of each person; with sessions, of each session
    seeds: Sequence[int]
    floorplan: FloorPlan
    path: PrescribedPath
    processes: int
    as_json: bool


@contextmanager
def _refused(out: Path) -> Iterator[None]:
    """Raise InputError where a calibration cannot be made or `out` cannot be written."""
    try:
        yield
    except ValueError as error:
        raise InputError(text_of(error)) from error
    except OSError as error:
        raise unwritable(out, error) from error


def study_trials(asked: StudyRequest, *, learns: bool, figures: FigureChoice, overwrite: bool) -> None:
    """Run every seed; write tables and figures.

    Raises
    ------
    InputError
        When the folder cannot be written, a calibration could not be made, or the figures cannot be drawn.
    """
    if figures != "none" and find_spec("matplotlib") is None:
        raise InputError(Text("cli-study-figures", format=figures))
    started = stopwatch()
    driver = dataclasses.replace(NOVICE, learns=learns)
    out, trials, seeds, plan, path, processes, as_json = asked
    with _refused(out):
        if len(seeds) == 1:
            progress = None if as_json else _Progress(trials)
            with second_process(processes, draws=figures != "none") as second:
                result = run_study(trials, seeds[0], plan, path.name, progress, driver, second)
                draw = _no_figures if figures == "none" else partial(draw_study, result, figure_format=figures)
                write_study(result, out, draw, overwrite, second)
            document, lines = summary(result), [str(result.learning[name]["text"]) for name in MEASURES]
        else:
            report = None if as_json else _report_seed
            results = run_seeds(seeds, trials, plan, path.name, driver, report, processes)
            draw = _no_figures if figures == "none" else partial(draw_seeds, results, figure_format=figures)
            write_seeds(results, out, draw, overwrite)
            document, lines = seeds_summary(results), sentences(results)
    done = Text("cli-study-trials-done", count=trials * len(seeds), seconds=_since(started), out=str(out))
    _report_results(asked, document, "\n".join(lines), done)


def _no_figures(_folder: Path) -> None:
    """Draw nothing."""


class _Progress:
    """Reports the progress on stderr."""

    def __init__(self, trials: int) -> None:
        self._trials = trials

    def __call__(self, trial: StudyTrial) -> None:
        measures = trial.measures
        progress = Text(
            "cli-study-trial" if measures["reached"] else "cli-study-trial-missed",
            number=trial.number,
            trials=self._trials,
            distance=Figure(measures["dist"], 1),
            area=Figure(measures["e_diff"], 2),
            seconds=Figure(measures["time"]),
        )
        sys.stderr.write(f"{progress}\n")


def _report_seed(result: StudyResult) -> None:
    sys.stderr.write(f"{Text('cli-study-seed-trials', seed=result.seed, count=len(result.trials))}\n")


def study_sessions(asked: StudyRequest, *, adapt: Mode, person: PersonKind, map_kind: StudyMap, sessions: int) -> None:
    """Run every seed with a fixed map and with one in the mode `adapt`; write rows, table and summary.

    Raises
    ------
    InputError
        When the folder cannot be written, or a calibration could not be made.
    """
    started = stopwatch()
    modes: tuple[Mode, ...] = ("off",) if adapt == "off" else ("off", adapt)
    out, trials, seeds, plan, path, processes, as_json = asked
    with _refused(out):
        driven = run_participants(person, seeds, modes, sessions, trials, plan, path, processes, map_kind=map_kind)
        report = None if as_json else _report_session_trials
        rows = _written_rows(out / SESSION_ROWS, driven, dataclasses.asdict, report)
        conditions = {
            "source": source_description(STUDY_SOURCE),
            "adapt": adapt,
            "person": person,
            "map": map_kind,
            "sessions": sessions,
            "trials": trials,
            "seeds": list(seeds),
            "floorplan": plan.name,
            "path": path.name,
        }
        comparison = compare([row for row in rows if row.mode == "off"], [row for row in rows if row.mode == modes[-1]])
        document, text = {**conditions, **comparison}, table(comparison)
        _write_summary(out / SESSION_SUMMARY, document, out / SESSION_TABLE, text)
    done = Text("cli-study-trials-done", count=len(rows), seconds=_since(started), out=str(out))
    _report_results(asked, document, text, done)


def _report_session_trials(rows: Sequence[StudySessionTrial]) -> None:
    for row in rows:
        progress = Text(
            "cli-study-session-trial" if row.reached else "cli-study-session-trial-missed",
            seed=row.seed,
            mode=row.mode,
            session=row.session,
            trial=row.trial,
            area=Figure(row.e_diff, 2),
        )
        sys.stderr.write(f"{progress}\n")


def study_interface(asked: StudyRequest, *, person: PersonKind, sessions: int) -> None:
    """Run every seed; write a row for each session, the table and the summary.

    Raises
    ------
    InputError
        When the folder cannot be written, or a calibration could not be made.
    """
    started = stopwatch()
    out, trials, seeds, plan, path, processes, as_json = asked
    with _refused(out):
        tested = run_interface_seeds(person, seeds, sessions, trials, plan, path, processes)
        report = None if as_json else _report_sessions
        rows = _written_rows(out / TEST_ROWS, tested, InterfaceSession.row, report)
        conditions = {
            "source": source_description(STUDY_SOURCE),
            "person": person,
            "trials": trials,
            "seed_list": list(seeds),
            "floorplan": plan.name,
            "path": path.name,
        }
        tests_summary = interface_summary(rows)
        document, text = {**conditions, **tests_summary}, interface_table(tests_summary)
        _write_summary(out / TEST_SUMMARY, document, out / TEST_TABLE, text)
    done = Text("cli-study-tests-done", count=len(rows), seconds=_since(started), out=str(out))
    _report_results(asked, document, text, done)


def _report_sessions(sessions: Sequence[InterfaceSession]) -> None:
    sys.stderr.write(f"{Text('cli-study-seed-sessions', seed=sessions[0].seed, count=len(sessions))}\n")


def _write_summary(file: Path, document: Mapping[str, object], table_file: Path, text: str) -> None:
    """Write a study's summary as JSON, and its table."""
    table_file.write_text(text, encoding="utf-8")
    file.write_text(json.dumps(document, indent=1, allow_nan=False) + "\n", encoding="utf-8")


def _since(started: float) -> Figure:
    """Return the time since `started`, s."""
    return Figure(stopwatch() - started, 1)


def _report_results(asked: StudyRequest, document: Mapping[str, object], text: str, done: Text) -> None:
    """Print a study's summary as JSON, or its table, then what was done."""
    if asked.as_json:
        typer.echo(json.dumps({"out": str(asked.out), **document}, allow_nan=False))
        return
    typer.echo(text)
    typer.echo(done)


def _written_rows(
    file: Path,
    people: Iterable[Sequence[Row]],
    fields: Callable[[Row], Mapping[str, object]],
    report: Callable[[Sequence[Row]], None] | None,
) -> list[Row]:
    """Return the rows of all people; write them to a CSV file after each, so that a failure loses one person's only."""
    file.parent.mkdir(parents=True, exist_ok=True)
    rows: list[Row] = []
    for of_person in people:
        rows += of_person
        with file.open("w", encoding="utf-8", newline="") as opened:
            writer = csv.DictWriter(opened, list(fields(rows[0])), lineterminator="\n")
            writer.writeheader()
            writer.writerows(map(fields, rows))
        if report is not None:
            report(of_person)
    return rows
