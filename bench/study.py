"""Measures the study of the paper's experiment, figures and files included."""

import subprocess
import tempfile
from pathlib import Path

from app.clock import stopwatch
from bench.children import BODYDRIVE
from bench.row import Row

TRIALS = 22
RUNS = 3


def measure_study() -> list[Row]:
    """Return the time of `bodydrive study --trials 22`, started as a command."""
    durations = [_duration() for _ in range(RUNS)]
    return [Row(f"study --trials {TRIALS}", durations, "s", 60.0, "lower", f"{RUNS} runs, files and figures included")]


def _duration() -> float:
    with tempfile.TemporaryDirectory() as folder:
        words = ["study", "--trials", str(TRIALS), "--seed", "1", "--floorplan", "clinic"]
        before = stopwatch()
        subprocess.run(
            [*BODYDRIVE, *words, "--json", "--out", str(Path(folder) / "study")], check=True, capture_output=True
        )
        return stopwatch() - before
