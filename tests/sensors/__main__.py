"""`python -m sensors`: each driver at its full rate against its emulator, and the page of it; `make sensors`."""

import argparse
import os
import sys
import tempfile
from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor
from contextlib import ExitStack
from functools import partial
from multiprocessing import get_context
from pathlib import Path

import numpy as np
from sensors.measure import Measured, measurement
from sensors.subjects import SUBJECTS
from sources_tried.figures import line, section_of

from app.lsl_library import LSL_MISSING, load_lsl
from bench.tables import here

HEAD = """# Drivers, measured
Made by `make sensors`; do not edit. Each driver ran for {seconds:g} s at its full rate, {beside}, against an emulator
(the program that plays the device) in another process, which sends the time at which it measures. What people buy,
connect and press is in [Hardware](hardware.md).
{day}, commit {commit}, {machine}.
"""
FOOT = """
- **Age**: from the emulator's measurement to the frame in the control loop, by one clock. Trackers, Bluetooth sensors,
  phones and camera are on a grid of their rate, which adds up to a period; a page's samples also wait for the turn of
  the loop, at most 20 ms. Network, radio, browser and web process are not in it. Of the reference: from the grid of its
  rate.
- **Lost**: frames that the driver misses; on a grid, instants without a sample.
- **Processor**: of the process that reads the driver, with the reading of the time in each frame. For Bluetooth and
  BrainFlow also the emulators of their libraries, which stand in that process.
- **Cuts**: nothing gets through, the cable is out, or the sender ends (LSL), until no frame has come for 0.5 s; then
  the longest time to a frame. A cut is found when both come within 30 s. A pulled cable is tried again every 2 s, a
  lost LSL stream is looked for a second long.
- **Junk**: random bytes where others could send them, and the frames that came of it. The libraries of LSL and
  BrainFlow read their own network or board.
"""
LSL_LOCAL = """[multicast]
ResolveScope = machine
[lab]
KnownPeers = {{127.0.0.1}}
SessionID = sensors-{process}
[log]
level = -2
"""


def main() -> int:
    """Measure the drivers; return 0 when no frame was lost, every cut was found and no junk was a frame."""
    names = [subject.title for subject in SUBJECTS]
    parser = argparse.ArgumentParser(prog="python -m sensors", description=main.__doc__)
    parser.add_argument("--seconds", type=float, default=600.0, help="how long each driver runs")
    parser.add_argument("--cuts", type=int, default=30, help="how often each is cut off")
    parser.add_argument("--junk", type=int, default=100_000, help="pieces of junk for each")
    parser.add_argument("--jobs", type=int, default=1, help="how many drivers run side by side")
    parser.add_argument("--only", nargs="+", choices=names, default=names, help="these drivers")
    parser.add_argument("--out", type=Path, help="write the page of all drivers here")
    given = parser.parse_args()
    if given.seconds <= 0 or given.cuts < 0 or given.junk < 1 or given.jobs < 1:
        parser.error("--seconds, --junk and --jobs must be above 0, --cuts not below")
    if given.out and given.only != names:
        parser.error("--out writes all drivers: name none")
    found: list[Measured] = []
    sys.stdout.write(table_head(given.cuts, given.junk))
    with tempfile.TemporaryDirectory() as folder, ExitStack() as ended:
        left_out = [] if keep_lsl_local(Path(folder)) else ["LSL"]
        subjects = [one for one in SUBJECTS if one.title in given.only and one.title not in left_out]
        each = partial(measurement, seconds=given.seconds, cuts=given.cuts, junk=given.junk)
        side_by_side: Callable[..., Iterable[Measured]] = map
        if given.jobs > 1:  # each driver in a process of its own, whose processor time is its own
            pool = ProcessPoolExecutor(given.jobs, get_context("spawn"), max_tasks_per_child=1)
            side_by_side = ended.enter_context(pool).map
        for one in side_by_side(each, subjects):
            found.append(one)
            sys.stdout.write(row(one))
            sys.stdout.flush()
    if given.out:
        driven = section_of(given.out.read_text(encoding="utf-8")) if given.out.exists() else ""
        written = page(found, left_out, given)
        given.out.write_text(written + driven, encoding="utf-8")
    return 0 if all(map(is_kept, found)) else 1


def keep_lsl_local(folder: Path) -> bool:
    """Let LSL see this machine alone; return whether its library is here."""
    file = folder / "lsl_api.cfg"
    file.write_text(LSL_LOCAL.format(process=os.getpid()), encoding="utf-8")
    os.environ["LSLAPICFG"] = str(file)  # for the far end, too
    try:
        load_lsl()
    except LSL_MISSING:
        return False
    return True


def page(found: list[Measured], left_out: list[str], given: argparse.Namespace) -> str:
    """Return the page of what was measured, as the options of the command asked."""
    where = here()
    day = f"{where.day.day} {where.day:%B %Y}"
    beside = "one after another" if given.jobs == 1 else f"{given.jobs} side by side"
    head = HEAD.format(seconds=given.seconds, beside=beside, day=day, commit=where.commit, machine=where.machine)
    missing = f"\nNot measured, without its library: {', '.join(left_out)}.\n" if left_out else ""
    return "".join((head, "\n", table_head(given.cuts, given.junk), *map(row, found), missing, FOOT))


def table_head(cuts: int, junk: int) -> str:
    """Return the head of the table."""
    cells = [
        *("driver", "emulator", "rate, Hz", "samples", "frames", "lost", "age p50, ms", "p99, ms"),
        *("processor, ms a second", f"{cuts} cuts", f"{junk:,} pieces of junk", "a second sender"),
    ]
    return f"{line(cells)}|{'---|' * len(cells)}\n"


def row(one: Measured) -> str:
    """Return the line of a driver in the table."""
    if one.failure:
        return line([one.title, one.what, f"{one.rate:g}", f"**{one.failure}**", *["–"] * 8])
    p50, p99 = (1e3 * float(np.percentile(one.ages, share)) for share in (50, 99))
    cells = [
        *(one.title, one.what, f"{one.rate:g}", f"{one.sent:,}" if one.sent else "–", f"{one.frames:,}"),
        f"**{one.lost:,}**" if one.lost else "0",
        *(f"{p50:.1f}", f"{p99:.1f}", f"{1e3 * one.processor:.1f}"),
        f"{one.found} found, back after {one.back:.2f} s at most" if one.cuts else "–",
        *("–" if one.junk is None else f"{one.junk:,} frames", one.second or "–"),
    ]
    return line(cells)


def is_kept(one: Measured) -> bool:
    """Return whether a driver was measured, lost nothing, found every cut, and took no junk for a frame."""
    return not one.failure and one.lost == 0 and one.found == (one.cuts or 0) and not one.junk


if __name__ == "__main__":
    sys.exit(main())
