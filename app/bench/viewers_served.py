"""The web side of the viewers' benchmark: the real scene behind the real bridge, and a chair that drives for ever.

Prints the port it listens on; then, for each line on stdin, the seconds of processor that it has used. Ends with stdin.
"""

import asyncio
import math
import os
import socket
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import numpy as np
import uvicorn
from fastapi import FastAPI, WebSocket

from app.api.view_bridge import view_router
from app.bench.subject import bench_floorplan
from app.clock import monotonic
from app.messages import TICK
from app.scene.scene_thread import start_scene
from app.scene.servers import Role, RoleServers

TICK_RATE = 200.0  # Hz: every turn of the scene finds a new one
RADIUS = 2.0  # m, of the circle that is driven
TURN_RATE = 0.4  # rad/s


def driving(now: float) -> np.void:
    """Return the tick of a chair that drives a circle, at `now` (monotonic s)."""
    angle = TURN_RATE * now
    tick: np.void = np.zeros(1, dtype=TICK)[0]
    tick["number"], tick["t"] = int(now * TICK_RATE), now
    tick["x"], tick["y"] = RADIUS * math.cos(angle), RADIUS * math.sin(angle)
    tick["theta"] = math.remainder(angle + math.pi / 2, math.tau)
    return tick


def viewed_app(servers: RoleServers) -> FastAPI:
    """Return an application with nothing but the 3D view, open to everybody on this machine."""

    @asynccontextmanager
    async def anybody(_websocket: WebSocket, _role: Role) -> AsyncIterator[bool]:
        yield True

    app = FastAPI()
    app.include_router(view_router(servers.port, anybody, lambda: None))
    return app


async def serve() -> None:
    """Serve until stdin ends."""
    with RoleServers() as servers, socket.create_server(("127.0.0.1", 0)) as listening:
        thread = start_scene(servers, lambda: driving(monotonic()))
        plan = bench_floorplan()
        thread.scene.set_floorplan(plan, plan.paths[0].name)
        thread.scene.set_view("patient", "eye")
        thread.scene.set_view("clinician", "chase")
        thread.scene.open_plots(True)
        config = uvicorn.Config(viewed_app(servers), log_level="error", ws_per_message_deflate=False)
        server = uvicorn.Server(config)
        serving = asyncio.create_task(server.serve([listening]))
        _say(str(listening.getsockname()[1]))
        while await asyncio.to_thread(sys.stdin.readline):
            used = os.times()
            _say(f"{used.user + used.system}")
        server.should_exit = True
        await serving
        thread.stop()


def _say(line: str) -> None:
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


if __name__ == "__main__":
    asyncio.run(serve())
