"""The drawing of a large plan: bounded in size, and prepared apart from the web process."""

import json

import numpy as np
import pytest

from app.scene import drawing
from app.scene.drawing import LARGE, drawing_of, prepared_drawing
from app.world.floorplan import MAX_LINE_POINTS, MAX_WALLS, FloorPlan

PATH = {"name": "main", "title": "Main", "points": [[0.0, 0.0], [3.0, 0.0]], "instruction": "Follow the line."}


def zigzag(pieces, paths=(PATH,)):
    """A plan whose wall goes to and fro in a few centimetres, so that each piece is near all the others."""
    wall = [[5.0 + 0.001 * number, 5.0 + 0.3 * (number % 2)] for number in range(pieces + 1)]
    return FloorPlan.model_validate_json(
        json.dumps({"name": "zigzag", "title": "Zigzag", "walls": [wall], "paths": list(paths)})
    )


def vertices(drawn):
    return sum(len(part.mesh.vertices) for part in drawn.building.values())


def test_a_plan_has_at_most_so_many_pieces_of_wall():
    assert len(zigzag(MAX_WALLS - 1).segments()) == MAX_WALLS - 1
    with pytest.raises(ValueError, match="walls"):
        zigzag(MAX_WALLS + 1)
    walls = [[[5.0, y], [6.0, y], [7.0, y]] for y in np.linspace(3, 9, MAX_WALLS // 2 + 1)]
    with pytest.raises(ValueError, match="5,002 pieces, and at most 5,000 are taken"):
        FloorPlan.model_validate(zigzag(3).model_dump() | {"walls": walls})


def test_its_paths_have_at_most_so_many_points_in_all():
    half = np.linspace([0, 0], [3, 0], MAX_LINE_POINTS // 2).tolist()
    paths = [{**PATH, "points": half}, {**PATH, "name": "two", "points": half}]
    assert len(zigzag(3, paths).paths) == 2
    with pytest.raises(ValueError, match="too many points"):
        zigzag(3, [*paths, {**PATH, "name": "three"}])


def test_many_pieces_beside_each_other_make_no_larger_drawing_each():
    few, many = (vertices(drawing_of(zigzag(pieces), None, None)) / pieces for pieces in (100, 900))
    assert many < 2 * few


def test_a_large_plan_is_drawn_in_a_process_of_its_own(monkeypatch):
    plan = zigzag(LARGE)
    expected = vertices(drawing_of(plan, None, None))

    def never(*_):
        raise AssertionError("a large plan was drawn here")

    monkeypatch.setattr(drawing, "building_parts", never)
    assert vertices(prepared_drawing(plan, plan.paths[0], None)) == expected
    with pytest.raises(AssertionError):
        prepared_drawing(zigzag(3), None, None)
