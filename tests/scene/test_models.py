import json
import os
import struct

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image
from trimesh.visual.material import PBRMaterial

from app import isolated_reader
from app.scene.models import glb_document, glb_import
from app.scene.models.glb_import import MOST_COLOURS, read_model
from app.scene.models.objects import READINGS, stored_model


def coloured_box(size, colour, at=(0, 0, 0)):
    body = trimesh.creation.box(size)
    body.apply_translation(at)
    body.visual = trimesh.visual.TextureVisuals(material=PBRMaterial(baseColorFactor=[*colour, 255]))
    return body


def chair_like():
    return trimesh.Scene(
        [
            coloured_box((0.4, 0.1, 0.6), (200, 30, 30), (5, 1, 2)),
            coloured_box((0.1, 0.9, 0.1), (20, 20, 20), (5, 1, 2)),
        ]
    )


@pytest.fixture
def write(tmp_path):
    def written(content):
        file = tmp_path / "thing.glb"
        file.write_bytes(content)
        return file

    return written


def binary(document, body=b""):
    words = json.dumps({"asset": {"version": "2.0"}} | document).encode()
    words += b" " * (-len(words) % 4)
    chunks = struct.pack("<2I", len(words), glb_document.JSON_CHUNK) + words
    if body:
        chunks += struct.pack("<2I", len(body), 0x004E4942) + body
    return glb_document.MAGIC + struct.pack("<2I", 2, 12 + len(chunks)) + chunks


def test_an_object_stands_on_the_floor_in_its_own_size_and_colours(write):
    model = read_model(write(chair_like().export(file_type="glb")))
    # glTF's x, y and z point left, up and ahead; those of a plan point ahead, left and up.
    assert model.size == pytest.approx((0.6, 0.4, 0.9))
    assert model.faces == 24
    assert {part.colour for part in model.parts} == {(200, 30, 30), (20, 20, 20)}
    points = np.concatenate([part.mesh.vertices for part in model.parts])
    assert points.min(axis=0) == pytest.approx([-0.3, -0.2, 0.0])
    assert points.max(axis=0) == pytest.approx([0.3, 0.2, 0.9])


def test_an_object_is_stretched_into_a_box(write):
    parts = read_model(write(chair_like().export(file_type="glb"))).scaled(2.0, 1.0, 0.5)
    points = np.concatenate([part.mesh.vertices for part in parts])
    assert points.max(axis=0) - points.min(axis=0) == pytest.approx([2.0, 1.0, 0.5])


def test_faces_still_look_outwards(write):
    model = read_model(write(trimesh.Scene([coloured_box((1, 2, 3), (9, 9, 9))]).export(file_type="glb")))
    (part,) = model.parts
    a, b, c = (part.mesh.vertices[part.mesh.faces[:, corner]] for corner in range(3))
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 == pytest.approx(6.0)


def test_a_picture_becomes_the_colours_of_its_faces(write):
    body = trimesh.creation.box((1, 1, 1))
    picture = Image.new("RGB", (8, 8), (0, 0, 255))
    material = PBRMaterial(baseColorTexture=picture, baseColorFactor=[255, 255, 255, 255])
    body.visual = trimesh.visual.TextureVisuals(uv=np.full((len(body.vertices), 2), 0.5), material=material)
    (part,) = read_model(write(trimesh.Scene([body]).export(file_type="glb"))).parts
    assert part.colour == (0, 0, 255)


