"""Checks of a GLB file and of its pictures' headers before they are unpacked: a foreign file may claim any size."""

import base64
import binascii
import io
from collections.abc import Iterable, Iterator
from typing import Final

from PIL import Image

from app.scene.models.glb_document import (
    BYTES,
    COMPONENTS,
    FAN,
    STRIP,
    TRIANGLES,
    GlbDocument,
    Primitive,
    chunks,
    read_document,
)
from app.scene.models.objects import MOST_BYTES

MOST_FACES: Final = 100_000
MOST_NODES: Final = 10_000
DEEPEST: Final = 100  # levels of nested nodes
MOST_ELEMENTS: Final = 1_000_000  # of one accessor, which may claim any count without holding a byte
MOST_NUMBERS: Final = 10_000_000  # of all accessors
MOST_POINTS: Final = 1_000_000  # of all nodes; a mesh is copied for each node that names it

# Prefixes of extensions that do not change the shape, or that are read.
READABLE: Final = ("KHR_materials_", "KHR_texture_transform", "KHR_mesh_quantization", "KHR_node_visibility")
INSTANCES: Final = "EXT_mesh_gpu_instancing"  # draws one mesh at many places, also where it is not required
COMPRESSED: Final = ("EXT_meshopt_compression", "KHR_meshopt_compression", "KHR_draco_mesh_compression")

FORMATS: Final = ("PNG", "JPEG")  # glTF 2.0, section 3.8: others need an extension
MOST_PIXELS: Final = 16_000_000  # of one picture
MOST_PIXELS_IN_ALL: Final = 64_000_000  # a picture counts for each mention, since the reader unpacks it for each


def check(content: bytes) -> GlbDocument:
    """Check that a GLB file can be read and drawn, and return its document.

    Raises
    ------
    ValueError
        Half a sentence that says what is wrong and what to do.
    """
    if len(content) > MOST_BYTES:
        raise ValueError(f"it is larger than {MOST_BYTES // 1_000_000} MB: make the object simpler")
    document = read_document(content)
    for name in document.extensions_required:
        if not name.startswith(READABLE):
            raise ValueError(f"it needs '{name}', which is not read here: export it without compression or extensions")
    for source in (*document.buffers, *document.images):
        if source.uri is not None and not source.uri.startswith("data:"):
            raise ValueError("it needs other files: export everything into one GLB file")
    if any(INSTANCES in node.extensions for node in document.nodes):
        raise ValueError(f"it needs '{INSTANCES}', which is not read here: export it without instances")
    _check_tree(document)
    try:
        _check_lists(document)
        faces = sum(_faces(document, primitive) for primitive in _drawn(document))
        points = sum(_points(document, primitive) for primitive in _drawn(document))
        check_pictures(_pictures(document, content))
    except IndexError as error:
        raise ValueError("it refers to parts that are not in it: export it again") from error
    if faces > MOST_FACES:
        raise ValueError(f"it has {faces:,} faces and at most {MOST_FACES:,} are drawn: make the object simpler")
    if points > MOST_POINTS:
        raise ValueError(f"it has {points:,} points and at most {MOST_POINTS:,} are read: make the object simpler")
    return document


def _check_tree(document: GlbDocument) -> None:
    """Refuse nodes with several parents or in a cycle: walking along a cycle would never end."""
    children = [child for node in document.nodes for child in node.children]
    roots = {root for scene in document.scenes for root in scene.nodes}
    if len(document.nodes) > MOST_NODES:
        raise ValueError(f"it has more than {MOST_NODES:,} nodes: join them before exporting")
    if len(set(children)) != len(children) or roots & set(children):
        raise ValueError("its parts do not form a tree: export it again")

    below = {number: node.children for number, node in enumerate(document.nodes)}
    level = set(below) - set(children)
    for _ in range(DEEPEST):
        level = {child for number in level for child in below.get(number, ())}
        if not level:
            return
    raise ValueError(f"its parts are nested more than {DEEPEST} deep: export it again")


