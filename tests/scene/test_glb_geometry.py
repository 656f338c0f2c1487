"""The size of a GLB file in each way that glTF 2.0 has to store its points."""

import base64
import json
import math
import struct

import numpy as np
import pytest

from app.scene.models import glb_document
from app.scene.models.glb_import import answer, read_model, scaled_glb
from app.scene.models.objects import THINNEST
from folders import SHARED

CASES = SHARED / "data" / "cases"
# A box of 1 x 2 x 3 m in glTF's axes: y up, z ahead. The model's axes are ahead, left, up.
CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 2) for z in (0, 3)], dtype=float)
FACES = np.array(
    [
        *([0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1]),
        *([2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]),
    ]
)
KINDS = {"<i1": 5120, "<u1": 5121, "<i2": 5122, "<u2": 5123, "<u4": 5125, "<f4": 5126}
HALF = math.sqrt(0.5)


class Writer:
    """Puts accessors into the buffer of a GLB file."""

    def __init__(self):
        self.body, self.views, self.accessors = b"", [], []

    def view(self, data, **fields):
        self.views.append({"buffer": 0, "byteOffset": len(self.body), "byteLength": len(data)} | fields)
        self.body += data + bytes(-len(data) % 4)
        return len(self.views) - 1

    def add(self, values, kind, shape, **fields):
        values = np.asarray(values).astype(kind)
        view = self.view(values.tobytes())
        self.accessors.append(
            {"bufferView": view, "componentType": KINDS[kind], "count": len(values), "type": shape} | fields
        )
        return len(self.accessors) - 1

    def write(self, file, document):
        whole = {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.body)}],
        } | document
        words = json.dumps(whole).encode()
        words += b" " * (-len(words) % 4)
        content = struct.pack("<2I", len(words), glb_document.JSON_CHUNK) + words
        content += struct.pack("<2I", len(self.body), glb_document.BIN_CHUNK) + self.body
        file.write_bytes(glb_document.MAGIC + struct.pack("<2I", 2, 12 + len(content)) + content)
        return file


@pytest.fixture
def box(tmp_path):
    """Return a function that writes the box with a document of one's own, and reads its size: ahead, left, up.

    Each such file is read a second time, half as large.
    """
    writer = Writer()

    def size(position=None, mesh=(), primitive=(), **document):
        if position is None:
            position = writer.add(CORNERS, "<f4", "VEC3")
        indices = writer.add(FACES.ravel(), "<u2", "SCALAR")
        parts = {"attributes": {"POSITION": position}, "indices": indices} | dict(primitive)
        meshes = [{"primitives": [parts]} | dict(mesh)]
        file = writer.write(tmp_path / "box.glb", {"meshes": meshes} | document)
        found = read_model(file).size
        half = tmp_path / "half.glb"
        half.write_bytes(scaled_glb(file.read_bytes(), 0.5))
        assert read_model(half).size == pytest.approx(np.array(found) / 2, abs=THINNEST)
        return found

    size.writer = writer
    return size


def sparse(writer, rows, values, count=8, **accessor):
    at, there = writer.view(np.array(rows, "<u2").tobytes()), writer.view(np.array(values, "<f4").tobytes())
    part = {"count": len(rows), "indices": {"bufferView": at, "componentType": 5123}, "values": {"bufferView": there}}
    writer.accessors.append({"componentType": 5126, "count": count, "type": "VEC3", "sparse": part} | accessor)
    return len(writer.accessors) - 1


def test_the_plain_box(box):
    assert box() == pytest.approx((3, 1, 2))


def test_sparse_values_over_a_view(box):
    flat = CORNERS * (1, 0, 1)
    high = [number for number, corner in enumerate(CORNERS) if corner[1] > 0]
    view = box.writer.view(flat.astype("<f4").tobytes())
    assert box(sparse(box.writer, high, CORNERS[high], bufferView=view)) == pytest.approx((3, 1, 2))


def test_sparse_values_over_nothing(box):
    assert box(sparse(box.writer, range(8), CORNERS)) == pytest.approx((3, 1, 2))


def test_a_sparse_value_beyond_the_list_is_refused(box):
    with pytest.raises(ValueError, match="parts that are not in it"):
        box(sparse(box.writer, [8], CORNERS[:1]))


@pytest.mark.parametrize(("kind", "most"), [("<i1", 127), ("<u1", 255), ("<i2", 32767), ("<u2", 65535)])
def test_normalized_points_are_shares_of_their_range(box, kind, most):
    position = box.writer.add(np.rint(CORNERS / 3 * most), kind, "VEC3", normalized=True)
    nodes = [{"mesh": 0, "scale": [3, 3, 3]}]
    size = box(position, nodes=nodes, extensionsRequired=["KHR_mesh_quantization"])
    assert size == pytest.approx((3, 1, 2), rel=0.02)


