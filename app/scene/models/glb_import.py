"""Reading of a GLB file into a few coloured meshes that stand on the floor, x ahead, in metres.

`app.isolated_reader` calls this module in a process of its own.
"""

import io
import json
from pathlib import Path
from typing import Any, Final, TypedDict

import numpy as np
import trimesh
from numpy.typing import NDArray

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, Part, merged
from app.scene.meshes.palette import Colour
from app.scene.models.glb_check import MOST_FACES, check
from app.scene.models.glb_document import GlbDocument, chunks, packed
from app.scene.models.glb_geometry import UnreadableError, plain_glb
from app.scene.models.object_scale import is_probable, scaled
from app.scene.models.objects import AS_IT_SAYS, MOST_BYTES, THINNEST, Model, reading_of, write_reading

MOST_COLOURS: Final = 12  # each needs a draw call
COARSE: Final = 5  # of the 8 bits of a colour; colours that differ only in these lower bits are joined


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
        raise ValueError(f"{file.name}: the size of this object cannot be changed for certain, export it in metres")
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
        raise ValueError(f"{file.name}: this file cannot be read ({error.strerror or error}), check it") from error
    try:
        return _model(check(content), content)
    except ValueError as error:
        raise ValueError(f"{file.name}: this object cannot be used, {error}") from error


def _model(document: GlbDocument, content: bytes) -> Model:
    with np.errstate(all="ignore"):  # places that are no numbers are refused below
        try:
            plain, corners = plain_glb(document, content)
        except IndexError as error:
            raise ValueError("it refers to parts that are not in it: export it again") from error
        except UnreadableError:
            raise
        except Exception as error:
            # The lists of a damaged file do not fit together: NumPy may raise any exception.
            raise ValueError("it is damaged: export it again") from error
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
        raise ValueError("it needs too much memory: make the object simpler") from error
    except Exception as error:
        # trimesh's reader may raise any exception for a damaged file.
        raise ValueError("it is damaged: export it again") from error
    all_parts = merged(mesh for meshes in by_colour.values() for mesh in meshes)
    if not len(all_parts.faces):
        raise ValueError("there is nothing with faces in it: export a solid object")
    if len(all_parts.faces) > MOST_FACES:
        raise ValueError(f"it has {len(all_parts.faces):,} faces and at most {MOST_FACES:,} are drawn: make it simpler")
    if not np.isfinite(all_parts.vertices).all() or np.abs(all_parts.vertices).max() > 1e6:
        raise ValueError("some of its points are infinite or too far away: export it again")
    low, high = all_parts.vertices.min(axis=0), all_parts.vertices.max(axis=0)
    if not np.allclose([low, high], [corners.min(axis=0)[[2, 0, 1]], corners.max(axis=0)[[2, 0, 1]]], rtol=1e-4):
        raise ValueError("its size cannot be read for certain: export it again without animation and compression")
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
