"""Walls, floor, ceiling, lamps and open doors: what lets a person judge a distance."""

import numpy as np
import pytest
from scene.shown_colours import contrast, luminance

from app.scene.meshes import palette
from app.scene.meshes.bodies import box
from app.scene.meshes.building import (
    OVERHEAD,
    TILE,
    _lamps,
    building_parts,
    ceiling_part,
    floor_part,
    ground_bounds,
    has_ceiling,
)
from app.scene.meshes.paint import painted
from app.scene.meshes.wall_shade import Pieces
from app.scene.meshes.walls import EDGE, walls_part
from app.world.floorplan import FloorPlan
from app.world.scene import bundled_places
from app.world.scenery import Lights

PLANS = [place.plan for place in bundled_places().values()]
PATH = {"name": "way", "title": "Way", "points": [[1.0, 2.0], [3.0, 2.0]], "instruction": "Drive."}
SQUARE = [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]
FIT = 1e-9


def room(walls=SQUARE, **more):
    return FloorPlan.model_validate({"name": "room", "title": "Room", "walls": walls, "paths": [PATH], **more})


def upward(mesh):
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    return np.cross(b - a, c - a)[:, 2]


def test_what_matters_stands_out_from_walls_and_floor():
    faces = {
        name: luminance(painted(box((1, 1, 1)), getattr(palette, name), Lights()).light)
        for name in ("WALL", "DOOR", "DOOR_LEAF", "SKIRTING", "CEILING", "LAMP", "FLOOR", "FLOOR_TILE")
    }
    top, bottom, sides = slice(0, 4), slice(4, 8), slice(8, 24)
    for name in ("DOOR", "DOOR_LEAF", "SKIRTING"):
        assert contrast(faces["WALL"][sides].min(), faces[name][sides].max()) >= 3
    for floor in ("FLOOR", "FLOOR_TILE"):
        assert contrast(faces[floor][top].max(), faces["SKIRTING"][sides].max()) >= 3
    assert faces["CEILING"][bottom].max() < faces["WALL"][sides].min() < faces["LAMP"][bottom].min()
    assert contrast(faces["FLOOR_TILE"][top].max(), faces["FLOOR"][top].max()) > 1.2


@pytest.mark.parametrize("plan", PLANS, ids=lambda plan: plan.name)
def test_rooms_have_a_ceiling_and_open_country_has_none(plan):
    parts = building_parts(plan)
    top = parts[OVERHEAD].mesh.vertices[:, 2].max() if OVERHEAD in parts else 0.0
    is_room = plan.ground.kind == "hall" and len(plan.walls) > 0
    assert has_ceiling(plan) == is_room
    assert (top == pytest.approx(plan.wall_height)) == (is_room or bool(plan.doors))
    assert ("floor" in parts) == (plan.ground.kind == "hall")
    for room_here in plan.rooms if is_room else ():
        away = lamp_middles(plan)[:, :2] - room_here.position
        assert np.hypot(*away.T).min() < 3.0, room_here.label


def test_low_walls_are_partitions_without_a_ceiling():
    assert not has_ceiling(room(wall_height=1.2))
    assert OVERHEAD not in building_parts(room(wall_height=1.2))
    assert not has_ceiling(room(walls=[]))


def lamp_middles(plan):
    return _lamps(plan, ground_bounds(plan)).vertices.reshape(-1, 4, 3).mean(axis=1)


@pytest.mark.parametrize("plan", [plan for plan in PLANS if has_ceiling(plan)], ids=lambda plan: plan.name)
def test_no_lamp_is_cut_by_a_wall_and_all_look_down(plan):
    middles = lamp_middles(plan)
    assert Pieces(plan).distance(middles[:, :2]).min() > 0.3
    ceiling = ceiling_part(plan, ground_bounds(plan))
    assert (upward(ceiling.mesh) < 0).all()
    assert middles[:, 2].max() < plan.wall_height


