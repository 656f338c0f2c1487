"""Reading of a GLB file into a few coloured meshes that stand on the floor, x ahead, in metres.

The file and its pictures' headers are checked before they are unpacked: a foreign file may claim any size.
`app.isolated_reader` calls this module in a process of its own.
"""

import base64
import binascii
import io
import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, Final, TypedDict

import numpy as np
import trimesh
from numpy.typing import NDArray
from PIL import Image

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, Part, merged
from app.scene.meshes.palette import Colour
from app.scene.models.glb_document import (
    BYTES,
    COMPONENTS,
    FAN,
    STRIP,
    TRIANGLES,
    GlbDocument,
    Primitive,
    chunks,
    packed,
    read_document,
)
from app.scene.models.glb_geometry import UnreadableError, plain_glb
from app.scene.models.object_scale import is_probable, scaled
from app.scene.models.objects import AS_IT_SAYS, MOST_BYTES, THINNEST, Model, reading_of, write_reading
from app.texts import Text

MOST_COLOURS: Final = 12  # each needs a draw call
COARSE: Final = 5  # of the 8 bits of a colour; colours that differ only in these lower bits are joined
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


class ObjectQuestion(TypedDict):
    """The file of an object, the folder of the readings, and how long one unit of the file is, m; None: not known."""

    file: str
    readings: str
    metres_per_unit: float | None


def answer(question: ObjectQuestion) -> dict[str, object]:
    """Read the object in the file `question["file"]`, write its meshes into `question["readings"]`, return its size.

    One unit of the file is `question["metres_per_unit"]` long: the file is rewritten in metres when that is not 1.
    When it is null, the meshes of an object of an improbable size are not written.

    Raises
    ------
    ValueError
        One sentence: the file, what is wrong, what to do.
    """
    file, scale = Path(question["file"]), question["metres_per_unit"]
    model = read_model(file) if scale in {None, AS_IT_SAYS} else _in_metres(file, scale)
    if scale is not None or is_probable(model.size):
        write_reading(model, reading_of(file, Path(question["readings"])))
    return {"size": model.size}


def _in_metres(file: Path, scale: float) -> Model:
    """Rewrite an object `scale` times as large, and read it."""
    size = scaled(read_model(file).size, scale)
    file.write_bytes(scaled_glb(file.read_bytes(), scale))
    model = read_model(file)
    if not np.allclose(model.size, size, rtol=1e-4, atol=THINNEST * max(1.0, scale)):
        raise ValueError(Text("object-not-scaled", file=file.name))
    return model


def scaled_glb(content: bytes, scale: float) -> bytes:
    """Return a GLB file that is valid, `scale` times as large; only its default scene is kept."""
    description, body = chunks(content)
    document = json.loads(description)
    nodes = document.get("nodes", [])
    below = {child for node in nodes for child in node.get("children", [])}
    scenes = document.get("scenes") or [{"nodes": [number for number in range(len(nodes)) if number not in below]}]
    scene = scenes[document.get("scene") or 0]
    root = {"name": "in metres", "children": scene.get("nodes", []), "scale": [scale] * 3}
    changed = {"nodes": [*nodes, root], "scenes": [scene | {"nodes": [len(nodes)]}], "scene": 0}
    return packed(document | changed, body)


def read_model(file: Path) -> Model:
    """Read an object from a GLB file (glTF 2.0, binary): at most 20 MB and 100,000 faces, everything in one file.

    A face with a texture gets the texture's mean colour at its corners.

    Raises
    ------
    ValueError
        One sentence: the file, what is wrong, what to do.
    """
    try:
        with file.open("rb") as opened:
            content = opened.read(MOST_BYTES + 1)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(Text("object-file-unreadable", file=file.name, reason=reason)) from error
    try:
        return _model(check(content), content)
    except ValueError as error:
        raise ValueError(Text("object-unusable", file=file.name, problem=error)) from error


