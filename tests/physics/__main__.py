"""`python -m physics`: random drives of a chair in MuJoCo, and the built-in dynamics beside it; `make physics`."""

import argparse
import sys
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import mujoco
from physics.chair_model import PhysicalChair
from physics.drives import CELLS, STEEPEST, castor_drift, random_drive
from physics.page import fit_table, page
from physics.path_drive import compare, fit_all, path_twists

CHUNK = 10  # drives that a process takes at once


def main() -> None:
    """Drive, print the page, and write it where that is asked for."""
    parser = argparse.ArgumentParser(prog="python -m physics", description="A wheelchair in MuJoCo.")
    parser.add_argument("--drives", type=int, default=200, help="on each floor, and with castors that turn round")
    parser.add_argument("--jobs", type=int, default=1, help="how many processes drive side by side")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--fit", action="store_true", help="only fit the built-in wheelchair, and print the parameters")
    parser.add_argument("--out", type=Path, help="write the page here")
    given = parser.parse_args()
    if given.drives < 1 or given.jobs < 1:
        parser.error("--drives and --jobs: give at least 1")
    twists = path_twists(given.seed)
    fitted = fit_all(twists, given.seed)
    if given.fit:
        sys.stdout.write(f"{fit_table(fitted)}\n")
        return
    differences = compare(twists, fitted[PhysicalChair().motor_lag])
    numbers = range(given.drives)
    asked = [(cell, f"{given.seed} {cell} {number}") for cell in CELLS for number in numbers]
    with ProcessPoolExecutor(given.jobs, get_context("spawn")) as pool:
        outcomes = list(pool.map(random_drive, *zip(*asked, strict=True), chunksize=CHUNK))
        drifts = list(pool.map(castor_drift, [f"{given.seed} castors {number}" for number in numbers], chunksize=CHUNK))
    text = page(outcomes, STEEPEST, drifts, differences, fitted, mujoco.mj_versionString())
    sys.stdout.write(text)
    if given.out:
        given.out.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
