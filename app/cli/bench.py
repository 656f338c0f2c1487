"""`bodydrive bench`: what was measured beside what is to be reached. It judges nothing and exits 0."""

import json
import os
import platform
from dataclasses import asdict
from importlib import import_module
from pathlib import Path
from typing import Annotated, NamedTuple

import typer

from app.bench.row import Row
from app.cli.errors import InputError


class Part(NamedTuple):
    """Something that can be measured; its module is imported only when it is asked for."""

    module: str
    function: str
    words: str


PARTS = {
    "chain": Part("app.bench.chain", "measure_chain_step", "a step from signals to the chair"),
    "gate": Part("app.bench.gate", "measure_gate", "a step of the safety gate"),
    "frame": Part("app.bench.frame", "measure_frame", "a frame to the real chair, encoded and verified"),
    "loop": Part("app.bench.loop", "measure_loop", "datagram in to datagram out"),
    "stop": Part("app.bench.stop", "measure_stop", "Stop on the tablet to the frame that stops a real chair"),
    "flood": Part("app.bench.flood", "measure_flood", "Stop on the tablet while 40 people sign in"),
    "period": Part("app.bench.period", "measure_period", "how evenly a real chair is told, under load and junk"),
    "decode": Part("app.bench.chain", "measure_decode", "decoding a recording"),
    "fit": Part("app.bench.fit", "measure_fit", "fitting a calibration"),
    "study": Part("app.bench.study", "measure_study", "the paper's experiment without a screen"),
    "viewers": Part("app.bench.viewers", "measure_viewers", "the 3D view for one, four and eight"),
    "trajectory": Part("app.bench.long_trajectory", "measure_trajectory", "a long trajectory against a short one"),
}
HELP = (
    f"What to measure, all of it when left out: {'; '.join(f'{name}: {part.words}' for name, part in PARTS.items())}."
)


def bench(
    parts: Annotated[list[str] | None, typer.Argument(metavar="[PART]...", help=HELP)] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")] = False,
) -> None:
    """Measure how fast this machine does it, beside what is to be reached."""
    chosen = parts or list(PARTS)
    for part in chosen:
        if part not in PARTS:
            raise InputError(f"there is no part '{part}' to measure: use any of {', '.join(PARTS)}")
    rows = []
    for part in chosen:
        module, function, _ = PARTS[part]
        for row in getattr(import_module(module), function)():
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
    asked = "" if row.reach is None else f"{sign} {row.reach:g}"
    return f"| {row.what} | {row.figure:.3g} {row.unit} | {asked} | {row.details}{reached} |"


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
