"""Real-like maps of homes: noisy, turned and open; each becomes a plan with its rooms inside."""

from itertools import pairwise

import numpy as np
import pytest
from scanned_homes import scanned_home, write_map

from app.world.imports.draft import plan_of
from app.world.imports.options import Options
from app.world.imports.plan_files import import_plan

RESOLUTIONS = (0.02, 0.025, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1)


def is_inside(plan, place):
    """Return whether a place is in the free space: a ray from it crosses the walls an odd number of times."""
    crossings = 0
    for wall in plan.walls:
        for (ax, ay), (bx, by) in pairwise(wall):
            if (ay > place[1]) != (by > place[1]):
                crossings += place[0] < ax + (place[1] - ay) / (by - ay) * (bx - ax)
    return crossings % 2 == 1


@pytest.mark.parametrize("resolution", RESOLUTIONS)
@pytest.mark.parametrize("seed", range(5))
def test_the_rooms_of_a_scanned_home_are_in_its_plan(tmp_path, seed, resolution):
    home = scanned_home(100 * seed + round(resolution * 1000), resolution)
    plan = plan_of(import_plan(write_map(home, tmp_path), Options()), "home.yaml")
    # A spurious return may stand in the very middle of a room: most of the places around it are free.
    around = np.array([(0, 0), (0.3, 0), (-0.3, 0), (0, 0.3), (0, -0.3)])
    for room in home.rooms:
        assert sum(is_inside(plan, room + step) for step in around) >= 3
    assert not is_inside(plan, (0.2, 0.2))  # nobody has seen the map's corner
    assert plan.paths[0].line.length >= 0.7 * home.length
