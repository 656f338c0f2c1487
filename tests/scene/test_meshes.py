"""The meshes of places, furniture, rocks, cones and movers: their sizes, and the circle at which the chair touches."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.geometry import Pose
from app.scene.meshes.bodies import Part, ball, box, limb, merged, rectangle, ring, standing_box, strip, tube, wheel
from app.scene.meshes.building import building_parts
from app.scene.meshes.furniture import furniture, rock
from app.scene.meshes.movers import mover_parts
from app.scene.meshes.wheelchair import chair_parts, person_parts
from app.scene.models.objects import Model
from app.scene.scene_state import Cones
from app.scene.task_marks import PATH_WIDTH, later_parts, task_parts
from app.world.floorplan import bundled_floorplans, load_floorplan
from app.world.footprint import CHAIR_RADIUS
from app.world.movers import Mover
from app.world.obstacles import Box, Cylinder
from app.world.scene import bundled_places
from app.world.scenery import Cone

MOST_TRIANGLES = 40_000  # that a tablet draws fluently
MOST_MESHES = 40


def volume(mesh):
    """Positive when every face of a closed mesh looks outwards."""
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def area_from_above(mesh):
    a, b, c = (mesh.vertices[mesh.faces[:, corner], :2] for corner in range(3))
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    return ux * vy - uy * vx


@pytest.mark.parametrize(
    ("mesh", "expected"),
    [
        (box((1, 2, 3)), 6.0),
        (tube((0, 0, 0), (0, 0, 2), 1.0, sides=200), 2 * math.pi),
        (tube((1, 0, 0), (1, 3, 0), 1.0, 0.0, sides=200), math.pi),
        (ball((5, 5, 5), 1.0, 100), 4 / 3 * math.pi),
        (wheel((0, 0, 1), 1.0, 0.1, 0.1, 100), 2 * math.pi**2 * 0.95 * 0.05**2 * 0.935),
        (box((1, 2, 3)).moved(3, -2, 1, 0.7), 6.0),
        (standing_box(1, 1, 0, 1).tilted(0.4), 1.0),
    ],
)
def test_closed_bodies_look_outwards_and_have_their_size(mesh, expected):
    assert volume(mesh) == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize(
    "mesh", [rectangle(0, 0, 1, 1, 0), ring((0, 0, 0), 1, 2), strip([(0, 0), (1, 0), (1, 1)], 0.2, 0)]
)
def test_what_lies_on_the_floor_looks_up(mesh):
    assert (area_from_above(mesh) > 0).all()


def test_a_strip_has_the_same_width_before_and_after_a_corner():
    mesh = strip([(0, 0), (4, 0), (4, 3)], 0.2, 0.0)
    assert area_from_above(mesh).sum() / 2 == pytest.approx(0.2 * 7, rel=1e-6)


def test_a_line_that_turns_back_makes_no_spike():
    mesh = strip([(0, 0), (4, 0), (0, 0.0), (0, 0), (0, 3)], 0.2, 0.0)
    assert np.isfinite(mesh.vertices).all()
    assert np.abs(mesh.vertices).max() < 4.5


def test_merging_keeps_every_triangle():
    parts = [box((1, 1, 1)), ball((0, 0, 0), 1), limb([(0, 0, 0), (1, 0, 0), (1, 1, 0)], 0.1)]
    whole = merged(parts)
    assert len(whole.faces) == sum(len(part.faces) for part in parts)
    assert whole.faces.max() == len(whole.vertices) - 1
    assert len(merged([]).faces) == 0


PLANS = [place.plan for place in bundled_places().values()]


@pytest.mark.parametrize("plan", PLANS, ids=lambda plan: plan.name)
def test_a_place_is_few_meshes_of_few_triangles(plan):
    parts = building_parts(plan) | Cones(plan.cones).parts()
    bodies = [*chair_parts().values(), *person_parts().values()]
    bodies += [part.mesh for mover in plan.movers for part in mover_parts(mover)]
    for path in plan.paths:
        shown = parts | task_parts(path) | later_parts(path)
        meshes = [part.mesh for part in shown.values()] + bodies
        assert len(meshes) <= MOST_MESHES
        assert sum(len(mesh.faces) for mesh in meshes) <= MOST_TRIANGLES
        for mesh in meshes:
            assert np.isfinite(mesh.vertices).all()
            assert mesh.faces.max() < len(mesh.vertices)


@pytest.mark.parametrize("name", bundled_floorplans())
def test_the_path_on_the_floor_has_its_width(name):
    path = load_floorplan(bundled_floorplans()[name]).paths[0]
    assert PATH_WIDTH * path.line.length == pytest.approx(
        area_from_above(task_parts(path)["path"].mesh).sum() / 2, rel=0.05
    )


def test_the_drawn_chair_is_as_wide_as_the_one_that_bumps_into_walls():
    across = np.concatenate([mesh.vertices[:, 1] for mesh in chair_parts().values()])
    assert across.max() == pytest.approx(CHAIR_RADIUS, abs=0.02)
    assert across.min() == pytest.approx(-CHAIR_RADIUS, abs=0.02)


@pytest.mark.parametrize(
    "label",
    [
        *("desk", "bed", "treatment table", "sofa", "bench", "chair", "cupboard", "shelf", "counter", "washbasin"),
        *("toilet", "mat", "bar", "trolley", "television"),
        "thing without a shape of its own",
    ],
)
@pytest.mark.parametrize("size", [(2.0, 0.8), (0.8, 2.0)])
def test_furniture_fills_the_footprint_that_stops_the_chair(label, size):
    box_obstacle = Box(kind="box", label=label, position=(3.0, -2.0), size=size, height=0.8, angle=0.3)
    points = np.concatenate([mesh.vertices for mesh in furniture([box_obstacle]).values()])
    away = points[:, :2] - (3.0, -2.0)
    cos, sin = math.cos(0.3), math.sin(0.3)
    along, across = away @ (cos, sin), away @ (-sin, cos)
    assert np.abs(along).max() == pytest.approx(size[0] / 2, rel=0.06)
    assert np.abs(across).max() == pytest.approx(size[1] / 2, rel=0.06)
    assert points[:, 2].min() >= 0


@pytest.mark.parametrize("label", ["plant", "gym ball", "round table", "stool", "column"])
def test_round_furniture_fills_its_circle(label):
    obstacle = Cylinder(kind="cylinder", label=label, position=(1.0, 1.0), radius=0.4, height=0.8)
    points = np.concatenate([mesh.vertices for mesh in furniture([obstacle]).values()])
    reach = np.hypot(*(points[:, :2] - (1.0, 1.0)).T).max()
    assert reach == pytest.approx(0.4, rel=0.06)


metres = st.floats(-50, 50)


def points_of(parts):
    return np.concatenate([part.mesh.vertices for part in parts])


@given(st.floats(0.1, 3), st.floats(0.1, 3), metres, metres)
def test_a_rock_touches_its_circle_and_height_and_stays_inside(radius, height, x, y):
    mesh = rock(radius, height, (x, y))
    assert np.hypot(*mesh.vertices[:, :2].T).max() == pytest.approx(radius)
    assert mesh.vertices[:, 2].max() == pytest.approx(height)
    assert mesh.vertices[:, 2].min() < 0  # sunk into the ground
    assert np.isfinite(mesh.vertices).all()
    assert (mesh.vertices == rock(radius, height, (x, y)).vertices).all()


def test_rocks_look_outwards_and_no_two_alike():
    one, other = rock(1, 1, (1, 2)), rock(1, 1, (2, 1))
    a, b, c = (one.vertices[one.faces[:, corner]] for corner in range(3))
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 > 1.0
    assert one.vertices.shape != other.vertices.shape or not np.allclose(one.vertices, other.vertices)


def test_an_obstacle_called_a_rock_is_drawn_as_one_where_it_stands():
    obstacle = Cylinder(kind="cylinder", label="Large rock", position=(3.0, -2.0), radius=0.7, height=0.5)
    (mesh,) = furniture([obstacle]).values()
    assert np.hypot(mesh.vertices[:, 0] - 3, mesh.vertices[:, 1] + 2).max() == pytest.approx(0.7)


def test_a_box_with_a_model_is_drawn_as_it_and_without_as_its_label_says():
    box = Box(kind="box", label="desk", position=(1.0, 2.0), size=(2.0, 1.0), height=0.5, angle=0.3, model="piano")
    cube = Model((Part(rock(1, 1, (0, 0)), (1, 2, 3)),), (2.0, 2.0, 1.0))
    asked = []
    found = furniture([box], lambda name: asked.append(name) or cube)
    assert asked == ["piano"]
    assert set(found) == {(1, 2, 3)}
    assert found[1, 2, 3].vertices[:, 2].max() == pytest.approx(0.5)
    plain = Box(kind="box", label="desk", position=(1.0, 2.0), size=(2.0, 1.0), height=0.5, angle=0.3)
    assert furniture([box]).keys() == furniture([plain]).keys()


CONES = (Cone(position=(2.0, 0.0)), Cone(position=(4.0, 1.0), radius=0.2, height=0.7))


def test_a_cone_stands_inside_its_circle_until_it_is_touched_and_falls_away_from_the_chair():
    cones = Cones(CONES[:1])
    standing = points_of(cones.parts().values())
    assert np.hypot(standing[:, 0] - 2, standing[:, 1]).max() <= 0.15
    assert standing[:, 2].max() == pytest.approx(0.5)
    cones.touch(Pose(2.0 - CHAIR_RADIUS - 0.16, 0.0, 0.0))
    assert cones.lying == 0
    cones.touch(Pose(2.0 - CHAIR_RADIUS - 0.14, 0.0, 0.0))
    assert cones.lying == 1
    cones.touch(Pose(2.1, 0.0, 0.0))  # a lying cone does not fall again
    lying = points_of(cones.parts().values())
    assert lying[:, 2].max() < 0.25
    assert lying[:, 2].min() > -0.03
    assert lying[:, 0].max() > 2.4
    assert np.ptp(lying[:, 1]) < 0.3


def test_cones_stand_up_again():
    cones = Cones(CONES)
    before = points_of(cones.parts().values())
    cones.touch(Pose(2.0, 0.1, 0.0))
    assert cones.lying == 1
    cones.stand_up()
    assert cones.lying == 0
    assert (points_of(cones.parts().values()) == before).all()


def test_a_fallen_cone_has_the_same_faces_so_that_only_points_are_sent():
    cones = Cones(CONES)
    before = cones.parts()
    cones.touch(Pose(2.0, 0.1, 0.0))
    for name, part in cones.parts().items():
        assert (part.mesh.faces == before[name].mesh.faces).all()
    assert Cones(()).parts() == {}


@pytest.mark.parametrize(("kind", "height"), [("person", 1.76), ("chair", 1.45), ("ball", 0.6)])
def test_a_mover_has_its_size_stands_on_the_floor_and_is_a_few_meshes(kind, height):
    mover = Mover(name="one", kind=kind, points=((0, 0), (1, 0)), pace=((0.0, 1.0),), radius=0.3)
    parts = mover_parts(mover)
    points = points_of(parts)
    assert len(parts) <= 10
    assert points[:, 2].max() == pytest.approx(height, abs=0.08)
    assert points[:, 2].min() == pytest.approx(0.0, abs=0.02)
    assert np.abs(points[:, 1]).max() <= 0.3 + 0.03


def test_a_broad_person_is_broader():
    narrow, broad = (
        points_of(
            mover_parts(Mover(name="one", kind="person", points=((0, 0), (1, 0)), pace=((0.0, 1.0),), radius=radius))
        )
        for radius in (0.3, 0.45)
    )
    assert np.ptp(broad[:, 1]) > 1.2 * np.ptp(narrow[:, 1])
    assert math.isclose(narrow[:, 2].max(), broad[:, 2].max())
