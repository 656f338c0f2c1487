"""The narrowest point of a line is the same whether walls and obstacles are measured together or one by one."""

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.world import clearance as module
from app.world.clearance import Clearance
from app.world.floorplan import MAX_LINE_POINTS, MAX_WALLS
from app.world.obstacles import Box, Cylinder
from app.world.scene import bundled_places

metres = st.floats(-20, 20)
points = st.tuples(metres, metres)
lengths = st.floats(0.01, 8)
boxes = st.builds(
    Box,
    kind=st.just("box"),
    label=st.just("box"),
    position=points,
    size=st.tuples(lengths, lengths),
    angle=st.floats(-3.1, 3.1),
)
cylinders = st.builds(
    Cylinder, kind=st.just("cylinder"), label=st.just("cylinder"), position=points, radius=st.floats(0.01, 4)
)
PLANS = {name: place.plan for name, place in bundled_places().items()}


def least_of_each(walls, thickness, obstacles, line):
    """Return the narrowest distance, with each piece of a wall and each obstacle measured by itself."""
    each = [Clearance([piece], thickness, ()) for wall in walls for piece in pairwise(wall)]
    each += [Clearance((), thickness, [obstacle]) for obstacle in obstacles]
    return min((one.along(line).distance for one in each), default=math.inf)


@given(
    walls=st.lists(st.lists(points, min_size=2, max_size=4), max_size=3),
    obstacles=st.lists(boxes | cylinders, max_size=6),
    line=st.lists(points, min_size=2, max_size=5),
)
def test_obstacles_together_are_as_near_as_the_nearest_of_them(walls, obstacles, line):
    together = Clearance(walls, 0.1, obstacles).along(line).distance
    assert together == least_of_each(walls, 0.1, obstacles, line)


@pytest.mark.parametrize("name", PLANS)
def test_the_paths_of_each_bundled_place(name):
    plan = PLANS[name]
    clearance = Clearance(plan.walls, plan.wall_thickness, plan.obstacles)
    for path in plan.paths:
        least = least_of_each(plan.walls, plan.wall_thickness, plan.obstacles, path.points)
        assert clearance.along(path.points).distance == least


def test_of_a_large_plan_few_walls_are_measured_for_each_piece_of_a_path(monkeypatch):
    """All were: the largest plan that is accepted took 7 s to check, and the control process gave up."""
    measured = []
    between = module.between_segments
    monkeypatch.setattr(
        module, "between_segments", lambda piece, walls: measured.append(len(walls)) or between(piece, walls)
    )
    comb = [(5.0 + 0.0001 * number, 5.0 + 0.3 * (number % 2)) for number in range(MAX_WALLS + 1)]
    line = np.linspace([0.0, 0.0], [3.0, 0.0], MAX_LINE_POINTS).tolist()
    Clearance([comb], 0.1, ()).along(line)
    assert measured[0] == MAX_WALLS
    assert sum(measured[1:]) < 100 * len(line)
