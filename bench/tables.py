"""The figures of a run as Markdown: what is printed, and the page docs/speed.md with the newest run of each build."""

import os
import platform
import re
import subprocess
from collections.abc import Sequence
from datetime import UTC, date, datetime
from pathlib import Path
from typing import NamedTuple

from app.pipeline.compiled import IS_COMPILED
from bench.children import ROOT
from bench.row import Row

RATIOS = "Ratios to what the same machine did in the same run:"
ABSOLUTE = "What depends on how fast this machine is:"
HEAD = """# How fast
Written by `make bench`; do not edit. Below is the newest run of each build.
`make bench PART=NAME` prints a part and writes nothing; `make bench-compare COMMIT=NAME` measures a commit in turn.

[A target](decisions/0035-a-ratio-to-a-datagram-holds-for-one-machine.md) holds for the machine for which it was set.
In brackets: the smallest and the largest figure of the runs. *x*: a ratio.
"""
BUILDS = {False: "Plain Python", True: "Compiled"}


class Measured(NamedTuple):
    """Where and when a run was made, and of what."""

    machine: str
    commit: str
    day: date


def here() -> Measured:
    """Return this machine, this commit and today (UTC)."""
    return Measured(machine(), commit(), datetime.now(UTC).date())


def page(old: str, rows: Sequence[Row], measured: Measured, left_out: Sequence[str], *, compiled: bool) -> str:
    """Return the page with a run of one build; of the `old` page the run of the other build stays.

    `left_out`: parts that could not be measured.
    """
    found = re.split(r"^## (.+)\n", old, flags=re.MULTILINE)[1:]
    sections = dict(zip(found[::2], found[1::2], strict=True))
    sections[BUILDS[compiled]] = section(rows, measured, left_out)
    parts = (f"## {name}\n{sections[name].strip()}\n" for name in BUILDS.values() if name in sections)
    return "\n".join([HEAD, *parts])


def section(rows: Sequence[Row], measured: Measured, left_out: Sequence[str]) -> str:
    """Return the tables of a run, below when, where and of what it was made."""
    day = f"{measured.day.day} {measured.day:%B %Y}"
    words = f"{day}, commit {measured.commit}, {measured.machine}.\n"
    if left_out:
        words += f"Not measured: {', '.join(left_out)}.\n"
    return f"{words}\n{tables(rows)}"


def tables(rows: Sequence[Row]) -> str:
    """Return the ratios, and below them what depends on the machine."""
    ratios, absolute = ([row for row in rows if row.is_ratio == is_ratio] for is_ratio in (True, False))
    return table(RATIOS, ratios) + table(ABSOLUTE, absolute)


def table(title: str, rows: Sequence[Row]) -> str:
    """Return the rows as a Markdown table below its title; an empty text without rows."""
    if not rows:
        return ""
    head = "| what | measured (of each run) | to be reached | details |\n|---|---|---|---|\n"
    before = ["", *(row.what for row in rows)]
    return f"{title}\n\n{head}{''.join(map(line, rows, before))}\n"


def line(row: Row, before: str = "") -> str:
    """Return the row as a line of a Markdown table; `before`: the name of the row before.

    What both names have in common before ": " is left out.
    """
    about, _, what = row.what.rpartition(": ")
    name = f"… {what}" if about and about == before.rpartition(": ")[0] else row.what
    sign = "<=" if row.better == "lower" else ">="
    reached = "" if row.is_reached else " **not reached**"
    asked = "" if row.reach is None else f"{sign} {row.reach:g}"
    spread = f" ({number(min(row.runs))} to {number(max(row.runs))})" if len(row.runs) > 1 else ""
    return f"| {name} | {number(row.figure)} {row.unit}{spread} | {asked} | {row.details}{reached} |\n"


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


def commit() -> str:
    """Return the short name of the commit of this tree, with a word when files differ from it."""
    short = _git("rev-parse", "--short", "HEAD")
    if not short:
        return "unknown"
    return f"{short} with changes" if _git("status", "--porcelain", "--untracked-files=no") else short


def _git(*words: str) -> str:
    try:
        ended = subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=False)
    except OSError:  # no git
        return ""
    return ended.stdout.strip() if ended.returncode == 0 else ""


def _cores() -> int:
    return len(os.sched_getaffinity(0))


def _lines_of(file: Path) -> list[str]:
    try:
        return file.read_text().splitlines()
    except OSError:
        return []
