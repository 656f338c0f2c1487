"""Rocks, cones and movers: each is drawn inside the circle at which the chair touches it."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.geometry import Pose
from app.scene.meshes.bodies import Part
from app.scene.meshes.furniture import furniture, rock
from app.scene.meshes.movers import mover_parts
from app.scene.models.objects import Model
from app.scene.scene_state import Cones
from app.world.kinematics import CHAIR_RADIUS
from app.world.movers import Mover
from app.world.obstacles import Box, Cylinder
from app.world.scenery import Cone

metres = st.floats(-50, 50)


def points_of(parts):
    return np.concatenate([part.mesh.vertices for part in parts])


@settings(max_examples=60)
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
