"""Painted meshes as GLB files, read again by trimesh and by the check of foreign files."""

import io

import msgspec
import numpy as np
import pytest
import trimesh

from app.scene.meshes.bodies import ball
from app.scene.meshes.paint import PaintedPart
from app.scene.models.glb_check import check
from app.scene.unlit_glb import unlit_glb


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