def _check_lists(document: GlbDocument) -> None:
    """Refuse accessors that do not lie in their view, and views that do not lie in their buffer."""
    if any(accessor.count > MOST_ELEMENTS for accessor in document.accessors):
        raise ValueError(f"it has lists of more than {MOST_ELEMENTS:,} numbers: make the object simpler")
    for view in document.buffer_views:
        if any(name in view.extensions for name in COMPRESSED):
            raise ValueError("it is compressed: export it without compression")
        if view.byte_offset + view.byte_length > document.buffers[view.buffer].byte_length:
            raise ValueError("it is cut off or damaged: export it again")
    numbers = 0
    for accessor in document.accessors:
        width, each = COMPONENTS.get(accessor.type), BYTES.get(accessor.component_type)
        if width is None or each is None:
            raise ValueError("its description cannot be read: export it again")
        numbers += accessor.count * width
        if accessor.buffer_view is not None and accessor.count:
            view = document.buffer_views[accessor.buffer_view]
            step = view.byte_stride or width * each
            if accessor.byte_offset + step * (accessor.count - 1) + width * each > view.byte_length:
                raise ValueError("its lists end beyond its data: export it again")
    if numbers > MOST_NUMBERS:
        raise ValueError(f"its lists have more than {MOST_NUMBERS:,} numbers: make the object simpler")


def _pictures(document: GlbDocument, content: bytes) -> Iterator[bytes | str]:
    """Yield each picture as bytes or as a data URI; a GLB's first buffer is its binary chunk."""
    _, binary = chunks(content)
    for image in document.images:
        if image.uri is not None:
            yield image.uri
        elif image.buffer_view is not None:
            view = document.buffer_views[image.buffer_view]
            if view.buffer == 0:
                yield binary[view.byte_offset : view.byte_offset + view.byte_length]
            else:
                raise ValueError("its pictures lie in another buffer: export it again")


def _drawn(document: GlbDocument) -> Iterator[Primitive]:
    for node in document.nodes:
        if node.mesh is not None:
            yield from document.meshes[node.mesh].primitives


def _points(document: GlbDocument, primitive: Primitive) -> int:
    listed = primitive.attributes.get("POSITION")
    return 0 if listed is None else document.accessors[listed].count


def _faces(document: GlbDocument, primitive: Primitive) -> int:
    if "KHR_draco_mesh_compression" in primitive.extensions:
        raise ValueError("it is compressed with Draco: export it without compression")
    listed = primitive.indices if primitive.indices is not None else primitive.attributes.get("POSITION")
    if listed is None:
        return 0
    count = document.accessors[listed].count
    if primitive.mode == TRIANGLES:
        return count // 3
    return max(count - 2, 0) if primitive.mode in {STRIP, FAN} else 0


def check_pictures(pictures: Iterable[bytes | str]) -> None:
    """Refuse pictures, as bytes or as a data URI, that have too many pixels or are neither PNG nor JPEG.

    Raises
    ------
    ValueError
        Half a sentence that says what is wrong and what to do.
    """
    total = 0
    for picture in pictures:
        width, height = _size(picture if isinstance(picture, bytes) else _decoded(picture))
        total += width * height
        if width * height > MOST_PIXELS:
            raise ValueError(
                f"a picture on it is {width:,} x {height:,} pixels large, and at most {MOST_PIXELS:,} pixels are read: "
                f"make it smaller"
            )
        if total > MOST_PIXELS_IN_ALL:
            raise ValueError(f"its pictures have more than {MOST_PIXELS_IN_ALL:,} pixels in all: use fewer of them")


def _decoded(address: str) -> bytes:
    try:
        return base64.b64decode(address.partition(",")[2], validate=True)
    except binascii.Error as error:
        raise ValueError("a picture on it is damaged: export it again") from error


def _size(content: bytes) -> tuple[int, int]:
    try:
        with Image.open(io.BytesIO(content), formats=FORMATS) as picture:
            return picture.size
    except (Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        raise ValueError(f"a picture on it has more than {MOST_PIXELS:,} pixels: make it smaller") from error
    except Exception as error:
        # Pillow may raise any exception for a damaged picture.
        raise ValueError("a picture on it is neither PNG nor JPEG, or damaged: export it again") from error
