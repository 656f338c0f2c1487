"""`bodydrive study --interface-test`: the two-minute test of simulated people at the beginning of each session."""

import csv
import json
import sys
from collections.abc import Sequence
from pathlib import Path

import typer

from app.cli.errors import InputError
from app.clock import stopwatch
from app.source import STUDY_SOURCE, source_words
from app.study.choices import PersonKind
from app.study.interface_sessions import InterfaceSession, interface_summary, interface_table, run_interface_seeds
from app.world.floorplan import FloorPlan, PrescribedPath

ROWS, TABLE, SUMMARY = "interface_tests.csv", "interface_table.txt", "interface_tests.json"


def study_interface(
    out: Path,
    *,
    person: PersonKind,
    sessions: int,
    trials: int,
    seeds: Sequence[int],
    floorplan: FloorPlan,
    path: PrescribedPath,
    processes: int,
    as_json: bool,
) -> None:
    """Run every seed; write a row for each session, the table and the summary into `out`.

    Raises
    ------
    InputError
        When the folder cannot be written, or a calibration could not be made.
    """
    started = stopwatch()
    rows: list[InterfaceSession] = []
    try:
        out.mkdir(parents=True, exist_ok=True)
        for of_seed in run_interface_seeds(person, seeds, sessions, trials, floorplan, path, processes):
            rows += of_seed
            _write_rows(out, rows)  # after each person, so that a failure loses one person's results only
            if not as_json:
                sys.stderr.write(f"seed {of_seed[0].seed}: {len(of_seed)} sessions\n")
        asked = {
            "source": source_words(STUDY_SOURCE),
            "person": person,
            "trials": trials,
            "seed_list": list(seeds),
            "floorplan": floorplan.name,
            "path": path.name,
        }
        found = {**asked, **interface_summary(rows)}
        (out / TABLE).write_text(interface_table(found), encoding="utf-8")
        (out / SUMMARY).write_text(json.dumps(found, indent=1, allow_nan=False) + "\n", encoding="utf-8")
    except ValueError as error:
        raise InputError(str(error)) from error
    except OSError as error:
        raise InputError(f"--out {out} cannot be written ({error.strerror}): choose another place") from error
    if as_json:
        typer.echo(json.dumps({"out": str(out), **found}, allow_nan=False))
        return
    typer.echo(interface_table(found))
    typer.echo(f"{len(rows)} two-minute tests in {stopwatch() - started:.1f} s, written to {out}")


def _write_rows(out: Path, rows: Sequence[InterfaceSession]) -> None:
    flat = [one.row() for one in rows]
    with (out / ROWS).open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(flat[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(flat)