def _model(document: GlbDocument, content: bytes) -> Model:
    with np.errstate(all="ignore"):  # places that are no numbers are refused below
        try:
            plain, corners = plain_glb(document, content)
        except IndexError as error:
            raise ValueError(Text("object-parts-missing")) from error
        except UnreadableError:
            raise
        except Exception as error:
            # The lists of a damaged file do not fit together: NumPy may raise any exception.
            raise ValueError(Text("object-damaged")) from error
    by_colour: dict[Colour, list[Mesh]] = {}
    try:
        loaded = trimesh.load_scene(io.BytesIO(plain), file_type="glb", process=False)
        bodies = [body for body in loaded.dump() if isinstance(body, trimesh.Trimesh) and len(body.faces)]
        for body in bodies:
            # glTF looks along z with y up; a chair looks along x with z up.
            mesh = Mesh(np.asarray(body.vertices, dtype=np.float64)[:, [2, 0, 1]], np.asarray(body.faces))
            for colour, faces in _by_colour(_face_colours(body)):
                by_colour.setdefault(colour, []).append(_only(mesh, faces))
    except MemoryError as error:
        raise ValueError(Text("object-memory")) from error
    except Exception as error:
        # trimesh's reader may raise any exception for a damaged file.
        raise ValueError(Text("object-damaged")) from error
    all_parts = merged(mesh for meshes in by_colour.values() for mesh in meshes)
    if not len(all_parts.faces):
        raise ValueError(Text("object-without-faces"))
    if len(all_parts.faces) > MOST_FACES:
        raise ValueError(Text("object-faces", count=len(all_parts.faces), most=MOST_FACES))
    if not np.isfinite(all_parts.vertices).all() or np.abs(all_parts.vertices).max() > 1e6:
        raise ValueError(Text("object-far"))
    low, high = all_parts.vertices.min(axis=0), all_parts.vertices.max(axis=0)
    if not np.allclose([low, high], [corners.min(axis=0)[[2, 0, 1]], corners.max(axis=0)[[2, 0, 1]]], rtol=1e-4):
        raise ValueError(Text("object-size-unknown"))
    middle = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
    length, width, height = (max(float(side), THINNEST) for side in high - low)
    parts = [Part(merged(meshes), colour) for colour, meshes in sorted(by_colour.items())]
    placed = [Part(Mesh(mesh.vertices - middle, mesh.faces), colour) for mesh, colour in _few(parts)]
    return Model(tuple(placed), (length, width, height))


def _face_colours(body: trimesh.Trimesh) -> NDArray[np.float64]:
    """Return the colour of each face, (n, 3) from 0 to 255."""
    visual: Any = body.visual
    if visual.kind != "texture":
        colours = visual.face_colors if visual.defined else np.tile(palette.LINEN, (len(body.faces), 1))
        return np.asarray(colours, dtype=np.float64)[:, :3]
    material = visual.material
    factor = getattr(material, "baseColorFactor", None)
    plain = np.full(3, 255.0) if factor is None else np.asarray(factor, dtype=np.float64)[:3]
    picture = getattr(material, "baseColorTexture", None)
    if picture is None or visual.uv is None:
        return np.tile(plain, (len(body.faces), 1))
    corner_colours = np.asarray(trimesh.visual.color.uv_to_color(visual.uv, picture), dtype=np.float64)[:, :3]
    mean: NDArray[np.float64] = corner_colours[body.faces].mean(axis=1) * plain / 255.0
    return mean


def _by_colour(colours: NDArray[np.float64]) -> list[tuple[Colour, NDArray[np.intp]]]:
    """Return the faces of each group of similar colours, with the group's mean colour."""
    kinds, group = np.unique(colours.astype(np.uint8) >> COARSE, axis=0, return_inverse=True)
    groups = [np.flatnonzero(group.ravel() == number) for number in range(len(kinds))]
    return [(_colour(colours[faces].mean(axis=0)), faces) for faces in groups]


def _few(parts: list[Part]) -> list[Part]:
    """Return at most twelve parts; each smaller part joins the large part with the nearest colour."""
    ordered = sorted(parts, key=lambda part: -len(part.mesh.faces))
    groups = [[part] for part in ordered[:MOST_COLOURS]]
    for part in ordered[MOST_COLOURS:]:
        nearest = min(
            groups, key=lambda group: sum((a - b) ** 2 for a, b in zip(group[0].colour, part.colour, strict=True))
        )
        nearest.append(part)
    return [Part(merged(part.mesh for part in group), group[0].colour) for group in groups]


def _only(mesh: Mesh, faces: NDArray[np.intp]) -> Mesh:
    """Return the mesh of some faces, with the vertices that they use."""
    used, numbers = np.unique(mesh.faces[faces], return_inverse=True)
    return Mesh(mesh.vertices[used], numbers.reshape(-1, 3).astype(np.int64))


def _colour(mean: NDArray[np.float64]) -> Colour:
    red, green, blue = (round(float(value)) for value in mean)
    return red, green, blue


