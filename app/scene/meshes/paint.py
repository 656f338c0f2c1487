"""Meshes with a colour at each vertex, drawn without lights: light and shade of a room are part of the colours.

The renderer's tone mapping is undone, so that a vertex is shown in the colour that was chosen for it. viser's page
draws with three.js and its "ACES filmic" tone mapping, after Stephen Hill's fit:
https://github.com/TheRealMJP/BakingLab/blob/master/BakingLab/ACES.hlsl

viser draws vertex colours of GLB files only: glTF 2.0, section 4
(https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html), with the extension KHR_materials_unlit, by which the
renderer computes no light; that is much faster where software draws.
"""

import math
import struct
from collections.abc import Iterable
from typing import Final, NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from app.scene.lighting import FULL_SKY, FULL_SUN, REFLECTED
from app.scene.meshes.bodies import Mesh, merged
from app.scene.meshes.palette import Colour
from app.world.scenery import Lights

Numbers = NDArray[np.float64]
DEFAULT_LIGHTS: Final = Lights()

EXPOSURE: Final = 1 / 0.6  # as in three.js
INTO: Final = np.array([[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]])
OUT_OF: Final = np.array([[1.60475, -0.53108, -0.07367], [-0.10208, 1.10813, -0.00605], [-0.00327, -0.07276, 1.07602]])
# The curve is (v (v + A) - B) / (v (C v + D) + E).
A, B, C, D, E = 0.0245786, 0.000090537, 0.983729, 0.4329510, 0.238081

MAGIC: Final = b"glTF"
JSON_CHUNK: Final = b"JSON"
BINARY_CHUNK: Final = b"BIN\0"
BYTE, SHORT, INTEGER, FLOAT = 5121, 5123, 5125, 5126  # types of numbers; the first three without a sign
VERTICES, FACES = 34962, 34963  # what a part of the buffer is for


class PaintedPart(NamedTuple):
    """A mesh with the light (n, 3) that each of its vertices sends out, drawn with one call and without lights.

    Light is linear red, green and blue before the renderer's tone mapping, 0 to 1. Colours between two vertices are
    interpolated.
    """

    mesh: Mesh
    light: Numbers


def painted(mesh: Mesh, colour: Colour, lights: Lights, shade: Numbers | float = 1.0) -> PaintedPart:
    """Return a mesh that has the shown `colour` where the default lights fall on it most directly.

    Parameters
    ----------
    mesh
        Its faces share no vertex across an edge that is to look sharp.
    colour
        As on the screen (sRGB), for a horizontal face, and for an upright face towards the default sun.
    lights
        Of the plan; dimmer lights make the mesh darker.
    shade
        Share of the light that reaches each vertex, (n,), or all of them.
    """
    normals = _normals(mesh)
    flat = np.hypot(normals[:, 0], normals[:, 1])
    azimuth = DEFAULT_LIGHTS.azimuth
    towards_sun = np.stack([flat * math.cos(azimuth), flat * math.sin(azimuth), normals[:, 2]], axis=1)
    share = irradiance(normals, lights) / irradiance(towards_sun, DEFAULT_LIGHTS)
    light = light_of(colour) * share * np.broadcast_to(shade, len(normals))[:, np.newaxis]
    return PaintedPart(mesh, np.clip(light, 0.0, 1.0))


def joined(parts: Iterable[PaintedPart]) -> PaintedPart:
    """Return one part of several."""
    all_parts = list(parts)
    light = np.concatenate([part.light for part in all_parts]) if all_parts else np.zeros((0, 3))
    return PaintedPart(merged(part.mesh for part in all_parts), light)


