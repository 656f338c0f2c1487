"""The parts of a glTF 2.0 document that are read, and the chunks of a GLB file."""

import json
import struct
from collections.abc import Mapping
from typing import Annotated, Any, Final

import msgspec

from app.texts import Text

TRIANGLES, STRIP, FAN = 4, 5, 6  # modes of a primitive
MAGIC: Final = b"glTF"
JSON_CHUNK: Final = 0x4E4F534A
BYTES: Final = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}  # of a component, by its type
COMPONENTS: Final = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
BIN_CHUNK: Final = 0x004E4942

Index = Annotated[int, msgspec.Meta(ge=0)]
Vector = tuple[float, float, float]
Extensions = dict[str, Any]
"""What extensions of glTF say, by the name of the extension."""


class SparseIndices(msgspec.Struct, rename="camel"):
    """The numbers of the elements that a sparse accessor replaces."""

    buffer_view: Index
    component_type: Index
    byte_offset: Index = 0


class SparseValues(msgspec.Struct, rename="camel"):
    """The values that a sparse accessor puts in their places."""

    buffer_view: Index
    byte_offset: Index = 0


class Sparse(msgspec.Struct):
    """The elements of an accessor that differ from its view, or from zero when it has none."""

    count: Index
    indices: SparseIndices
    values: SparseValues


class Accessor(msgspec.Struct, rename="camel"):
    """A list of numbers or vectors in a view."""

    count: Index
    component_type: Index = 5126
    type: str = "VEC3"
    buffer_view: Index | None = None
    byte_offset: Index = 0
    normalized: bool = False
    sparse: Sparse | None = None


class View(msgspec.Struct, rename="camel"):
    """A part of a buffer."""

    buffer: Index = 0
    byte_length: Index = 0
    byte_offset: Index = 0
    byte_stride: Index | None = None
    extensions: Extensions = {}


class Primitive(msgspec.Struct):
    """A part of a mesh with one material."""

    attributes: dict[str, Index] = {}
    indices: Index | None = None
    mode: Index = TRIANGLES
    material: Index | None = None
    targets: list[dict[str, Index]] = []
    extensions: Extensions = {}


class GlbMesh(msgspec.Struct):
    """A mesh; `weights` are those of its primitives' morph targets."""

    primitives: list[Primitive] = []
    weights: list[float] = []


class Node(msgspec.Struct):
    """A node of the scene; its place is `matrix`, or else scale, then rotation, then translation."""

    mesh: Index | None = None
    skin: Index | None = None
    children: list[Index] = []
    matrix: Annotated[list[float], msgspec.Meta(min_length=16, max_length=16)] | None = None
    translation: Vector = (0.0, 0.0, 0.0)
    rotation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)  # x, y, z, w
    scale: Vector = (1.0, 1.0, 1.0)
    weights: list[float] = []
    extensions: Extensions = {}


class Skin(msgspec.Struct, rename="camel"):
    """The joints (nodes) that move a mesh."""

    joints: list[Index]
    inverse_bind_matrices: Index | None = None


class Roots(msgspec.Struct):
    """A scene: the nodes at the top of its tree."""

    nodes: list[Index] = []


class BufferSource(msgspec.Struct, rename="camel"):
    """A buffer or an image: data in the file or elsewhere."""

    uri: str | None = None
    buffer_view: Index | None = None
    byte_length: Index = 0


class GlbDocument(msgspec.Struct, rename="camel"):
    """The JSON document of a GLB file; other fields are ignored."""

    accessors: list[Accessor] = []
    meshes: list[GlbMesh] = []
    nodes: list[Node] = []
    scenes: list[Roots] = []
    scene: Index | None = None
    skins: list[Skin] = []
    buffers: list[BufferSource] = []
    buffer_views: list[View] = []
    images: list[BufferSource] = []
    extensions_required: list[str] = []


def chunks(content: bytes) -> tuple[bytes, bytes]:
    """Return the JSON chunk of a GLB file and its binary chunk, which may be empty.

    Layout (glTF 2.0, section 4): u32 little-endian magic, version 2, length; then chunks of u32 length, u32 kind and
    bytes, the first of them JSON.

    Raises
    ------
    ValueError
        Half a sentence that says what is wrong and what to do.
    """
    if content[:4] != MAGIC or len(content) < 20:
        raise ValueError(Text("object-no-glb"))
    version, _, length, kind = struct.unpack_from("<4I", content, 4)
    if version != 2:
        raise ValueError(Text("object-version", version=version))
    end = 20 + length
    if kind != JSON_CHUNK or end > len(content):
        raise ValueError(Text("object-cut-off"))
    if end + 8 > len(content):
        return content[20:end], b""
    length, kind = struct.unpack_from("<2I", content, end)
    if end + 8 + length > len(content):
        raise ValueError(Text("object-cut-off"))
    return content[20:end], content[end + 8 : end + 8 + length] if kind == BIN_CHUNK else b""


def packed(document: Mapping[str, object], body: bytes) -> bytes:
    """Return the GLB file of a JSON document and a binary chunk."""
    description = json.dumps(document).encode()
    description += b" " * (-len(description) % 4)
    parts = (
        struct.pack("<2I", len(description), JSON_CHUNK) + description + struct.pack("<2I", len(body), BIN_CHUNK) + body
    )
    return MAGIC + struct.pack("<2I", 2, 12 + len(parts)) + parts


def read_document(content: bytes) -> GlbDocument:
    """Return the document of a GLB file.

    Raises
    ------
    ValueError
        Half a sentence that says what is wrong and what to do.
    """
    description, _ = chunks(content)
    try:
        return msgspec.json.decode(description, type=GlbDocument)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(Text("object-no-description")) from error
