"""What a GLB file says about itself, looked at before anything is made of it: foreign files may ask for anything."""

import struct
from typing import Annotated, Any, Final

import msgspec

MOST_BYTES: Final = 20_000_000
MOST_FACES: Final = 100_000
MOST_NODES: Final = 10_000
MOST_NUMBERS: Final = 1_000_000  # elements of one accessor: it may claim any count without holding a byte

TRIANGLES, STRIP, FAN = 4, 5, 6  # modes of a primitive
READABLE: Final = ("KHR_materials_", "KHR_texture_transform")  # beginnings of extensions that do not change the shape
MAGIC: Final = b"glTF"
JSON_CHUNK: Final = 0x4E4F534A

Index = Annotated[int, msgspec.Meta(ge=0)]


class _Accessor(msgspec.Struct):
    count: Index


class _Primitive(msgspec.Struct):
    attributes: dict[str, Index] = {}
    indices: Index | None = None
    mode: Index = TRIANGLES
    extensions: dict[str, Any] = {}


class _Mesh(msgspec.Struct):
    primitives: list[_Primitive] = []


class _Node(msgspec.Struct):
    mesh: Index | None = None
    children: list[Index] = []


class _Roots(msgspec.Struct):
    nodes: list[Index] = []


class _Source(msgspec.Struct):
    uri: str | None = None


class _Document(msgspec.Struct, rename="camel"):
    accessors: list[_Accessor] = []
    meshes: list[_Mesh] = []
    nodes: list[_Node] = []
    scenes: list[_Roots] = []
    buffers: list[_Source] = []
    images: list[_Source] = []
    extensions_required: list[str] = []


def check(content: bytes) -> None:
    """Look whether a GLB file can be drawn here.

    Layout (glTF 2.0, section 4): u32 little-endian magic, version 2, length; then chunks of u32 length, u32 kind and
    bytes, the first of them JSON.

    Raises
    ------
    ValueError
        Half a sentence that says what is wrong and what to do.
    """
    if len(content) > MOST_BYTES:
        raise ValueError(f"it is larger than {MOST_BYTES // 1_000_000} MB: make the object simpler")
    document = _document(content)
    for name in document.extensions_required:
        if not name.startswith(READABLE):
            raise ValueError(f"it needs '{name}', which is not read here: export it without compression or extensions")
    for source in (*document.buffers, *document.images):
        if source.uri is not None and not source.uri.startswith("data:"):
            raise ValueError("it needs other files: export everything into one GLB file")
    if any(accessor.count > MOST_NUMBERS for accessor in document.accessors):
        raise ValueError(f"it has lists of more than {MOST_NUMBERS:,} numbers: make the object simpler")
    _check_tree(document)
    try:
        faces = sum(
            _faces(document, primitive)
            for node in document.nodes
            if node.mesh is not None
            for primitive in document.meshes[node.mesh].primitives
        )
    except IndexError as error:
        raise ValueError("it refers to parts that are not in it: export it again") from error
    if faces > MOST_FACES:
        raise ValueError(f"it has {faces:,} faces and at most {MOST_FACES:,} are drawn: make the object simpler")


def _document(content: bytes) -> _Document:
    if content[:4] != MAGIC or len(content) < 20:
        raise ValueError("it is no GLB file: export the object as glTF binary (.glb)")
    version, _, length, kind = struct.unpack_from("<4I", content, 4)
    if version != 2:
        raise ValueError(f"it is glTF version {version}: export it as version 2")
    if kind != JSON_CHUNK or 20 + length > len(content):
        raise ValueError("it is cut off or damaged: export it again")
    try:
        return msgspec.json.decode(content[20 : 20 + length], type=_Document)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError("its description cannot be read: export it again") from error


def _check_tree(document: _Document) -> None:
    """Refuse nodes that hang in several places or in themselves: walking along them would never end."""
    children = [child for node in document.nodes for child in node.children]
    roots = {root for scene in document.scenes for root in scene.nodes}
    if len(document.nodes) > MOST_NODES:
        raise ValueError(f"it has more than {MOST_NODES:,} nodes: join them before exporting")
    if len(set(children)) != len(children) or roots & set(children):
        raise ValueError("its parts do not form a tree: export it again")


def _faces(document: _Document, primitive: _Primitive) -> int:
    if "KHR_draco_mesh_compression" in primitive.extensions:
        raise ValueError("it is compressed with Draco: export it without compression")
    listed = primitive.indices if primitive.indices is not None else primitive.attributes.get("POSITION")
    if listed is None:
        return 0
    count = document.accessors[listed].count
    if primitive.mode == TRIANGLES:
        return count // 3
    return max(count - 2, 0) if primitive.mode in {STRIP, FAN} else 0
