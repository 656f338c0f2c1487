"""The shape of a GLB file, resolved: accessors, morph targets, skins and the scene's nodes become plain triangles.

Source: glTF 2.0 specification, sections 3.5 (nodes), 3.6 (accessors), 3.7 (meshes, morph targets, skins) and 5.1;
KHR_mesh_quantization; KHR_node_visibility.
"""

import base64
import binascii
import json
from collections.abc import Iterator
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from app.scene.models.glb_document import (
    COMPONENTS,
    FAN,
    STRIP,
    TRIANGLES,
    Accessor,
    GlbDocument,
    GlbMesh,
    Node,
    Primitive,
    Skin,
    chunks,
    packed,
)
from app.texts import Text

Numbers = NDArray[np.float64]

TYPES: Final = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
MOST_TARGETS: Final = 500  # morph targets of one primitive
COLOUR_ATTRIBUTES: Final = ("COLOR_0", "TEXCOORD_0", "TEXCOORD_1")
COLOUR_PARTS: Final = ("materials", "textures", "images", "samplers")  # parts of a document that give colours
FLOAT, UNSIGNED = 5126, 5125
WEIGHT_SUM: Final = 0.01  # of a vertex's joints, below which it follows none of them


def plain_glb(document: GlbDocument, content: bytes) -> tuple[bytes, Numbers]:
    """Return a GLB file of the same look that contains triangles in world coordinates only, and all their corners.

    Returns
    -------
    bytes
        The file: one node for each part of a mesh, without transformations, skins, targets or sparse accessors.
    Numbers
        (n, 3), m, the corners of all faces.

    Raises
    ------
    UnreadableError
        Half a sentence that says what is wrong and what to do.
    IndexError
        When the file refers to parts that are not in it.
    """
    return _Plain(document, content).written()


class UnreadableError(ValueError):
    """What is wrong with a file, as half a sentence; NumPy's own errors are other ValueErrors."""


