"""The web process of the viewers' benchmark: the scene behind the bridge, and a chair that drives endlessly.

With a file (a certificate and its key) as argument, it serves over https. Prints its port; then, for each line on
stdin, the processor time (s) used so far. Ends with stdin.
"""

import asyncio
import os
import socket
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

import uvicorn
from fastapi import FastAPI, WebSocket

from app.api.view.view_bridge import view_router
from app.cli.port import bind
from app.clock import monotonic
from app.scene.role_servers import Role, RoleServers
from app.scene.scene_thread import start_scene
from bench.circle import driving
from bench.subject import bench_floorplan

PING_EVERY, PING_LIMIT = 2.0, 20.0  # s, as of the application's web server


def viewed_app(servers: RoleServers) -> FastAPI:
    """Return an application with only the 3D view, open to everybody on this machine."""

    @asynccontextmanager
    async def anybody(_websocket: WebSocket, _role: Role) -> AsyncIterator[bool]:
        yield True

    app = FastAPI()
    app.include_router(view_router(servers.port, anybody, lambda: None))
    return app


async def serve(certificate: str | None) -> None:
    """Serve until stdin ends; over https with the file of a certificate and its key."""
    with RoleServers() as servers, bind("127.0.0.1", 0) as listening:
        if hasattr(socket, "TCP_USER_TIMEOUT"):
            listening.setsockopt(socket.IPPROTO_TCP, socket.TCP_USER_TIMEOUT, int(1000 * PING_LIMIT))
        thread = start_scene(servers, lambda: driving(monotonic()))
        plan = bench_floorplan()
        thread.scene.set_floorplan(plan, plan.paths[0].name)
        thread.scene.set_view("patient", "eye")
        thread.scene.set_view("clinician", "chase")
        thread.scene.open_plots(True)
        config = uvicorn.Config(
            viewed_app(servers),
            log_level="error",
            ws_per_message_deflate=False,
            ws_ping_interval=PING_EVERY,
            ws_ping_timeout=PING_LIMIT,
            ssl_certfile=certificate,
        )
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
    asyncio.run(serve(next(iter(sys.argv[1:]), None)))
