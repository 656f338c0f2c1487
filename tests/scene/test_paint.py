"""Colours at vertices: what the renderer shows of them, and their GLB files.

The files are read by trimesh, and by the check of foreign files.
"""

import io

import msgspec
import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from scene.shown_colours import shown

from app.scene.meshes.bodies import ball, box, rectangle
from app.scene.meshes.paint import PaintedPart, joined, light_of, painted, unlit_glb
from app.scene.models.glb_import import check
from app.world.scenery import Lights

GREY = st.integers(min_value=0, max_value=220)
HUE = st.integers(min_value=-15, max_value=15)


@given(GREY, HUE, HUE)
def test_a_colour_is_shown_as_it_was_chosen(grey, red, blue):
    colour = tuple(min(max(grey + more, 0), 220) for more in (red, 0, blue))
    light = light_of(colour)
    if light.min() > 0 and light.max() < 1:
        assert shown(light) == pytest.approx(colour, abs=0.6)


def test_white_is_shown_as_white_as_can_be():
    assert (light_of((255, 255, 255)) == 1).all()
    assert shown(np.ones(3)).min() > 220


def test_the_default_lights_show_the_colour_and_dimmer_ones_a_darker_one():
    colour = (150, 155, 160)
    floor = rectangle(0, 0, 1, 1, 0)
    assert shown(painted(floor, colour, Lights()).light) == pytest.approx(np.tile(colour, (4, 1)), abs=0.6)
    dim = painted(floor, colour, Lights(sun=0.1, sky=0.3)).light
    assert (shown(dim) < 120).all()
    assert (painted(floor, colour, Lights(), 0.5).light < painted(floor, colour, Lights()).light).all()


def test_two_walls_of_a_corner_have_different_light():
    sides = painted(box((1, 1, 1)), (200, 200, 200), Lights()).light.mean(axis=1).reshape(6, 4)
    assert (np.ptp(sides, axis=1) < 1e-12).all()
    faces = dict(zip(("top", "bottom", "ahead", "behind", "left", "right"), sides[:, 0], strict=True))
    assert faces["right"] > 1.05 * faces["behind"] > 1.05 * faces["ahead"]


def test_parts_are_joined_in_order():
    one, other = (painted(box((1, 1, 1)), (grey,) * 3, Lights()) for grey in (50, 150))
    both = joined([one, other])
    assert (both.light[: len(one.light)] == one.light).all()
    assert len(both.light) == len(both.mesh.vertices)
    assert len(joined([]).light) == 0


@pytest.mark.parametrize("sides", [8, 380])  # the larger one has more vertices than 16 bits can number
def test_a_painted_mesh_is_read_as_it_was_written(sides):
    mesh = ball((1.0, 2.0, 3.0), 1.5, sides)
    light = np.random.default_rng(1).uniform(0, 1, (len(mesh.vertices), 3))
    content = unlit_glb(PaintedPart(mesh, light))
    check(content) if sides == 8 else None
    (read,) = trimesh.load_scene(io.BytesIO(content), file_type="glb", process=False).geometry.values()
    assert read.vertices == pytest.approx(mesh.vertices, abs=1e-6)
    assert (read.faces == mesh.faces).all()
    colours = read.visual.vertex_attributes["color"]
    assert np.abs(colours[:, :3] - 255 * light).max() <= 0.5
    assert (colours[:, 3] == 255).all()


def test_the_renderer_is_told_to_compute_no_light():
    content = unlit_glb(PaintedPart(ball((0, 0, 0), 1.0, 5), np.zeros((len(ball((0, 0, 0), 1.0, 5).vertices), 3))))
    assert int.from_bytes(content[8:12], "little") == len(content)
    assert len(content) % 4 == 0
    document = msgspec.json.decode(content[20 : 20 + int.from_bytes(content[12:16], "little")])
    assert document["materials"] == [{"extensions": {"KHR_materials_unlit": {}}}]
    assert document["extensionsUsed"] == ["KHR_materials_unlit"]
