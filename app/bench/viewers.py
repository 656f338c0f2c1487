"""What four viewers of the 3D view cost the web process, at sixty poses a second through the real bridge."""

import asyncio
import statistics
import subprocess
import sys
from typing import IO, NamedTuple

from websockets.asyncio.client import ClientConnection, connect
from websockets.typing import Subprotocol

from app.bench.row import Row
from app.clock import stopwatch
from app.scene.servers import ROLES
from app.scene.wire import SUBPROTOCOL

VIEWERS = 4
RUNS = 3
SECONDS = 5.0
REACH = 60.0  # % of one core


class Measured(NamedTuple):
    """One run: share of one core that the web process used, and messages that each viewer got in a second."""

    core: float  # %
    messages: float  # of the viewer that got fewest


def measure_viewers(viewers: int = VIEWERS, runs: int = RUNS, seconds: float = SECONDS) -> list[Row]:
    """Return the share of one core that the web process needs for its viewers: the median of several runs.

    Raises
    ------
    RuntimeError
        When the web process does not start.
    """
    with subprocess.Popen(
        [sys.executable, "-m", "app.bench.viewers_served"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as web:
        try:
            if web.stdin is None or web.stdout is None:
                raise RuntimeError("the web process of the benchmark has no pipes")
            port = web.stdout.readline().strip()
            if not port:
                raise RuntimeError("the web process of the benchmark did not start: its message stands above")
            found = asyncio.run(_watch(int(port), viewers, runs, seconds, web.stdin, web.stdout))
            web.stdin.close()
            web.wait(timeout=10)
        finally:
            web.kill()
    core = statistics.median(run.core for run in found)
    fewest = min(run.messages for run in found)
    details = (
        f"half of them clinicians with open plots; each got at least {fewest:.0f} messages/s; "
        f"median of {runs} runs of {seconds:g} s"
    )
    return [Row(f"web process with {viewers} viewers at 60 poses/s", core, "% of one core", REACH, "lower", details)]


async def _watch(port: int, viewers: int, runs: int, seconds: float, ask: IO[str], answer: IO[str]) -> list[Measured]:
    counts = [0] * viewers
    connections: list[ClientConnection] = []

    def used() -> float:
        ask.write("used\n")
        ask.flush()
        return float(answer.readline())

    async def look(number: int, connection: ClientConnection) -> None:
        async for _ in connection:
            counts[number] += 1

    for number in range(viewers):
        role = ROLES[number % len(ROLES)]
        connections.append(
            await connect(
                f"ws://127.0.0.1:{port}/view/{role}",
                subprotocols=[Subprotocol(SUBPROTOCOL)],
                compression=None,
                max_size=None,
                proxy=None,
            )
        )
    looking = [asyncio.create_task(look(number, connection)) for number, connection in enumerate(connections)]
    await asyncio.sleep(1.0)  # the building has been sent by then
    found = []
    for _ in range(runs):
        before, began, seen = await asyncio.to_thread(used), stopwatch(), list(counts)
        await asyncio.sleep(seconds)
        after, ended = await asyncio.to_thread(used), stopwatch()
        lasted = ended - began
        got = min(now - then for now, then in zip(counts, seen, strict=True))
        found.append(Measured(100 * (after - before) / lasted, got / lasted))
    for connection in connections:
        await connection.close()
    await asyncio.gather(*looking)
    return found