@pytest.mark.parametrize(("area", "step"), [(None, TILE), ((-300.0, -300.0, 300.0, 300.0), 10.0)])
def test_the_floor_is_a_chequer_on_multiples_of_its_tile(area, step):
    plan = room(ground={"kind": "hall", "area": area})
    bounds = x_min, y_min, x_max, y_max = ground_bounds(plan)
    floor = floor_part(plan, bounds)
    assert upward(floor.mesh).sum() / 2 == pytest.approx((x_max - x_min) * (y_max - y_min))
    assert (upward(floor.mesh) > 0).all()
    inner = floor.mesh.vertices[:, 0]
    inner = inner[(inner > x_min) & (inner < x_max)]
    assert inner / step == pytest.approx(np.round(inner / step))
    tiles = floor.mesh.vertices.reshape(-1, 4, 3).mean(axis=1)
    light = floor.light.reshape(-1, 4, 3)[:, :, 1].max(axis=1)
    middle = {tuple(np.floor(tile[:2] / step).astype(int)): value for tile, value in zip(tiles, light, strict=True)}
    column, row = round(2.0 / step), round(2.0 / step)
    assert middle[column, row] > 1.1 * middle[column + 1, row]
    assert middle[column, row] == pytest.approx(middle[column + 1, row + 1], rel=0.05)


def wall_light(plan, x, y, low=EDGE, high=2.6 - EDGE):
    """Return the least light of the vertices of walls within 0.15 m of (x, y), at heights where it is whole."""
    walls = walls_part(plan, has_ceiling=True)
    points = walls.mesh.vertices
    near = (
        (np.hypot(points[:, 0] - x, points[:, 1] - y) < 0.15)
        & (points[:, 2] >= low - FIT)
        & (points[:, 2] <= high + FIT)
    )
    return walls.light[near, 1].min()


def test_corners_feet_and_upper_edges_are_darker():
    plan = room()
    walls = walls_part(plan, has_ceiling=True)
    whole = walls.light[:, 1].max()
    assert wall_light(plan, 0.05, 0.05) < 0.6 * whole
    floor = floor_part(plan, ground_bounds(plan))
    away = Pieces(plan).distance(floor.mesh.vertices[:, :2])
    assert floor.light[away < 0.01, 1].max() < 0.7 * floor.light[away > 0.69, 1].max()
    for height in (0.0, plan.wall_height):
        assert wall_light(plan, 0.05, 0.05, height, height) < 0.75 * wall_light(plan, 0.05, 0.05)


def test_a_straight_wall_drawn_in_two_pieces_has_no_dark_joint():
    two = room(walls=[[[0, 0], [2, 0], [4, 0]]])
    sides = walls_part(two, has_ceiling=False)
    joint = np.abs(sides.mesh.vertices[:, 0] - 2.0) < 0.2
    is_side = (np.abs(np.abs(sides.mesh.vertices[:, 1]) - 0.05) < FIT) & (sides.mesh.vertices[:, 2] == EDGE)
    ends = np.abs(sides.mesh.vertices[:, 0] - 0.0) < 0.2
    assert joint[is_side].any()
    light = sides.light[:, 1]
    assert sorted(set(np.round(light[is_side & joint], 9))) == sorted(set(np.round(light[is_side & ends], 9)))


def test_only_the_side_with_the_other_wall_is_dark():
    tee = room(walls=[[[0, 0], [4, 0]], [[2, 0], [2, 1]]])
    walls = walls_part(tee, has_ceiling=False)
    points = walls.mesh.vertices
    at = (np.abs(points[:, 0] - 1.95) < 0.02) & (points[:, 2] == EDGE)
    inside = at & (np.abs(points[:, 1] - 0.05) < FIT)
    assert inside.any()
    assert not (at & (np.abs(points[:, 1] + 0.05) < FIT)).any()  # the other side has no vertex there


def test_very_many_walls_are_drawn_all_the_same():
    walls = [[[x, 10.0 + y], [x + 0.8, 10.0 + y]] for x in range(50) for y in range(30)]
    parts = building_parts(room(walls=walls))
    assert sum(len(part.mesh.faces) for part in parts.values()) < 100_000
    assert all(np.isfinite(part.mesh.vertices).all() for part in parts.values())


WAY = {"name": "way", "title": "Way", "points": [[1.0, 0.0], [9.0, 0.0]], "instruction": "Drive."}
