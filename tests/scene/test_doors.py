"""Open leaves stand flat against the wall beside their doors, out of every way, and only where there is room."""

import numpy as np
import pytest

from app.scene.meshes.doors import LEAF_CLEARANCE, LEAF_OFF_WALL, LEAF_THICKNESS, leaves_part
from app.world.clearance import Clearance
from app.world.floorplan import FloorPlan, bundled_floorplans, load_floorplan
from app.world.scene import bundled_scenes, load_scene

PLANS = [load_floorplan(file) for file in bundled_floorplans().values()]
PLANS += [plan for file in bundled_scenes().values() for plan in load_scene(file).plans.values()]
HEIGHT = 2.0  # m
WALL = [[[5.0, -4.0], [5.0, -0.5]], [[5.0, 0.5], [5.0, 4.0]]]
PATH = {"name": "way", "title": "Way", "points": [[1.0, 0.0], [9.0, 0.0]], "instruction": "Drive."}
DOOR = {"position": [5.0, 0.0], "width": 1.0, "heading": 0.0}


def plan_with(walls=WALL, **more):
    document = {"name": "door", "title": "Door", "walls": walls, "paths": [PATH], "doors": [DOOR], **more}
    return FloorPlan.model_validate(document)


def leaf_of(plan):
    """Return the lowest and the highest corner of the only leaf, without its handle."""
    vertices = leaves_part(plan, HEIGHT).mesh.vertices[:24]
    return vertices.min(axis=0), vertices.max(axis=0)


def test_a_leaf_is_as_wide_as_its_door_and_lies_at_the_wall_beside_it():
    low, high = leaf_of(plan_with())
    assert high - low == pytest.approx([LEAF_THICKNESS, 1.0, HEIGHT - 0.01])
    assert min(abs(low[0] - 5.0), abs(high[0] - 5.0)) == pytest.approx(0.05 + LEAF_OFF_WALL)
    assert min(abs(low[1]), abs(high[1])) > 0.5  # beside the clear width


def test_a_leaf_goes_where_there_is_wall_and_nothing_in_front_of_it():
    box = {"kind": "box", "label": "desk", "size": [1.0, 1.5]}
    one_side = plan_with([[[5.0, -4.0], [5.0, -0.5]], [[5.0, 0.5], [5.0, 1.2]]])
    assert leaf_of(one_side)[1][1] < 0.0
    at_desk = plan_with(obstacles=[{**box, "position": [4.4, -1.6]}, {**box, "position": [5.6, -1.6]}])
    assert leaf_of(at_desk)[0][1] > 0.0
    no_wall = plan_with([[[5.0, -1.2], [5.0, -0.5]], [[5.0, 0.5], [5.0, 1.2]]])
    assert leaves_part(no_wall, HEIGHT) is None
    corner = plan_with([*WALL, [[5.0, 1.0], [9.0, 1.0]], [[5.0, -1.0], [1.0, -1.0]]])
    low, high = leaf_of(corner)  # ahead on the right, or behind on the left
    assert (low[0] > 5.0) == (high[1] < 0.0)


@pytest.mark.parametrize("plan", [plan for plan in PLANS if plan.doors], ids=lambda plan: plan.name)
def test_no_leaf_is_on_a_way_in_a_wall_or_in_furniture(plan):
    part = leaves_part(plan, HEIGHT)
    leaves = part.mesh.vertices[: len(part.mesh.vertices) // 2].reshape(-1, 24, 3)[..., :2]
    assert len(leaves) >= len(plan.doors) / 2
    solid = Clearance(plan.walls, plan.wall_thickness, plan.obstacles)
    for corners in leaves:
        ring = np.unique(corners.round(9), axis=0)
        middle = ring.mean(axis=0)
        ends = [tuple(middle + sign * (ring[-1] - ring[0]) / 2) for sign in (-1, 1)]
        assert solid.along(ends).distance > 0.0
        leaf = Clearance([ends], LEAF_THICKNESS, ())
        assert min(leaf.along(path.points).distance for path in plan.paths) > LEAF_CLEARANCE - 1e-6
