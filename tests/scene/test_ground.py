"""The ground of open country, and the marks of tasks on it."""

import numpy as np
import pytest

from app.scene.meshes.building import FAR, ground_parts
from app.world.floorplan import FloorPlan
from app.world.scenery import Dune, Ground

AREA = (-4.0, -6.0, 16.0, 6.0)
PATH = {"name": "way", "title": "Way", "points": [[0.0, 0.0], [12.0, 0.0]], "instruction": "Drive."}
FIT = 1e-9


def plan_on(kind, area=AREA, dunes=()):
    ground = Ground(kind=kind, area=area, dunes=dunes)
    return FloorPlan.model_validate({"name": "open", "title": "Open", "walls": [], "paths": [PATH], "ground": ground})


def up(mesh):
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    return np.cross(b - a, c - a)[:, 2]


def extent(mesh):
    return *mesh.vertices[:, :2].min(axis=0), *mesh.vertices[:, :2].max(axis=0)


@pytest.mark.parametrize("kind", ["sand", "grass", "asphalt"])
@pytest.mark.parametrize("area", [AREA, None, (-300.0, -300.0, 300.0, 300.0)])
def test_every_ground_looks_up_and_is_a_few_light_meshes(kind, area):
    parts = ground_parts(plan_on(kind, area))
    assert len(parts) <= 12
    assert sum(len(part.mesh.faces) for part in parts.values()) < 20_000
    for name, part in parts.items():
        assert (up(part.mesh) > -FIT).all(), name
        assert np.isfinite(part.mesh.vertices).all()


@pytest.mark.parametrize("kind", ["sand", "grass", "asphalt"])
def test_open_ground_fills_its_area_and_its_details_stay_inside(kind):
    parts = ground_parts(plan_on(kind))
    assert extent(parts["ground"].mesh) == AREA
    x_min, y_min, x_max, y_max = extent(parts["ground_detail"].mesh)
    assert x_min >= AREA[0] - FIT
    assert y_min >= AREA[1] - FIT
    assert x_max <= AREA[2] + FIT
    assert y_max <= AREA[3] + FIT
    assert (x_max - x_min) * (y_max - y_min) > 0.7 * 20 * 12


def test_the_land_reaches_to_the_horizon_without_a_hole_and_becomes_paler():
    parts = ground_parts(plan_on("grass"))
    rings = [parts[f"land_{number}"] for number in range(len(FAR) - 1)]
    assert extent(rings[-1].mesh) == (AREA[0] - FAR[-1], AREA[1] - FAR[-1], AREA[2] + FAR[-1], AREA[3] + FAR[-1])
    covered = sum(up(part.mesh).sum() / 2 for part in [*rings, parts["ground"]])
    assert covered == pytest.approx((20 + 2 * FAR[-1]) * (12 + 2 * FAR[-1]))
    brightness = [sum(part.colour) for part in rings]
    assert brightness == sorted(brightness)


def test_a_dune_is_a_smooth_hill_of_its_size():
    dune = Dune(position=(30.0, 0.0), radius=8.0, height=2.5)
    (mesh,) = (part.mesh for name, part in ground_parts(plan_on("sand", dunes=(dune,))).items() if name == "dunes")
    away = np.hypot(mesh.vertices[:, 0] - 30, mesh.vertices[:, 1])
    assert away.max() == pytest.approx(8.0)
    assert mesh.vertices[:, 2].max() == pytest.approx(2.5)
    assert mesh.vertices[away > 7.99, 2] == pytest.approx(0.0, abs=1e-9)
    assert (up(mesh) > 0).all()


def test_a_ground_looks_the_same_each_time():
    one, other = ground_parts(plan_on("grass")), ground_parts(plan_on("grass"))
    assert (one["ground_detail"].mesh.vertices == other["ground_detail"].mesh.vertices).all()
