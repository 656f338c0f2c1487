"""Measures what viewers of the 3D view receive and what they cost the web process, at 60 poses/s through the bridge."""

import asyncio
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from app.clock import monotonic, stopwatch
from app.scene.role_servers import ROLES
from bench.children import ask, next_line, started
from bench.circle import age_at
from bench.row import Row
from bench.web.view_client import chair_positions, open_view, packets

VIEWERS = (1, 4, 8)
RUNS = 3
SECONDS = 5.0
REACH = {4: 60.0}  # viewers: % of one core
SETTLED = 1.0  # s until the building has been sent

Packets = list[tuple[float, bytes]]  # time of arrival (monotonic s) and content of each


@dataclass(slots=True)
class ViewerFigures:
    """The figures for a number of viewers."""

    alone: float = 0.0  # % of one core without a viewer
    core: list[float] = field(default_factory=list)  # % of one core, each run
    rates: list[float] = field(default_factory=list)  # poses/s of the viewer that got fewest, each run
    ages: list[list[float]] = field(default_factory=list)  # ms, each pose of each run


def measure_viewers(numbers: Sequence[int] = VIEWERS, runs: int = RUNS, seconds: float = SECONDS) -> list[Row]:
    """Return poses a second, their age and the web process's share of a core, for several numbers of viewers.

    Raises
    ------
    RuntimeError
        When the web process does not start.
    """
    return [row for viewers in numbers for row in _rows(viewers, runs, seconds)]


def _rows(viewers: int, runs: int, seconds: float) -> list[Row]:
    with started("bench.processes.viewers_served") as web:
        try:
            port = int(next_line(web))
            found = asyncio.run(_watch(web, port, viewers, runs, seconds))
            web.communicate(timeout=10)
        finally:
            web.kill()
    core = float(np.median(found.core))
    p50, p99 = ([float(np.percentile(ages, percent)) for ages in found.ages] for percent in (50, 99))
    times = f"{runs} runs of {seconds:g} s"
    cost = f"{(core - found.alone) / viewers:.1f} % for each viewer, {found.alone:.1f} % without any; {times}"
    who = "1 viewer" if viewers == 1 else f"{viewers} viewers"
    poses = sum(map(len, found.ages))
    aged = f"from the tick to its arrival, {poses} poses; every second viewer a clinician with open plots"
    reach = REACH.get(viewers)
    return [
        Row(f"web process with {who} at 60 poses/s", found.core, "% of one core", reach, "lower", cost),
        Row(f"poses that reach a viewer, {who}", found.rates, "poses/s", None, "higher", "whoever got fewest"),
        Row(f"age of a pose that arrives, {who}: p50", p50, "ms", None, "lower", aged),
        Row(f"age of a pose that arrives, {who}: p99", p99, "ms", None, "lower", "the same poses"),
    ]


async def _watch(web: "subprocess.Popen[str]", port: int, viewers: int, runs: int, seconds: float) -> ViewerFigures:
    found = ViewerFigures()
    await asyncio.sleep(SETTLED)
    found.alone = await _core(web, seconds)
    connections = [await open_view(port, ROLES[number % len(ROLES)]) for number in range(viewers)]
    seen: list[Packets] = [[] for _ in connections]

    async def look(number: int) -> None:
        async for packet in packets(connections[number]):
            seen[number].append((monotonic(), packet))

    receiving = [asyncio.create_task(look(number)) for number in range(viewers)]
    await asyncio.sleep(SETTLED)
    for _ in range(runs):
        for one in seen:
            one.clear()
        began = stopwatch()
        found.core.append(await _core(web, seconds))
        lasted = stopwatch() - began
        # Decoded only now: decoding earlier would delay the packets that arrive.
        ages = [
            [1000 * age_at(*at, came) for came, packet in came_to_one for at in chair_positions(packet)]
            for came_to_one in [list(one) for one in seen]
        ]
        found.rates.append(min(map(len, ages)) / lasted)
        found.ages.append([age for of_viewer in ages for age in of_viewer])
    for connection in connections:
        await connection.close()
    await asyncio.gather(*receiving)
    return found


async def _core(web: "subprocess.Popen[str]", seconds: float) -> float:
    """Return the share of one core (%) that the web process uses for `seconds` from now."""
    before, began = float(await asyncio.to_thread(ask, web, "used")), stopwatch()
    await asyncio.sleep(seconds)
    after, ended = float(await asyncio.to_thread(ask, web, "used")), stopwatch()
    return 100 * (after - before) / (ended - began)
