"""Measures how soon the demonstration prints its link, and a command its help; and the web process's memory then."""

import subprocess
from collections.abc import Collection

import psutil

from app.cli.main import COMMANDS
from app.clock import MonotonicClock, stopwatch
from bench.children import BODYDRIVE
from bench.row import Row
from bench.web.demonstration import demonstration

RUNS = 5
HELP_RUNS = 3
REACH_LINK, REACH_HELP, REACH_MEMORY = 2.8, 0.5, 150.0  # s, s, MB
SETTLED = 3.0  # s after the link


def measure_start(
    runs: int = RUNS, help_runs: int = HELP_RUNS, commands: Collection[str] = COMMANDS.keys()
) -> list[Row]:
    """Return the time to the link (s), that to the slowest help (s), and the memory of the web process (MB).

    Raises
    ------
    RuntimeError
        When the demonstration does not start.
    """
    links, memories = zip(*(_link_and_memory() for _ in range(runs)), strict=True)
    times = {name: [_help(name) for _ in range(help_runs)] for name in commands}
    slowest = max(times, key=lambda name: min(times[name]))
    of_link = f"from the command on, {runs} runs"
    of_help = f"{slowest}, of {len(times)} commands with {help_runs} runs each"
    of_memory = f"{SETTLED:g} s after it, shared parts included"
    return [
        Row("the demonstration's link", links, "s", REACH_LINK, "lower", of_link),
        Row("help of the slowest command", times[slowest], "s", REACH_HELP, "lower", of_help),
        Row("memory of the web process after the link", memories, "MB", REACH_MEMORY, "lower", of_memory),
    ]


def _link_and_memory() -> tuple[float, float]:
    before = stopwatch()
    with demonstration() as (demo, _):
        link = stopwatch() - before
        clock = MonotonicClock()
        clock.sleep_until(clock.now() + SETTLED)
        return link, psutil.Process(demo.pid).memory_info().rss / 1e6


def _help(name: str) -> float:
    before = stopwatch()
    subprocess.run([*BODYDRIVE, name, "--help"], check=True, capture_output=True)
    return stopwatch() - before
