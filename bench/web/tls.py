"""Measures what https costs: the same viewers of the 3D view over http and over https, in turns of one run."""

import asyncio
import ssl
import subprocess
import tempfile
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from app.clock import monotonic, stopwatch
from app.host.certificate import LocalCertificate
from app.scene.role_servers import ROLES
from bench.children import ask, next_line, started
from bench.circle import age_at
from bench.row import Row
from bench.web.view_client import chair_positions, open_view, packets

VIEWERS = 4
TURNS = 5
SECONDS = 4.0
SETTLED = 1.0  # s until the building has been sent


@dataclass(slots=True)
class Served:
    """A web process, and what was measured of it, one figure for each turn."""

    web: "subprocess.Popen[str]"
    port: int
    trust: ssl.SSLContext | None
    core: list[float] = field(default_factory=list)  # % of one core
    p99: list[float] = field(default_factory=list)  # ms, age of the poses that arrive
    first: list[float] = field(default_factory=list)  # ms from the connection to its first packet


def measure_tls(turns: int = TURNS, seconds: float = SECONDS) -> list[Row]:
    """Return processor time, the age of poses and the time to the first packet, over http and over https.

    Raises
    ------
    RuntimeError
        When a web process does not start.
    """
    with tempfile.TemporaryDirectory() as folder, ExitStack() as stack:
        certificate = LocalCertificate(Path(folder))
        trust = ssl.create_default_context(cadata=certificate.trust.root)
        both = []
        for words, trusting in (((), None), ((str(Path(folder, "machine.pem")),), trust)):
            web = stack.enter_context(started("bench.processes.viewers_served", *words))
            stack.callback(web.kill)
            both.append(Served(web, int(next_line(web)), trusting))
        asyncio.run(_take_turns(both, turns, seconds))
    who = f"{VIEWERS} viewers"
    return [
        row
        for scheme, served in zip(("http", "https"), both, strict=True)
        for row in (
            Row(f"web process with {who} over {scheme}", served.core, "% of one core", None, "lower", "in turns"),
            Row(f"age of a pose that arrives over {scheme}: p99", served.p99, "ms", None, "lower", who),
            Row(f"to the first packet over {scheme}", served.first, "ms", None, "lower", "a new connection"),
        )
    ]


async def _take_turns(both: list[Served], turns: int, seconds: float) -> None:
    for _ in range(turns):
        for served in both:
            await _turn(served, seconds)


async def _turn(served: Served, seconds: float) -> None:
    """Measure one process with viewers, while the other has none."""
    began = stopwatch()
    connections = [await open_view(served.port, ROLES[0], served.trust)]
    await anext(packets(connections[0]))
    served.first.append(1000 * (stopwatch() - began))
    connections += [await open_view(served.port, ROLES[n % len(ROLES)], served.trust) for n in range(1, VIEWERS)]
    arrived: list[tuple[float, bytes]] = []

    async def look(number: int) -> None:
        nonlocal arrived
        async for packet in packets(connections[number]):
            arrived += ((monotonic(), packet),)

    receiving = [asyncio.create_task(look(number)) for number in range(VIEWERS)]
    await asyncio.sleep(SETTLED)
    arrived.clear()
    before, began = float(await asyncio.to_thread(ask, served.web, "used")), stopwatch()
    await asyncio.sleep(seconds)
    after, ended = float(await asyncio.to_thread(ask, served.web, "used")), stopwatch()
    seen = list(arrived)
    for connection in connections:
        await connection.close()
    await asyncio.gather(*receiving)
    served.core.append(100 * (after - before) / (ended - began))
    ages = [1000 * age_at(*at, came) for came, packet in seen for at in chair_positions(packet)]
    served.p99.append(float(np.percentile(ages, 99)))