def irradiance(normals: Numbers, lights: Lights) -> Numbers:
    """Return red, green and blue (n, 3) that sun and sky of a plan send to faces with these unit normals (n, 3)."""
    out, up = math.cos(lights.elevation), math.sin(lights.elevation)
    sun = np.array([out * math.cos(lights.azimuth), out * math.sin(lights.azimuth), up])
    direct = np.maximum(normals @ sun, 0.0)[:, np.newaxis] * linear_of(lights.colour)
    upward = (0.5 + 0.5 * normals[:, 2])[:, np.newaxis]
    around = upward + (1.0 - upward) * linear_of(REFLECTED)
    total: Numbers = (FULL_SUN * lights.sun * direct + FULL_SKY * lights.sky * around) / math.pi
    return total


def _normals(mesh: Mesh) -> Numbers:
    """Return the unit normal (n, 3) of each vertex, from the faces that it belongs to."""
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    across = np.cross(b - a, c - a)
    sums = np.zeros_like(mesh.vertices)
    for corner in range(3):
        np.add.at(sums, mesh.faces[:, corner], across)
    lengths = np.linalg.norm(sums, axis=1)[:, np.newaxis]
    normals: Numbers = sums / np.where(lengths > 0, lengths, 1.0)
    return normals


def light_of(colour: Colour) -> Numbers:
    """Return the light (3,) that is shown as an sRGB colour; not over 1, which is shown as about (226, 226, 226)."""
    mapped = np.linalg.solve(OUT_OF, linear_of(colour))
    # The curve solved for v: a quadratic equation with one positive root.
    square, line, rest = 1 - C * mapped, A - D * mapped, -B - E * mapped
    values = (-line + np.sqrt(line * line - 4 * square * rest)) / (2 * square)
    light: Numbers = np.clip(np.linalg.solve(INTO, values) / EXPOSURE, 0.0, 1.0)
    return light


def linear_of(colour: Colour) -> Numbers:
    """Return the linear red, green and blue (3,) of an sRGB colour (IEC 61966-2-1)."""
    share = np.array(colour, dtype=np.float64) / 255
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


def unlit_glb(part: PaintedPart) -> bytes:
    """Return a painted mesh as a GLB file; x, y and z are kept as they are."""
    positions = part.mesh.vertices.astype("<f4")
    opaque = np.full((len(positions), 1), 255, dtype=np.uint8)
    colours = np.hstack([np.round(255 * part.light).astype(np.uint8), opaque])
    is_small = len(positions) <= np.iinfo(np.uint16).max
    faces = part.mesh.faces.ravel().astype("<u2" if is_small else "<u4")
    blocks = [positions.tobytes(), colours.tobytes(), faces.tobytes()]
    starts = np.cumsum([0, *map(len, blocks)]).tolist()
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_materials_unlit"],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"extensions": {"KHR_materials_unlit": {}}}],
        "accessors": [
            {
                **_accessor(0, FLOAT, len(positions), "VEC3"),
                "min": positions.min(axis=0).tolist(),
                "max": positions.max(axis=0).tolist(),
            },
            _accessor(1, BYTE, len(colours), "VEC4") | {"normalized": True},
            _accessor(2, SHORT if is_small else INTEGER, len(faces), "SCALAR"),
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": start, "byteLength": len(block), "target": target}
            for start, block, target in zip(starts[:-1], blocks, (VERTICES, VERTICES, FACES), strict=True)
        ],
        "buffers": [{"byteLength": starts[-1]}],
    }
    chunks = _chunk(JSON_CHUNK, msgspec.json.encode(document), b" ") + _chunk(BINARY_CHUNK, b"".join(blocks), b"\0")
    return MAGIC + struct.pack("<2I", 2, 12 + len(chunks)) + chunks


def _accessor(view: int, numbers: int, count: int, kind: str) -> dict[str, object]:
    return {"bufferView": view, "componentType": numbers, "count": count, "type": kind}


def _chunk(kind: bytes, content: bytes, fill: bytes) -> bytes:
    """Return a chunk: u32 length, kind, content filled up to a multiple of four bytes."""
    content += fill * (-len(content) % 4)
    return struct.pack("<I", len(content)) + kind + content