@pytest.mark.parametrize("kind", ["<i1", "<u1", "<i2", "<u2"])
def test_whole_numbers_are_lengths(box, kind):
    position = box.writer.add(CORNERS, kind, "VEC3")
    assert box(position, extensionsUsed=["KHR_mesh_quantization"]) == pytest.approx((3, 1, 2))


def test_points_between_other_data(box):
    data = np.hstack([CORNERS, np.full((8, 3), 99.0)]).astype("<f4")
    view = box.writer.view(data.tobytes(), byteStride=24)
    box.writer.accessors.append({"bufferView": view, "componentType": 5126, "count": 8, "type": "VEC3"})
    assert box(len(box.writer.accessors) - 1) == pytest.approx((3, 1, 2))


def test_a_buffer_in_the_document(box, tmp_path):
    position = box.writer.add(CORNERS, "<f4", "VEC3")
    box.writer.views[-1] |= {"buffer": 1, "byteOffset": 0}
    uri = "data:application/octet-stream;base64," + base64.b64encode((CORNERS * 2).astype("<f4").tobytes()).decode()
    buffers = [{"byteLength": 10_000}, {"byteLength": 96, "uri": uri}]
    assert box(position, buffers=buffers) == pytest.approx((6, 2, 4))


@pytest.mark.parametrize("where", ["mesh", "node"])
@pytest.mark.parametrize(("weight", "height"), [(0.0, 2), (0.5, 3), (1.0, 4), (-1.0, 1e-6)])
def test_the_weights_of_morph_targets_count(box, where, weight, height):
    target = box.writer.add(CORNERS * (0, 1, 0), "<f4", "VEC3")
    primitive = {"targets": [{"POSITION": target}]}
    if where == "mesh":
        size = box(mesh={"weights": [weight]}, primitive=primitive)
    else:  # a node's weights replace those of the mesh
        size = box(mesh={"weights": [7.0]}, primitive=primitive, nodes=[{"mesh": 0, "weights": [weight]}])
    assert size == pytest.approx((3, 1, height))


def test_a_sparse_morph_target(box):
    target = sparse(box.writer, [7], [[0, 0, 2]])
    assert box(mesh={"weights": [1.0]}, primitive={"targets": [{"POSITION": target}]}) == pytest.approx((5, 1, 2))


@pytest.mark.parametrize("inverse", [True, False])
def test_a_skin_moves_points_by_its_joints(box, inverse):
    writer = box.writer
    upper = CORNERS[:, 1] > 0
    joints = writer.add(np.column_stack([upper, np.zeros((8, 3))]), "<u1", "VEC4")
    weights = writer.add(np.tile([255, 0, 0, 0], (8, 1)), "<u1", "VEC4", normalized=True)
    skin = {"joints": [1, 2]}
    if inverse:
        matrices = np.stack([np.eye(4), np.eye(4)])
        matrices[1][1, 3] = -2  # the upper joint stands at a height of 2 m in the pose of the mesh
        skin["inverseBindMatrices"] = writer.add(matrices.transpose(0, 2, 1).reshape(2, 16), "<f4", "MAT4")
    position = writer.add(CORNERS, "<f4", "VEC3")
    size = box(
        position,
        primitive={"attributes": {"POSITION": position, "JOINTS_0": joints, "WEIGHTS_0": weights}},
        nodes=[{"mesh": 0, "skin": 0, "scale": [50, 50, 50]}, {"children": [2]}, {"translation": [0, 5, 0]}],
        scenes=[{"nodes": [0, 1]}],
        skins=[skin],
    )
    assert size == pytest.approx((3, 1, 5 if inverse else 7))


def test_a_size_that_does_not_follow_the_scale_is_refused(box, tmp_path):
    writer = box.writer
    joints = writer.add(np.zeros((8, 4)), "<u1", "VEC4")
    weights = writer.add(np.tile([255, 0, 0, 0], (8, 1)), "<u1", "VEC4", normalized=True)
    position, faces = writer.add(CORNERS, "<f4", "VEC3"), writer.add(FACES.ravel(), "<u2", "SCALAR")
    attributes = {"POSITION": position, "JOINTS_0": joints, "WEIGHTS_0": weights}
    document = {
        "meshes": [{"primitives": [{"attributes": attributes, "indices": faces}]}],
        "nodes": [{"mesh": 0, "skin": 0}, {}],  # the joint is in no scene
        "skins": [{"joints": [1]}],
    }
    file = writer.write(tmp_path / "body.glb", document)
    with pytest.raises(ValueError, match=r"body\.glb: the size of this object cannot be changed"):
        answer({"file": str(file), "readings": str(tmp_path / "readings"), "metres_per_unit": 0.01})


