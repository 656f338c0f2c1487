"""The narrowest point of a line is the same whether obstacles are measured together or one by one."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.world.clearance import Clearance
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
    """Return the narrowest distance, with the walls and each obstacle measured by itself."""
    each = [Clearance(walls, thickness, ()), *(Clearance((), thickness, [obstacle]) for obstacle in obstacles)]
    return min(one.along(line).distance for one in each)


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
