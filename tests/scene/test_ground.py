"""The ground of open country, and the marks of tasks on it."""

import math

import numpy as np
import pytest

from app.scene.meshes.building import FAR, ground_parts
from app.scene.task_marks import BOX, GAP_MARK, SPOT, gap_parts, later_parts, task_parts
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.scenery import Dune, Gap, Ground
from app.world.tasks import Back, Course, Stage, Turn

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


def path(task, points=((1.0, 2.0), (1.0, 5.0)), start_heading=None):
    return PrescribedPath(
        name="one", title="One", points=points, instruction="Do.", task=task, start_heading=start_heading
    )


def looks_up(mesh):
    a, b, c = (mesh.vertices[mesh.faces[:, corner], :2] for corner in range(3))
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    return (ux * vy - uy * vx > -1e-12).all()


@pytest.mark.parametrize(
    ("direction", "start", "swept"),
    [("left", 0.0, math.pi / 2), ("right", 0.0, 3 * math.pi / 2), ("right", math.pi, math.pi / 2)],
)
def test_a_turn_shows_the_spot_the_mark_and_an_arrow_in_the_asked_direction(direction, start, swept):
    parts = task_parts(path(Turn(kind="turn", direction=direction), start_heading=start))
    away = parts["goal"].mesh.vertices[:, :2] - (1.0, 2.0)
    assert np.hypot(*away.T).max() == pytest.approx(SPOT)
    mark = parts["mark"].mesh.vertices
    assert mark[:, :2].mean(axis=0) == pytest.approx([1.0, 5.0], abs=0.01)
    assert looks_up(parts["path"].mesh)
    arrow = parts["path"].mesh.vertices[:, :2] - (1.0, 2.0)
    sign = 1 if direction == "left" else -1
    turned = sign * (np.arctan2(arrow[:, 1], arrow[:, 0]) - start) % math.tau
    turned[turned > swept + 0.3] -= math.tau  # a little before the beginning
    assert turned.min() > -0.1
    assert turned.max() == pytest.approx(swept, abs=0.1)


def test_the_box_to_back_into_lies_at_the_end_along_the_way():
    mesh = task_parts(path(Back(kind="back")))["goal"].mesh
    assert looks_up(mesh)
    low, high = mesh.vertices[:, :2].min(axis=0), mesh.vertices[:, :2].max(axis=0)
    assert (low + high) / 2 == pytest.approx([1.0, 5.0])
    assert high - low == pytest.approx([BOX[1], BOX[0]], abs=0.06)


def test_a_course_shows_its_stages_faintly_and_other_tasks_nothing():
    stages = (
        Stage(title="A", instruction="Drive.", points=((0, 0), (4, 0))),
        Stage(title="B", instruction="Turn.", points=((4, 0), (4, 3)), task=Turn(kind="turn", direction="left")),
        Stage(title="C", instruction="Back.", points=((4, 0), (4, -2)), task=Back(kind="back")),
    )
    (part,) = later_parts(path(Course(kind="course", stages=stages))).values()
    assert part.mesh.vertices[:, 1].max() < 1
    assert part.mesh.vertices[:, 1].min() == pytest.approx(-2)
    assert later_parts(path(Back(kind="back"))) == {}


@pytest.mark.parametrize("heading", [0.0, 0.7, math.pi / 2])
def test_the_marks_of_a_gap_are_as_far_apart_as_it_is_wide(heading):
    gap = Gap(label="narrow", position=(3.0, 1.0), width=0.9, heading=heading)
    points = gap_parts((gap,))["gap_marks"].mesh.vertices[:, :2] - (3.0, 1.0)
    across = points @ (-math.sin(heading), math.cos(heading))
    along = points @ (math.cos(heading), math.sin(heading))
    assert np.abs(across).max() == pytest.approx(0.45)
    assert np.abs(along).max() == pytest.approx(GAP_MARK[0] / 2)
    assert gap_parts(()) == {}
