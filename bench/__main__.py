"""`python -m bench`: prints each figure beside its target.

It exits with 0 whether targets are met or not, and with 1 when a part failed.
"""

import argparse
import json
import os
import platform
import sys
import traceback
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from app.pipeline.compiled import IS_COMPILED
from bench.row import Row


class Part(NamedTuple):
    """A part of the benchmark; its module is imported only when the part is chosen."""

    module: str
    function: str
    words: str


RATIOS = "Ratios to what the same machine did in the same run:"
ABSOLUTE = "What depends on how fast this machine is:"
PARTS = {
    "chain": Part("bench.chain", "measure_chain_step", "a step from signals to the chair"),
    "gate": Part("bench.gate", "measure_gate", "a step of the safety gate"),
    "frame": Part("bench.frame", "measure_frame", "a frame to the real chair, encoded and verified"),
    "loop": Part("bench.loop", "measure_loop", "datagram in to datagram out"),
    "backup": Part("bench.beside_backup", "measure_beside_backup", "the loop beside a backup of 10 GB, and without"),
    "turn": Part("bench.turn", "measure_turn", "the parts of a turn of the loop"),
    "stop": Part("bench.web.stop", "measure_stop", "Stop on the tablet to the frame that stops a real chair"),
    "flood": Part("bench.web.busy", "measure_flood", "Stop on the tablet while 40 people sign in"),
    "pages": Part("bench.web.busy", "measure_first_pages", "Stop on the tablet while pages are opened first"),
    "records": Part("bench.web.busy", "measure_records", "Stop on the tablet while records are made and reviewed"),
    "slow": Part("bench.web.slow", "measure_slow_pages", "Stop on the tablet beside 200 pages that hardly read"),
    "review": Part("bench.web.review", "measure_review", "Stop, heartbeat and commands while somebody reviews trials"),
    "period": Part("bench.period", "measure_period", "how evenly a real chair is told, under load and junk"),
    "decode": Part("bench.chain", "measure_decode", "decoding a recording"),
    "fit": Part("bench.fit", "measure_fit", "fitting a calibration"),
    "study": Part("bench.study", "measure_study", "the paper's experiment without a screen"),
    "start": Part("bench.web.start", "measure_start", "from the command to its link or its help"),
    "session": Part("bench.web.session", "measure_session", "the web process's memory after a session, in Chromium"),
    "page": Part("bench.web.page", "measure_page", "from the address to a page that can be used, in Chromium"),
    "viewers": Part("bench.web.viewers", "measure_viewers", "the 3D view for one, four and eight"),
    "eye": Part("bench.web.eye", "measure_eye", "pictures a second of the eye's view, and of a plainer scene"),
    "tls": Part("bench.web.tls", "measure_tls", "what https costs viewers, and a first connection"),
    "report": Part("bench.report", "measure_reports", "a report of a session and of a course, as a file"),
    "exports": Part("bench.exports", "measure_exports", "10 min at 1 kHz x 52 in each format of export"),
    "trajectory": Part("bench.web.long_trajectory", "measure_trajectory", "a long trajectory against a short one"),
}


def main() -> None:
    """Measure how fast this machine does it, beside what is to be reached."""
    words = "; ".join(f"{name}: {part.words}" for name, part in PARTS.items())
    parser = argparse.ArgumentParser(prog="python -m bench", description=main.__doc__)
    parser.add_argument("parts", nargs="*", metavar="PART", help=f"What to measure, all of it when left out: {words}.")
    parser.add_argument("--json", action="store_true", help="Print one JSON object and nothing else.")
    given = parser.parse_args()
    chosen = given.parts or list(PARTS)
    for part in chosen:
        if part not in PARTS:
            parser.error(f"there is no part '{part}' to measure: use any of {', '.join(PARTS)}")
    rows: list[Row] = []
    has_failed = False
    for part in chosen:
        module, function, words = PARTS[part]
        if not given.json:
            sys.stderr.write(f"{part}: {words} ...\n")
        try:
            rows += getattr(import_module(module), function)()
        except RuntimeError as error:  # for example without a browser: the other parts are measured all the same
            sys.stderr.write(f"{part} is not measured: {error}\n")
        except Exception:  # what the other parts have measured, perhaps for an hour, is not lost
            sys.stderr.write(f"{part} is not measured, because it failed:\n{traceback.format_exc()}")
            has_failed = True
    if given.json:
        sys.stdout.write(json.dumps({"machine": machine(), "rows": [document(row) for row in rows]}) + "\n")
    else:
        sys.stdout.write(table(RATIOS, [row for row in rows if row.is_ratio]))
        sys.stdout.write(table(ABSOLUTE, [row for row in rows if not row.is_ratio]))
        sys.stdout.write(f"{machine()}\n")
    sys.exit(1 if has_failed else 0)


def document(row: Row) -> dict[str, Any]:
    """Return the row for JSON."""
    return {
        "what": row.what,
        "figure": row.figure,
        "runs": list(row.runs),
        "unit": row.unit,
        "reach": row.reach,
        "better": row.better,
        "details": row.details,
    }


def table(title: str, rows: Sequence[Row]) -> str:
    """Return the rows as a Markdown table below its title; an empty text without rows."""
    if not rows:
        return ""
    head = "| what | measured (of each run) | to be reached | details |\n|---|---|---|---|\n"
    return f"{title}\n\n{head}{''.join(map(line, rows))}\n"


def line(row: Row) -> str:
    """Return the row as a line of a Markdown table."""
    sign = "<=" if row.better == "lower" else ">="
    reached = "" if row.is_reached else " **not reached**"
    asked = "" if row.reach is None else f"{sign} {row.reach:g}"
    spread = f" ({number(min(row.runs))} to {number(max(row.runs))})" if len(row.runs) > 1 else ""
    return f"| {row.what} | {number(row.figure)} {row.unit}{spread} | {asked} | {row.details}{reached} |\n"


def number(figure: float) -> str:
    """Return a figure with three digits that count, without an exponent."""
    return f"{figure:.0f}" if abs(figure) >= 100 else f"{figure:.3g}"


def machine() -> str:
    """Return processor, cores, system and Python version of this machine, and whether bodydrive runs compiled."""
    name = platform.processor() or platform.machine()
    for entry in _lines_of(Path("/proc/cpuinfo")):
        if entry.startswith("model name"):
            name = entry.split(":", 1)[1].strip()
            break
    python = f"Python {platform.python_version()}, bodydrive {'compiled' if IS_COMPILED else 'not compiled'}"
    return f"{name}, {_cores()} cores, {platform.system()} {platform.release()}, {python}"


def _cores() -> int:
    return len(os.sched_getaffinity(0))


def _lines_of(file: Path) -> list[str]:
    try:
        return file.read_text().splitlines()
    except OSError:
        return []


if __name__ == "__main__":
    main()
