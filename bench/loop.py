"""Measures UDP in to UDP out through the control process, beside a busy web process, relative to a bare echo."""

import json
import statistics
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from bench.children import ROOT, free_ports, module, next_line, started
from bench.row import Row, reach_of

RUNS = 3
SECONDS = 12.0
WHAT = "UDP in to UDP out at 1 kHz, 52 channels, beside two browsers' worth of work, against a bare echo"
PERCENTILES = {
    "median": (50.0, reach_of(2.2, 1.9)),
    "p99": (99.0, 3.0),
    "p99.9": (99.9, 3.0),
}  # name: percentile, target


def measure_loop(runs: int = RUNS, seconds: float = SECONDS) -> list[Row]:
    """Return the time of the loop over that of the echo: median, p99 and p99.9, each the median over the runs."""
    found = [measured(seconds) for _ in range(runs)]
    armed = min(run["armed"] / run["frames"] for run in found)
    rows = []
    for name, (percentile, reach) in PERCENTILES.items():
        loop = [1e6 * float(np.percentile(run["loop"], percentile)) for run in found]
        echo = [1e6 * float(np.percentile(run["echo"], percentile)) for run in found]
        ratios = [through / bare for through, bare in zip(loop, echo, strict=True)]
        details = (
            f"{statistics.median(loop):.0f} us against {statistics.median(echo):.0f} us, {runs} runs of {seconds:g} s, "
            f"recorded, chair armed for {armed:.0%} of the time"
        )
        rows.append(Row(f"{WHAT}: {name}", ratios, "x", reach, "lower", details))
    return rows


def measured(seconds: float) -> dict[str, Any]:
    """Return the times (s) of the answers in one run."""
    shirt_port, report_port = free_ports(2)
    with (
        tempfile.TemporaryDirectory() as folder,
        started("bench.processes.load", str(shirt_port), str(report_port), f"{folder}/run") as load,
        started("bench.processes.echo") as echo,
    ):
        try:
            next_line(load)
            echo_port = next_line(echo)
            result = Path(folder) / "times.json"
            ports = [str(shirt_port), echo_port, str(report_port)]
            subprocess.run([*module("bench.processes.probe"), *ports, str(seconds), str(result)], check=True, cwd=ROOT)
            found: dict[str, Any] = json.loads(result.read_text())
        finally:
            echo.kill()
            load.communicate()
    return found
