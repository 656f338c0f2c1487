"""`bodydrive study --adapt`: sessions of trials, with a fixed map and with a map that adapts to the person."""

import csv
import json
import sys
from collections.abc import Sequence
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

import typer

from app.cli.errors import InputError
from app.clock import stopwatch
from app.source import STUDY_SOURCE, source_words
from app.study.choices import Mode, PersonKind, StudyMap
from app.study.comparison import compare, table
from app.study.sessions import StudySessionTrial, run_participants
from app.world.floorplan import FloorPlan, PrescribedPath

ROWS, TABLE, SUMMARY = "sessions.csv", "table.txt", "adaptation.json"


def study_sessions(
    out: Path,
    *,
    adapt: Mode,
    person: PersonKind,
    map_kind: StudyMap,
    sessions: int,
    trials: int,
    seeds: Sequence[int],
    floorplan: FloorPlan,
    path: PrescribedPath,
    processes: int,
    as_json: bool,
) -> None:
    """Run every seed with the map fixed, and beside it as `adapt` says; write rows, table and summary into `out`.

    Raises
    ------
    InputError
        When the folder cannot be written, or a calibration could not be made.
    """
    started = stopwatch()
    rows: list[StudySessionTrial] = []
    modes: tuple[Mode, ...] = ("off",) if adapt == "off" else ("off", adapt)
    try:
        out.mkdir(parents=True, exist_ok=True)
        for of_seed in run_participants(
            person, seeds, modes, sessions, trials, floorplan, path, processes, map_kind=map_kind
        ):
            rows += of_seed
            _write_rows(out, rows)  # after each person, so that a failure loses one person's results only
            if not as_json:
                _say(of_seed)
        asked = {
            "source": source_words(STUDY_SOURCE),
            "adapt": adapt,
            "person": person,
            "map": map_kind,
            "sessions": sessions,
            "trials": trials,
            "seeds": list(seeds),
            "floorplan": floorplan.name,
            "path": path.name,
        }
        found = compare([one for one in rows if one.mode == "off"], [one for one in rows if one.mode == modes[-1]])
        (out / TABLE).write_text(table(found), encoding="utf-8")
        (out / SUMMARY).write_text(json.dumps({**asked, **found}, indent=1, allow_nan=False) + "\n", encoding="utf-8")
    except ValueError as error:
        raise InputError(str(error)) from error
    except OSError as error:
        raise InputError(f"--out {out} cannot be written ({error.strerror}): choose another place") from error
    if as_json:
        typer.echo(json.dumps({"out": str(out), **asked, **found}, allow_nan=False))
        return
    typer.echo(table(found))
    typer.echo(f"{len(rows)} trials in {stopwatch() - started:.1f} s, written to {out}")


def _write_rows(out: Path, rows: Sequence[StudySessionTrial]) -> None:
    with (out / ROWS).open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, [field.name for field in fields(StudySessionTrial)], lineterminator="\n")
        writer.writeheader()
        writer.writerows(asdict(row) for row in rows)


def _say(rows: Sequence[StudySessionTrial]) -> None:
    for row in rows:
        words: dict[str, Any] = asdict(row)
        words["ending"] = "" if row.reached else ", goal not reached"
        sys.stderr.write(
            "seed {seed}, {mode}, session {session}, trial {trial}: area off the path {e_diff:.2f} m²{ending}\n".format(
                **words
            )
        )