def check(content: bytes) -> GlbDocument:
    """Check that a GLB file can be read and drawn, and return its document.

    Raises
    ------
    ValueError
        Half a sentence that says what is wrong and what to do.
    """
    if len(content) > MOST_BYTES:
        raise ValueError(Text("object-large", most=MOST_BYTES // 1_000_000))
    document = read_document(content)
    for name in document.extensions_required:
        if not name.startswith(READABLE):
            raise ValueError(Text("object-extension", name=name))
    for source in (*document.buffers, *document.images):
        if source.uri is not None and not source.uri.startswith("data:"):
            raise ValueError(Text("object-other-files"))
    if any(INSTANCES in node.extensions for node in document.nodes):
        raise ValueError(Text("object-instances", name=INSTANCES))
    _check_tree(document)
    try:
        _check_lists(document)
        faces = sum(_faces(document, primitive) for primitive in _drawn(document))
        points = sum(_points(document, primitive) for primitive in _drawn(document))
        _check_pictures(_pictures(document, content))
    except IndexError as error:
        raise ValueError(Text("object-parts-missing")) from error
    if faces > MOST_FACES:
        raise ValueError(Text("object-faces", count=faces, most=MOST_FACES))
    if points > MOST_POINTS:
        raise ValueError(Text("object-points", count=points, most=MOST_POINTS))
    return document


def _check_tree(document: GlbDocument) -> None:
    """Refuse nodes with several parents or in a cycle: walking along a cycle would never end."""
    children = [child for node in document.nodes for child in node.children]
    roots = {root for scene in document.scenes for root in scene.nodes}
    if len(document.nodes) > MOST_NODES:
        raise ValueError(Text("object-nodes", most=MOST_NODES))
    if len(set(children)) != len(children) or roots & set(children):
        raise ValueError(Text("object-no-tree"))

    below = {number: node.children for number, node in enumerate(document.nodes)}
    level = set(below) - set(children)
    for _ in range(DEEPEST):
        level = {child for number in level for child in below.get(number, ())}
        if not level:
            return
    raise ValueError(Text("object-nested", most=DEEPEST))


def _check_lists(document: GlbDocument) -> None:
    """Refuse accessors that do not lie in their view, and views that do not lie in their buffer."""
    if any(accessor.count > MOST_ELEMENTS for accessor in document.accessors):
        raise ValueError(Text("object-long-list", most=MOST_ELEMENTS))
    for view in document.buffer_views:
        if any(name in view.extensions for name in COMPRESSED):
            raise ValueError(Text("object-compressed"))
        if view.byte_offset + view.byte_length > document.buffers[view.buffer].byte_length:
            raise ValueError(Text("object-cut-off"))
    numbers = 0
    for accessor in document.accessors:
        width, each = COMPONENTS.get(accessor.type), BYTES.get(accessor.component_type)
        if width is None or each is None:
            raise ValueError(Text("object-no-description"))
        numbers += accessor.count * width
        if accessor.buffer_view is not None and accessor.count:
            view = document.buffer_views[accessor.buffer_view]
            step = view.byte_stride or width * each
            if accessor.byte_offset + step * (accessor.count - 1) + width * each > view.byte_length:
                raise ValueError(Text("object-lists-end"))
    if numbers > MOST_NUMBERS:
        raise ValueError(Text("object-numbers", most=MOST_NUMBERS))


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
                raise ValueError(Text("object-picture-elsewhere"))


def _drawn(document: GlbDocument) -> Iterator[Primitive]:
    for node in document.nodes:
        if node.mesh is not None:
            yield from document.meshes[node.mesh].primitives


def _points(document: GlbDocument, primitive: Primitive) -> int:
    listed = primitive.attributes.get("POSITION")
    return 0 if listed is None else document.accessors[listed].count


def _faces(document: GlbDocument, primitive: Primitive) -> int:
    if "KHR_draco_mesh_compression" in primitive.extensions:
        raise ValueError(Text("object-draco"))
    listed = primitive.indices if primitive.indices is not None else primitive.attributes.get("POSITION")
    if listed is None:
        return 0
    count = document.accessors[listed].count
    if primitive.mode == TRIANGLES:
        return count // 3
    return max(count - 2, 0) if primitive.mode in {STRIP, FAN} else 0


def _check_pictures(pictures: Iterable[bytes | str]) -> None:
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
            raise ValueError(Text("object-picture-size", width=width, height=height, most=MOST_PIXELS))
        if total > MOST_PIXELS_IN_ALL:
            raise ValueError(Text("object-pictures-in-all", most=MOST_PIXELS_IN_ALL))


def _decoded(address: str) -> bytes:
    try:
        return base64.b64decode(address.partition(",")[2], validate=True)
    except binascii.Error as error:
        raise ValueError(Text("object-picture-damaged")) from error


def _size(content: bytes) -> tuple[int, int]:
    try:
        with Image.open(io.BytesIO(content), formats=FORMATS) as picture:
            return picture.size
    except (Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        raise ValueError(Text("object-picture-pixels", most=MOST_PIXELS)) from error
    except Exception as error:
        # Pillow may raise any exception for a damaged picture.
        raise ValueError(Text("object-picture-unreadable")) from error
