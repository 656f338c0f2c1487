"""The plain scene beside which the view is measured, the chair that drives through both, and what a client reads."""

import math
from collections.abc import Mapping

import msgspec
import numpy as np
import pytest
import zstandard

from app.scene.meshes.building import OVERHEAD, WALLS, building_parts
from app.world.floorplan import FloorPlan, bundled_floorplans, load_floorplan
from bench.processes.eye_served import PLAN, plain_parts, tick_at
from bench.web.view_client import chair_positions


@pytest.fixture(scope="module")
def plan() -> FloorPlan:
    return load_floorplan(bundled_floorplans()[PLAN])


def test_the_plain_scene_has_the_same_furniture_and_neither_ceiling_nor_tiles(plan: FloorPlan) -> None:
    drawn, plain = building_parts(plan), plain_parts(plan)
    assert OVERHEAD in drawn
    assert set(plain) == set(drawn) - {OVERHEAD}
    assert len(plain["floor"].mesh.faces) == 2
    walls = plain[WALLS].mesh.vertices
    assert np.ptp(walls[:, 2]) == plan.wall_height


def test_the_chair_drives_the_path_and_looks_along_it(plan: FloorPlan) -> None:
    line = plan.paths[0].line
    for now in (0.0, 3.0, 7.5):
        tick = tick_at(plan, now)
        assert math.dist((tick["x"], tick["y"]), line.point_at(0.8 * now % line.length)) < 1e-6
        later = tick_at(plan, now + 0.1)
        way = math.atan2(later["y"] - tick["y"], later["x"] - tick["x"])
        assert abs(math.remainder(way - tick["theta"], math.tau)) < 0.5


def packet(*messages: Mapping[str, object]) -> bytes:
    content = msgspec.msgpack.encode({"messages": messages, "timestampSec": 1.0})
    packed = zstandard.ZstdCompressor().compress(content)
    return len(content).to_bytes(8, "little") + len(packed).to_bytes(8, "little") + packed + b"arrays of meshes"


def test_only_the_chair_counts() -> None:
    moved = {"type": "SetPositionMessage", "name": "/world/chair", "position": (1.0, 2.0, 0.0)}
    turned = {"type": "SetOrientationMessage", "name": "/world/chair", "wxyz": (1.0, 0.0, 0.0, 0.0)}
    other = {"type": "SetPositionMessage", "name": "/world", "position": (3.0, 4.0, 0.0)}
    assert list(chair_positions(packet(turned, moved, other))) == [(1.0, 2.0)]
    assert list(chair_positions(packet())) == []
