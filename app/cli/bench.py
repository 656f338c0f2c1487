"""`bodydrive bench`: what was measured beside what is to be reached. It judges nothing and exits 0."""

import json
import os
import platform
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from app.bench.chain import measure_chain_step, measure_decode
from app.bench.fit import measure_fit
from app.bench.loop import measure_loop
from app.bench.row import Row
from app.bench.study import measure_study
from app.bench.viewers import measure_viewers
from app.cli.errors import InputError

PARTS: dict[str, Callable[[], list[Row]]] = {
    "chain": lambda: [measure_chain_step()],
    "loop": measure_loop,
    "decode": lambda: [measure_decode()],
    "fit": lambda: [measure_fit()],
    "study": lambda: [measure_study()],
    "viewers": measure_viewers,
}


def bench(
    parts: Annotated[list[str] | None, typer.Argument(metavar="[PART]...", help=f"Any of {', '.join(PARTS)}.")] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")] = False,
) -> None:
    """Measure how fast this machine does it, beside what is to be reached."""
    chosen = parts or list(PARTS)
    for part in chosen:
        if part not in PARTS:
            raise InputError(f"there is no part '{part}' to measure: use any of {', '.join(PARTS)}")
    rows = []
    for part in chosen:
        for row in PARTS[part]():
            rows.append(row)
            if not as_json:
                typer.echo(line(row))
    if as_json:
        typer.echo(json.dumps({"machine": machine(), "rows": [asdict(row) for row in rows]}))
    else:
        typer.echo(f"\n{machine()}")


def line(row: Row) -> str:
    """Return the row as a line of a Markdown table."""
    sign = "<=" if row.better == "lower" else ">="
    reached = "" if row.is_reached else " **not reached**"
    return f"| {row.what} | {row.figure:.3g} {row.unit} | {sign} {row.reach:g} | {row.details}{reached} |"


def machine() -> str:
    """Return what the figures were measured on."""
    name = platform.processor() or platform.machine()
    for entry in _lines_of(Path("/proc/cpuinfo")):
        if entry.startswith("model name"):
            name = entry.split(":", 1)[1].strip()
            break
    return f"{name}, {_cores()} cores, {platform.system()} {platform.release()}, Python {platform.python_version()}"


def _cores() -> int:
    return len(os.sched_getaffinity(0))


def _lines_of(file: Path) -> list[str]:
    try:
        return file.read_text().splitlines()
    except OSError:
        return []
