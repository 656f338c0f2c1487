"""`python -m large_clinic`: makes a clinic of some years and measures it; `make large-clinic`."""

import argparse
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from large_clinic.furnished import Size, furnish_years
from large_clinic.measured import REPORTS, measure, time_backups

SLOWEST_PAGE, SLOWEST_START, MOST_GROWTH = 0.3, 5.0, 50.0  # s (95th percentile), s, MB
SLOWEST_BACKUP = 120.0  # s


def main() -> int:
    """Return 0 when every limit was kept."""
    parser = argparse.ArgumentParser(prog="python -m large_clinic", description="A clinic of some years.")
    parser.add_argument("--patients", type=int, default=Size().patients)
    parser.add_argument("--sessions", type=int, default=Size().sessions, help="Of each patient.")
    parser.add_argument("--trials", type=int, default=Size().trials, help="Of each session.")
    parser.add_argument("--rounds", type=int, default=100, help="How often each page is asked for.")
    parser.add_argument("--folder", type=Path, help="Keep the clinic in this new folder.")
    given = parser.parse_args()
    size = Size(given.patients, given.sessions, given.trials)
    with tempfile.TemporaryDirectory() as made:
        state = given.folder or Path(made) / "clinic"
        state.mkdir()
        begin = time.perf_counter()
        token = furnish_years(state, size)
        lines: list[tuple[str, float, str, float | None]] = [("made in", time.perf_counter() - begin, "s", None)]
        lines.append(("database", (state / "bodydrive.sqlite").stat().st_size / 1e6, "MB", None))
        found = measure(state, token, size, given.rounds)
        backups = time_backups(state, Path(made) / "backups")
    lines.append(("start", found.start, "s", SLOWEST_START))
    lines += [
        (f"GET {address}, p95", float(np.percentile(times, 95)), "s", REPORTS.get(address, SLOWEST_PAGE))
        for address, times in found.requests.items()
    ]
    lines.append(("growth of the web process", found.memory[1] - found.memory[0], "MB", MOST_GROWTH))
    lines.append(("first backup into a folder", backups[0], "s", None))
    lines.append(("next backup, of what is new", backups[1], "s", SLOWEST_BACKUP))
    sys.stdout.write("| what | measured | at most |\n|---|---|---|\n")
    for what, figure, unit, most in lines:
        limit = "" if most is None else f"{most:g} {unit}"
        late = "" if most is None or figure <= most else " **not reached**"
        sys.stdout.write(f"| {what} | {figure:.3g} {unit} | {limit}{late} |\n")
    return int(any(most is not None and figure > most for _, figure, _, most in lines))


if __name__ == "__main__":
    sys.exit(main())