def test_many_colours_become_few(write):
    boxes = [coloured_box((1, 1, 1), (8 * k % 256, 40 * k % 256, 90 * k % 256), (2 * k, 0, 0)) for k in range(30)]
    model = read_model(write(trimesh.Scene(boxes).export(file_type="glb")))
    assert len(model.parts) == MOST_COLOURS
    assert model.faces == 30 * 12


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "no GLB file"),
        (b"solid x", "no GLB file"),
        (glb_document.MAGIC + struct.pack("<4I", 1, 20, 0, glb_document.JSON_CHUNK), "version 1"),
        (glb_document.MAGIC + struct.pack("<4I", 2, 20, 500, glb_document.JSON_CHUNK), "cut off"),
        (binary({"nodes": 5}), "description cannot be read"),
        (binary({"meshes": [{"primitives": [{"indices": -1}]}]}), "description cannot be read"),
        (binary({}), "nothing with faces"),
        (binary({"extensionsRequired": ["KHR_draco_mesh_compression"]}), "KHR_draco_mesh_compression"),
        (
            binary(
                {
                    "nodes": [{"mesh": 0}],
                    "meshes": [{"primitives": [{"attributes": {}, "extensions": {"KHR_draco_mesh_compression": {}}}]}],
                }
            ),
            "Draco",
        ),
        (binary({"buffers": [{"byteLength": 4, "uri": "more.bin"}]}), "other files"),
        (binary({"images": [{"uri": "http://example.org/a.png"}]}), "other files"),
        (binary({"accessors": [{"count": 2_000_000_000}]}), "lists of more than"),
        (binary({"nodes": [{"children": [1]}, {"children": [0]}], "scenes": [{"nodes": [0]}]}), "tree"),
        (binary({"nodes": [{"children": [2]}, {"children": [2]}, {}]}), "tree"),
        (binary({"nodes": [{"mesh": 3}]}), "parts that are not in it"),
        (
            binary(
                {
                    "nodes": [{"mesh": 0}] * 101,
                    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                    "accessors": [{"count": 3000}],
                }
            ),
            "101,000 faces",
        ),
    ],
)
def test_a_file_that_cannot_be_drawn_is_refused_in_one_sentence(write, content, words):
    with pytest.raises(ValueError, match=words) as refused:
        read_model(write(content))
    assert str(refused.value).startswith("thing.glb: this object cannot be used, ")
    assert "\n" not in str(refused.value)


def test_too_large_a_file_and_none_are_refused(write, tmp_path, monkeypatch):
    with pytest.raises(ValueError, match="cannot be read"):
        read_model(tmp_path / "none.glb")
    monkeypatch.setattr("app.scene.models.glb_import.MOST_BYTES", 100)
    monkeypatch.setattr(glb_import, "MOST_BYTES", 100)
    with pytest.raises(ValueError, match="larger than"):
        read_model(write(chair_like().export(file_type="glb")))


WHOLE = chair_like().export(file_type="glb")


@settings(max_examples=40)
@given(st.integers(0, len(WHOLE) - 1), st.binary(min_size=1, max_size=8))
def test_a_damaged_file_is_drawn_or_refused(tmp_path_factory, place, bytes_there):
    file = tmp_path_factory.getbasetemp() / "damaged.glb"
    file.write_bytes(WHOLE[:place] + bytes_there + WHOLE[place + len(bytes_there) :])
    try:
        model = read_model(file)
    except ValueError:
        return
    assert all(np.isfinite(part.mesh.vertices).all() for part in model.parts)


@settings(max_examples=40)
@given(st.integers(0, len(WHOLE) - 1))
def test_a_file_cut_off_is_refused(tmp_path_factory, end):
    file = tmp_path_factory.getbasetemp() / "cut.glb"
    file.write_bytes(WHOLE[:end])
    with pytest.raises(ValueError, match=r"damaged|no GLB file|cut off|nothing with faces"):
        read_model(file)


def touched(file, later):
    """Change a file's time, so that the object is not taken from memory."""
    os.utime(file, ns=(later, later))
    return file


def same(one, other):
    assert one.size == other.size
    for part, twin in zip(one.parts, other.parts, strict=True):
        assert part.colour == twin.colour
        np.testing.assert_array_equal(part.mesh.vertices, twin.mesh.vertices)
        np.testing.assert_array_equal(part.mesh.faces, twin.mesh.faces)


def test_a_stored_object_is_read_once_in_a_process_of_its_own(write, monkeypatch):
    file = write(WHOLE)
    same(stored_model(file), read_model(file))
    (reading,) = (file.parent / READINGS).iterdir()
    reading.write_bytes(reading.read_bytes()[:100])
    same(stored_model(touched(file, 1)), read_model(file))
    monkeypatch.setattr(isolated_reader, "COMMAND", ("false",))
    same(stored_model(touched(file, 2)), read_model(file))


def test_a_refused_object_is_not_read_again(write, monkeypatch):
    file = write(binary({}))
    for later in (1, 2):
        with pytest.raises(ValueError, match="nothing with faces"):
            stored_model(touched(file, later))
        monkeypatch.setattr(isolated_reader, "COMMAND", ("false",))
