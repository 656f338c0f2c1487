"""A web process with nothing but the 3D view, and a chair that drives along the path: for the tests of the view.

python tests/browser/served/view_app.py --floorplan clinic --port 8090
"""

import argparse
import math
import sys
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

import numpy as np
import uvicorn

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))  # for its own start, outside of the tests

from browser.served.served_clinic import ServedApp
from fastapi import FastAPI, WebSocket

from app.api.view.view_bridge import view_router
from app.api.view.view_controls import view_controls
from app.cli.port import bind
from app.clock import monotonic
from app.geometry import Pose
from app.messages import TICK
from app.scene.role_servers import Role, RoleServers
from app.scene.scene_thread import SceneThread, start_scene
from app.world.floorplan import FloorPlan, bundled_floorplans, load_floorplan
from app.world.scene import bundled_scenes, load_scene

SPEED = 0.8  # m/s


class Ride:
    """Ticks of a chair that follows a path, swaying a little, again and again."""

    def __init__(self, plan: FloorPlan, path_name: str) -> None:
        self.line = plan.path_named(path_name).line
        self.held_at: float | None = None  # m along the path; None: it drives
        self.head = (math.nan, math.nan, math.nan)  # rad: yaw, pitch, roll
        self._began = monotonic()

    def tick(self) -> np.void:
        """Return the tick of this moment."""
        now = monotonic()
        along = ((now - self._began) * SPEED) % self.line.length if self.held_at is None else self.held_at
        pose = self.pose(along)
        tick = np.zeros(1, dtype=TICK)[0]
        tick["number"] = int((now - self._began) * 100) + 1
        tick["t"], tick["x"], tick["y"], tick["theta"] = now, *pose
        tick["scene_t"] = along / SPEED
        tick["head_yaw"], tick["head_pitch"], tick["head_roll"], tick["head_age"] = *self.head, 0.0
        return tick

    def pose(self, along: float) -> Pose:
        """Return the place at `along` metres, up to 0.2 m beside the path."""
        x, y = self.line.point_at(along)
        ahead_x, ahead_y = self.line.point_at(along + 0.4)
        heading = (
            math.atan2(ahead_y - y, ahead_x - x) if along < self.line.length - 0.1 else self.line.heading_at(along)
        )
        aside = 0.2 * math.sin(1.3 * along)
        return Pose(x - aside * math.sin(heading), y + aside * math.cos(heading), heading)


def view_app(plan: FloorPlan, path_name: str, rides: list[tuple[Ride, SceneThread]]) -> FastAPI:
    """Return the application; while it runs, its ride and scene are in `rides`."""

    @asynccontextmanager
    async def lifespan(app: FastAPI) -> AsyncIterator[None]:
        with RoleServers() as servers:
            ride = Ride(plan, path_name)
            thread = start_scene(servers, ride.tick)
            thread.scene.set_floorplan(plan, path_name)
            app.state.servers, app.state.scene = servers, thread.scene
            rides.append((ride, thread))
            try:
                yield
            finally:
                thread.stop()
                app.state.servers = None

    @asynccontextmanager
    async def anybody(websocket: WebSocket, role: Role) -> AsyncIterator[bool]:
        yield True

    def port_of(role: Role) -> int | None:
        servers = app.state.servers
        return None if servers is None else servers.port(role)

    app = FastAPI(lifespan=lifespan)
    app.include_router(view_router(port_of, anybody, lambda: None))
    app.include_router(view_controls(lambda: app.state.scene, lambda: None), prefix="/api/v1")

    @app.get("/api/v1/equipment/practice")
    def worn_shirt() -> dict[str, None]:  # pages ask whether anybody wears the shirt
        return {"kind": None}

    return app


class Running(ServedApp):
    """The application in a thread of this process."""

    def __init__(self, plan: FloorPlan, path_name: str = "main") -> None:
        self._rides: list[tuple[Ride, SceneThread]] = []
        app = view_app(plan, path_name, self._rides)
        super().__init__(app, bind("127.0.0.1", 0), ws_ping_interval=2, ws_ping_timeout=3)

    @property
    def ride(self) -> Ride:
        """Return what moves the chair."""
        return self._rides[0][0]

    @property
    def scene_thread(self) -> SceneThread:
        """Return what follows it."""
        return self._rides[0][1]


running = Running


def plans() -> dict[str, FloorPlan]:
    """Return every floor plan and every scene at each of its levels, by name."""
    found = [load_floorplan(file) for file in bundled_floorplans().values()]
    found += [plan for file in bundled_scenes().values() for plan in load_scene(file).plans.values()]
    return {plan.name: plan for plan in found}


def main() -> None:
    """Serve until interrupted."""
    known = plans()
    words = argparse.ArgumentParser(description="Serve the 3D view of a floor plan or scene, with a chair that drives.")
    words.add_argument("--floorplan", default="clinic", choices=list(known))
    words.add_argument("--path")
    words.add_argument("--port", type=int, default=8090)
    chosen = words.parse_args()
    plan = known[chosen.floorplan]
    app = view_app(plan, chosen.path or plan.paths[0].name, [])
    sys.stdout.write(f"http://127.0.0.1:{chosen.port}/view/clinician/\n")
    uvicorn.run(app, host="127.0.0.1", port=chosen.port, log_level="warning", ws_per_message_deflate=False)


if __name__ == "__main__":
    main()
