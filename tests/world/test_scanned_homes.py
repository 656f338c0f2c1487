"""Real-like maps of homes and hospitals: noisy, turned and open; each becomes a plan with its rooms inside."""

import re
from itertools import pairwise

import numpy as np
import pytest
from world.scanned_homes import OCCUPIED, scanned_home, write_map
from world.scanned_hospital import scanned_hospital

from app.world.imports import map_draft
from app.world.imports.draft import plan_of
from app.world.imports.options import Options
from app.world.imports.plan_files import import_plan

RESOLUTIONS = (0.02, 0.025, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1)


def rooms_inside(plan, rooms):
    """Return how many rooms are in the free space; a spurious return may stand in the very middle of one."""
    around = np.array([(0, 0), (0.3, 0), (-0.3, 0), (0, 0.3), (0, -0.3)])
    return sum(sum(is_inside(plan, room + step) for step in around) >= 3 for room in rooms)


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
    assert rooms_inside(plan, home.rooms) == len(home.rooms)
    assert not is_inside(plan, (0.2, 0.2))  # nobody has seen the map's corner
    assert plan.paths[0].line.length >= 0.7 * home.length


@pytest.mark.parametrize(("seed", "size"), [(1, 22.0), (2, 35.0), pytest.param(3, 50.0, marks=pytest.mark.long)])
def test_the_rooms_of_a_scanned_hospital_are_in_its_plan(tmp_path, seed, size):
    hospital = scanned_hospital(seed, size)
    plan = plan_of(import_plan(write_map(hospital, tmp_path), Options()), "home.yaml")
    assert rooms_inside(plan, hospital.rooms) >= 0.9 * len(hospital.rooms)
    assert plan.paths[0].line.length >= size


def test_a_storey_of_too_many_pieces_is_taken_when_the_share_that_its_refusal_names_is_kept(tmp_path, monkeypatch):
    monkeypatch.setattr(map_draft, "MAX_WALLS", 250)
    hospital = scanned_hospital(1, 30.0)
    rows = first = hospital.pixels.shape[0]
    for _ in range(3):  # the share is about right: pieces are not spread evenly
        try:
            plan = plan_of(import_plan(write_map(hospital, tmp_path), Options()), "home.yaml")
        except ValueError as refused:
            words = str(refused)
            assert re.search(r"this map has [\d,]+ wall pieces when it is made as simple as .* at most 250 are", words)
            rows = round(rows * int(re.search(r"keep about (\d+) % of it and paint the rest as wall", words)[1]) / 100)
            hospital.pixels[: first - rows] = OCCUPIED
    assert 0 < rows < first
    assert rooms_inside(plan, hospital.rooms) > 0
