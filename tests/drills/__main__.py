"""`python -m drills`: all fault drills on real processes and sockets, and their table; `make drills`."""

import argparse
import os
import platform
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

from drills.drills import DRILLS, run_drill
from drills.results import HEAD

from folders import ROOT

PAGE = ROOT / "docs" / "drills.md"


def main():
    """Run the chosen drills; return 0 when every limit was kept."""
    parser = argparse.ArgumentParser(prog="python -m drills", description="Fault drills with real processes.")
    parser.add_argument("--only", nargs="+", choices=list(DRILLS), default=list(DRILLS), help="these drills")
    parser.add_argument("--share", type=float, default=1.0, help="of the runs, 0 to 1")
    parser.add_argument("--short", action="store_true", help="the few runs that `make test` does")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1, help="how many drills run side by side")
    parser.add_argument("--out", type=Path, help=f"write the page here, as {PAGE.name}")
    given = parser.parse_args()
    asked = [(name, _runs(name, given), given.seed) for name in given.only]
    results = []
    with ProcessPoolExecutor(given.jobs, get_context("spawn")) as pool:
        for result in pool.map(run_drill, *zip(*asked, strict=True)):
            results.append(result)
            sys.stdout.write("\n".join([HEAD, result.row(), *result.violations[:5], ""]))
            sys.stdout.flush()
    table = "\n".join([HEAD, *(result.row() for result in results)])
    sys.stdout.write(f"\n{table}\n")
    if given.out:
        given.out.write_text(_page(table, given.jobs))
    return 1 if any(result.violations for result in results) else 0


def _runs(name, given):
    _drill, full, short = DRILLS[name]
    return short if given.short else max(1, round(full * given.share))


def _page(table, jobs):
    machine = f"{platform.machine()}, {os.cpu_count()} cores, {platform.system()} {platform.release()}"
    asked = ["git", "rev-parse", "--short", "HEAD"]
    commit = subprocess.run(asked, cwd=ROOT, capture_output=True, text=True, check=False).stdout.strip() or "unknown"
    return f"""# Fault drills

Made by `make drills` of commit {commit}: real processes and sockets, injured at random moments while the chair cruises.
{machine}, Python {platform.python_version()}; drills side by side: {jobs}.

Times run from the injury, by one monotonic clock, as the receiver's own lines say them. A limit is what safety.md asks
of the part, and a tick or a command period where one stands between. "Machine late" is the longest time for which an
ordinary thread was not let run meanwhile; only by so much may a time lie above its limit.

{table}
"""


if __name__ == "__main__":
    sys.exit(main())