@pytest.mark.parametrize(
    ("node", "size"),
    [
        ({"scale": [2, 3, 4]}, (12, 2, 6)),
        ({"rotation": [0, HALF, 0, HALF]}, (1, 3, 2)),  # a quarter turn about the vertical axis
        ({"rotation": [HALF, 0, 0, HALF], "scale": [1, 2, 1]}, (4, 1, 3)),  # scaled first, then turned
        ({"matrix": [1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1]}, (3, 1, 4)),
        ({"matrix": [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]}, (1, 3, 2)),
        ({"scale": [-1, 1, 1]}, (3, 1, 2)),
    ],
)
def test_the_places_of_nodes(box, node, size):
    assert box(nodes=[{"children": [1]}, {"mesh": 0} | node]) == pytest.approx(size)


def test_a_mirrored_object_still_looks_outwards(box, tmp_path):
    box(nodes=[{"mesh": 0, "scale": [-1, 1, 1]}])
    (part,) = read_model(tmp_path / "box.glb").parts
    a, b, c = (part.mesh.vertices[part.mesh.faces[:, corner]] for corner in range(3))
    assert np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6 == pytest.approx(6.0)


def test_only_the_scene_and_what_is_visible_in_it_counts(box):
    hidden = {"mesh": 0, "scale": [9, 9, 9], "extensions": {"KHR_node_visibility": {"visible": False}}}
    nodes = [{"mesh": 0}, {"mesh": 0, "scale": [5, 5, 5]}, hidden]
    assert box(nodes=nodes, scenes=[{"nodes": [1]}, {"nodes": [0, 2]}], scene=1) == pytest.approx((3, 1, 2))


@pytest.mark.parametrize("mode", [5, 6])
def test_strips_and_fans(box, tmp_path, mode):
    corners = {5: [[0, 0, 0], [0, 0, 3], [1, 0, 0], [1, 0, 3]], 6: [[0, 0, 0], [0, 0, 3], [1, 0, 3], [1, 0, 0]]}[mode]
    position = box.writer.add(corners, "<f4", "VEC3")
    primitive = {"indices": box.writer.add(range(4), "<u1", "SCALAR"), "mode": mode}
    assert box(position, primitive=primitive) == pytest.approx((3, 1, 1e-6))
    (part,) = read_model(tmp_path / "box.glb").parts
    a, b, c = (part.mesh.vertices[part.mesh.faces[:, corner]] for corner in range(3))
    assert (np.cross(b - a, c - a)[:, 2] > 0).all()  # both faces look up


@pytest.mark.parametrize(
    ("document", "words"),
    [
        ({"extensionsRequired": ["EXT_meshopt_compression"]}, "EXT_meshopt_compression"),
        ({"extensionsRequired": ["KHR_draco_mesh_compression"]}, "KHR_draco_mesh_compression"),
        ({"nodes": [{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {}}}]}, "EXT_mesh_gpu_instancing"),
        ({"nodes": [{"mesh": 0, "skin": 3}]}, "parts that are not in it"),
        ({"nodes": [{"mesh": 0, "matrix": [1.0, 2.0]}]}, "description cannot be read"),
        ({"scene": 4}, "parts that are not in it"),
        ({"nodes": [{"mesh": 0, "scale": [1e300, 1e300, 1e300]}]}, "infinite or too far"),
    ],
)
def test_what_cannot_be_read_is_refused(box, document, words):
    with pytest.raises(ValueError, match=words) as refused:
        box(**document)
    assert "\n" not in str(refused.value)


def test_compressed_views_that_are_only_used_are_refused(box):
    position = box.writer.add(CORNERS, "<f4", "VEC3")
    box.writer.views[-1]["extensions"] = {"EXT_meshopt_compression": {"buffer": 0}}
    with pytest.raises(ValueError, match="compressed"):
        box(position, extensionsUsed=["EXT_meshopt_compression"])


def test_the_colours_of_corners_are_kept(box, tmp_path):
    colours = box.writer.add(np.tile([255, 0, 0, 255], (8, 1)), "<u1", "VEC4", normalized=True)
    position = box.writer.add(CORNERS, "<f4", "VEC3")
    box(position, primitive={"attributes": {"POSITION": position, "COLOR_0": colours}})
    assert read_model(tmp_path / "box.glb").parts[0].colour == (255, 0, 0)


@pytest.mark.parametrize(
    ("name", "size"),
    [("control", (3, 1, 2)), ("sparse", (3, 1, 2)), ("sparse-alone", (3, 1, 2)), ("morph-weight", (3, 1, 4))],
)
def test_the_objects_of_other_programs_have_their_size(name, size):
    file = CASES / f"glb-{name}.glb"
    if not file.exists():
        pytest.skip("the small files of other programs are not beside this checkout")
    assert read_model(file).size == pytest.approx(size)
