"""`python -m soak`: what browsers draw, then ten minutes of viewers, one of them stopped; `make soak`."""

import argparse
import os
import platform
import statistics
import sys
from pathlib import Path

from soak.drawn import drawn
from soak.soak import COMES_BACK, LEAST_SHARE, MOST_GROWTH, STOPPED, VIEWERS, soak

WARM = 30.0  # s
EVERY = 10.0  # s

HEAD = """# Viewers

Made by `make soak`. {machine}. What comes over the wire, to viewers that draw nothing, is in `make bench`.

"""


def main():
    """Run it; return 0 when every limit was kept."""
    parser = argparse.ArgumentParser(prog="python -m soak", description="The 3D view for a long time.")
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--out", type=Path, help="A page of the documentation to write as well.")
    asked = parser.parse_args()
    minutes = asked.minutes
    if minutes < 1:
        parser.error("--minutes: give at least 1, because a stopped viewer is cut off only after 20 s")
    pictures = drawn_lines()
    found = soak(60 * minutes, WARM, EVERY)
    share, returned = found.share, float("nan") if found.returned is None else found.returned
    rows = [
        ("growth of the web process", found.growth, "MB", MOST_GROWTH, found.growth <= MOST_GROWTH),
        ("others' poses, as a share of the undisturbed ones'", share, "", LEAST_SHARE, share >= LEAST_SHARE),
        ("the stopped one was cut off", float(found.was_cut_off), "", 1.0, found.was_cut_off),
        ("longest time an other got nothing", found.longest_without, "s", 0.0, found.longest_without == 0),
        ("the stopped one has a picture again after", returned, "s", COMES_BACK, found.returned is not None),
    ]
    lines = ["| Viewer | poses/s before | with one stopped | the worst interval |", "|---|---|---|---|"]
    for viewer in range(VIEWERS):
        if viewer == STOPPED:
            lines.append(f"| {viewer + 1} | {found.rate(found.before, viewer):.1f} | stopped | |")
            continue
        worst = min(interval.rates[viewer] for interval in found.during)
        rates = (found.rate(found.before, viewer), found.rate(found.during, viewer), worst)
        lines.append(f"| {viewer + 1} | " + " | ".join(f"{rate:.1f}" for rate in rates) + " |")
    undisturbed = [rate for interval in found.during for rate in interval.undisturbed]
    lines.append(f"| undisturbed | | {statistics.median(undisturbed):.1f} | {min(undisturbed):.1f} |")
    memory = [interval.memory for interval in found.during]
    lines += [
        "",
        f"Web process: {found.before[-1].memory:.1f} MB when the viewer was stopped, {memory[-1]:.1f} MB after "
        f"{minutes:g} min, {max(memory):.1f} MB at most.",
        "",
        "| Measured | Figure | Limit | |",
        "|---|---|---|---|",
    ]
    lines += [
        f"| {what} | {figure:.2f} {unit} | {limit:g} {unit} | {'kept' if kept else '**not kept**'} |"
        for what, figure, unit, limit, kept in rows
    ]
    text = "\n".join([*pictures, *lines, ""])
    sys.stdout.write(text)
    if asked.out is not None:
        asked.out.write_text(HEAD.format(machine=machine()) + text, encoding="utf-8")
    return 0 if all(kept for *_, kept in rows) else 1


def drawn_lines():
    """Return the table of what real browsers draw."""
    lines = [
        "## What browsers draw",
        "Chromium without a graphics card: the pages draw in software, on the processors that also serve them.",
        "",
        "| pages | pictures/s, the slowest page | age of the drawn pose: p50 | p99 |",
        "|---|---|---|---|",
    ]
    for one in drawn():
        ages = f"{1e3 * one.age_p50:.0f} ms | {1e3 * one.age_p99:.0f} ms"
        lines.append(f"| {one.viewers} | {one.pictures:.1f} | {ages} |")
    return [*lines, "", "## Ten minutes, one viewer stopped"]


def machine():
    """Return in words where this was measured."""
    return f"{platform.machine()}, {os.cpu_count()} cores, {platform.system()} {platform.release()}"


if __name__ == "__main__":
    sys.exit(main())
