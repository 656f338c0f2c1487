"""The web process of the eye's benchmark: a clinic's plan as a patient sees it, while the chair drives its path.

With the word "plain" as argument, walls and floor have one colour each and stand under an open sky: neither ceiling nor
lamps, tiles, door frames, skirting and dark corners. Prints its port; ends with stdin.
"""

import asyncio
import math
import sys
from typing import Final

import numpy as np
import uvicorn

from app.cli.port import bind
from app.clock import monotonic
from app.messages import TICK
from app.scene import drawing
from app.scene.meshes import palette
from app.scene.meshes.bodies import Part, merged, rectangle, standing_box
from app.scene.meshes.building import FURNITURE, WALLS, BuildingParts, building_parts, ground_bounds
from app.scene.meshes.furniture import ModelOf, no_model
from app.scene.meshes.wall_shade import Pieces
from app.scene.role_servers import RoleServers
from app.scene.scene_thread import start_scene
from app.world.floorplan import FloorPlan, bundled_floorplans, load_floorplan
from bench.circle import TICK_RATE
from bench.processes.viewers_served import viewed_app

PLAN: Final = "clinic"
SPEED: Final = 0.8  # m/s
LOOK_AHEAD: Final = 0.4  # m


def plain_parts(plan: FloorPlan, model_of: ModelOf = no_model) -> BuildingParts:
    """Return walls, furniture and floor without what lets a person judge distances."""
    pieces = Pieces(plan)
    walls = []
    for number, length in enumerate(pieces.length):
        x, y = (pieces.start[number] + pieces.end[number]) / 2
        cos, sin = pieces.along[number]
        wall = standing_box(float(length), plan.wall_thickness, 0.0, plan.wall_height)
        walls.append(wall.moved(float(x), float(y), heading=math.atan2(sin, cos)))
    furniture = {name: part for name, part in building_parts(plan, model_of).items() if name.startswith(FURNITURE)}
    floor = Part(rectangle(*ground_bounds(plan), 0.0), palette.FLOOR)
    return {WALLS: Part(merged(walls), palette.WALL)} | furniture | {"floor": floor}


def tick_at(plan: FloorPlan, now: float) -> np.void:
    """Return the tick of a chair that drives the first path again and again, at `now` (monotonic s)."""
    line = plan.paths[0].line
    along = (now * SPEED) % line.length
    x, y = line.point_at(along)
    ahead = line.point_at(min(along + LOOK_AHEAD, line.length))
    tick: np.void = np.zeros(1, dtype=TICK)[0]
    tick["number"], tick["t"], tick["scene_t"] = int(now * TICK_RATE), now, now
    tick["x"], tick["y"] = x, y
    is_at_end = along + LOOK_AHEAD >= line.length
    tick["theta"] = line.heading_at(along) if is_at_end else math.atan2(ahead[1] - y, ahead[0] - x)
    tick["head_yaw"] = tick["head_pitch"] = tick["head_roll"] = tick["head_age"] = np.nan
    return tick


async def serve(plan: FloorPlan) -> None:
    """Serve the patient's view until stdin ends."""
    with RoleServers() as servers, bind("127.0.0.1", 0) as listening:
        thread = start_scene(servers, lambda: tick_at(plan, monotonic()))
        thread.scene.set_floorplan(plan, plan.paths[0].name)
        thread.scene.set_view("patient", "eye")
        server = uvicorn.Server(uvicorn.Config(viewed_app(servers), log_level="error", ws_per_message_deflate=False))
        serving = asyncio.create_task(server.serve([listening]))
        sys.stdout.write(f"{listening.getsockname()[1]}\n")
        sys.stdout.flush()
        while await asyncio.to_thread(sys.stdin.readline):
            pass
        server.should_exit = True
        await serving
        thread.stop()


if __name__ == "__main__":
    if sys.argv[1:] == ["plain"]:
        vars(drawing)["building_parts"] = plain_parts
    asyncio.run(serve(load_floorplan(bundled_floorplans()[PLAN])))