class _Plain:
    """Builds the plain file part by part."""

    def __init__(self, document: GlbDocument, content: bytes) -> None:
        self._document = document
        self._raw, binary = chunks(content)
        self._buffers = [binary if source.uri is None else _from_uri(source.uri) for source in document.buffers]
        self._body = bytearray()
        self._views: list[dict[str, int]] = []
        self._accessors: list[dict[str, int | str]] = []
        self._corners: list[Numbers] = []

    def written(self) -> tuple[bytes, Numbers]:
        meshes = [
            {"primitives": [part]}
            for node, matrix in self._nodes()
            if node.mesh is not None
            for part in self._parts(node, self._document.meshes[node.mesh], matrix)
        ]
        original = json.loads(self._raw)
        plain = {key: original[key] for key in COLOUR_PARTS if key in original}
        if plain.get("images"):
            plain["images"] = [self._image(image) for image in plain["images"]]
        plain |= {
            "asset": {"version": "2.0"},
            "scene": 0,
            "scenes": [{"nodes": list(range(len(meshes)))}],
            "nodes": [{"mesh": number} for number in range(len(meshes))],
            "meshes": meshes,
            "accessors": self._accessors,
            "bufferViews": self._views,
            "buffers": [{"byteLength": len(self._body)}],
        }
        corners = np.concatenate(self._corners) if self._corners else np.zeros((0, 3))
        return packed(plain, bytes(self._body)), corners

    def _nodes(self) -> Iterator[tuple[Node, Numbers]]:
        """Yield the visible nodes of the scene with their global matrices (4, 4)."""
        for number, matrix in self._global_matrices(visible=True).items():
            yield self._document.nodes[number], matrix

    def _global_matrices(self, *, visible: bool) -> dict[int, Numbers]:
        document = self._document
        if document.scenes:
            roots = document.scenes[document.scene or 0].nodes
        else:
            children = {child for node in document.nodes for child in node.children}
            roots = [number for number in range(len(document.nodes)) if number not in children]
        matrices: dict[int, Numbers] = {}
        waiting = [(root, np.eye(4)) for root in reversed(roots)]
        while waiting:
            number, above = waiting.pop()
            node = document.nodes[number]
            if visible and not node.extensions.get("KHR_node_visibility", {}).get("visible", True):
                continue
            matrices[number] = above @ _local_matrix(node)
            waiting += [(child, matrices[number]) for child in reversed(node.children)]
        return matrices

    def _parts(self, node: Node, mesh: GlbMesh, matrix: Numbers) -> Iterator[dict[str, object]]:
        """Yield the primitives of one node's mesh in world coordinates."""
        for primitive in mesh.primitives:
            listed = primitive.attributes.get("POSITION")
            if listed is None or primitive.mode not in {TRIANGLES, STRIP, FAN}:
                continue
            places = self._morphed(primitive, listed, node.weights or mesh.weights)
            if node.skin is None:
                world = places @ matrix[:3, :3].T + matrix[:3, 3]
            else:
                world = self._skinned(primitive, places, self._document.skins[node.skin])
            faces = self._faces(primitive, len(places))
            if node.skin is None and np.linalg.det(matrix[:3, :3]) < 0:
                faces = faces[:, ::-1]  # a mirrored face would look inwards
            if not len(faces):
                continue
            self._corners.append(world[np.unique(faces)])
            attributes = {"POSITION": self._added(world.astype("<f4"), "VEC3")}
            for name in COLOUR_ATTRIBUTES:
                if name in primitive.attributes:
                    accessor = self._document.accessors[primitive.attributes[name]]
                    values = self._values(accessor)
                    if len(values) == len(places):
                        attributes[name] = self._added(values.astype("<f4"), accessor.type)
            part: dict[str, object] = {
                "attributes": attributes,
                "indices": self._added(faces.astype("<u4").ravel(), "SCALAR"),
                "mode": 4,
            }
            if primitive.material is not None:
                part["material"] = primitive.material
            yield part

    def _morphed(self, primitive: Primitive, listed: int, weights: list[float]) -> Numbers:
        places = self._values(self._document.accessors[listed])
        if len(primitive.targets) > MOST_TARGETS:
            raise UnreadableError(Text("object-targets", most=MOST_TARGETS))
        for target, weight in zip(primitive.targets, weights, strict=False):
            if weight and "POSITION" in target:
                places = places + weight * self._values(self._document.accessors[target["POSITION"]])
        return places

    def _skinned(self, primitive: Primitive, places: Numbers, skin: Skin) -> Numbers:
        """Return the places moved by the joints in the pose of the file; the node's own place has no effect."""
        matrices = self._global_matrices(visible=False)
        joints = np.array([matrices[joint] if joint in matrices else np.eye(4) for joint in skin.joints])
        if skin.inverse_bind_matrices is not None:
            inverse = self._values(self._document.accessors[skin.inverse_bind_matrices])
            joints = joints @ inverse[: len(joints)].reshape(-1, 4, 4).transpose(0, 2, 1)  # stored by columns
        moved, total = np.zeros_like(places), np.zeros(len(places))
        group = 0
        while f"JOINTS_{group}" in primitive.attributes and f"WEIGHTS_{group}" in primitive.attributes:
            numbers = self._values(self._document.accessors[primitive.attributes[f"JOINTS_{group}"]]).astype(np.intp)
            weights = self._values(self._document.accessors[primitive.attributes[f"WEIGHTS_{group}"]])
            for column in range(4):
                turned = np.einsum("nij,nj->ni", joints[numbers[:, column]][:, :3, :3], places)
                moved += weights[:, column, np.newaxis] * (turned + joints[numbers[:, column]][:, :3, 3])
                total += weights[:, column]
            group += 1
        follows = total > WEIGHT_SUM
        moved[follows] /= total[follows, np.newaxis]
        moved[~follows] = places[~follows]
        return moved

    def _faces(self, primitive: Primitive, count: int) -> NDArray[np.int64]:
        """Return the triangles (n, 3)."""
        if primitive.indices is None:
            order = np.arange(count)
        else:
            order = self._values(self._document.accessors[primitive.indices]).ravel().astype(np.int64)
        if len(order) and not 0 <= order.min() <= order.max() < count:
            raise IndexError("a face has a corner that does not exist")
        if primitive.mode == TRIANGLES:
            return order[: len(order) // 3 * 3].reshape(-1, 3)
        if len(order) < 3:
            return np.zeros((0, 3), dtype=np.int64)
        if primitive.mode == FAN:
            return np.column_stack([order[1:-1], order[2:], np.full(len(order) - 2, order[0])])
        faces = np.column_stack([order[:-2], order[1:-1], order[2:]])
        faces[1::2] = faces[1::2][:, [0, 2, 1]]
        return faces

    def _values(self, accessor: Accessor) -> Numbers:
        """Return an accessor's values (count, width), dense and dequantized."""
        width = COMPONENTS[accessor.type]
        if accessor.buffer_view is None:
            raw = np.zeros((accessor.count, width))
        else:
            raw = self._read(accessor.buffer_view, accessor.byte_offset, accessor.component_type, accessor.count, width)
        if accessor.sparse is not None:
            sparse = accessor.sparse
            at, values = sparse.indices, sparse.values
            rows = self._read(at.buffer_view, at.byte_offset, at.component_type, sparse.count, 1)
            if sparse.count and rows.max() >= accessor.count:
                raise IndexError("a sparse value lies beyond its list")
            raw[rows.ravel().astype(np.intp)] = self._read(
                values.buffer_view, values.byte_offset, accessor.component_type, sparse.count, width
            )
        if accessor.normalized and accessor.component_type != FLOAT:
            return np.asarray(np.maximum(raw / np.iinfo(TYPES[accessor.component_type]).max, -1.0))
        return raw

    def _read(self, view_number: int, offset: int, component: int, count: int, width: int) -> Numbers:
        view = self._document.buffer_views[view_number]
        kind = np.dtype(TYPES[component])
        # A matrix of small components has padded columns; no accessor that is read here has such a type.
        step = view.byte_stride or kind.itemsize * width
        buffer = self._buffers[view.buffer]
        start = view.byte_offset + offset
        end = start + step * (count - 1) + kind.itemsize * width
        if count and end > len(buffer):
            raise UnreadableError(Text("object-cut-off"))
        if count and end > view.byte_offset + view.byte_length:
            raise IndexError("a list ends beyond its data")
        shape, strides = (count, width), (step, kind.itemsize)
        return np.ndarray(shape, kind, buffer, start, strides).astype(np.float64) if count else np.zeros(shape)

    def _image(self, image: dict[str, Any]) -> dict[str, Any]:
        if "bufferView" not in image:
            return image
        view = self._document.buffer_views[image["bufferView"]]
        data = self._buffers[view.buffer][view.byte_offset : view.byte_offset + view.byte_length]
        return image | {"bufferView": self._viewed(data)}

    def _added(self, values: NDArray[np.generic], kind: str) -> int:
        component = FLOAT if values.dtype.kind == "f" else UNSIGNED
        view = self._viewed(values.tobytes())
        self._accessors.append({"bufferView": view, "componentType": component, "count": len(values), "type": kind})
        return len(self._accessors) - 1

    def _viewed(self, data: bytes) -> int:
        self._views.append({"buffer": 0, "byteOffset": len(self._body), "byteLength": len(data)})
        self._body += data + bytes(-len(data) % 4)
        return len(self._views) - 1


def _local_matrix(node: Node) -> Numbers:
    if node.matrix is not None:
        return np.array(node.matrix, dtype=np.float64).reshape(4, 4).T  # stored by columns
    x, y, z, w = np.array(node.rotation) / (np.linalg.norm(node.rotation) or 1.0)
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    matrix = np.eye(4)
    matrix[:3, :3] = turn * np.array(node.scale)
    matrix[:3, 3] = node.translation
    return matrix


def _from_uri(uri: str) -> bytes:
    try:
        return base64.b64decode(uri.partition(",")[2], validate=True)
    except binascii.Error as error:
        raise UnreadableError(Text("object-damaged")) from error
