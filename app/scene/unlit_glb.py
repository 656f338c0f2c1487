"""Painted meshes as GLB files: viser draws vertex colours of these only.

Format: glTF 2.0, section 4 (https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html), with the extension
KHR_materials_unlit: the renderer computes no light, which is much faster where software draws.
"""

import struct
from typing import Final

import msgspec
import numpy as np

from app.scene.meshes.paint import PaintedPart

MAGIC: Final = b"glTF"
JSON_CHUNK: Final = b"JSON"
BINARY_CHUNK: Final = b"BIN\0"
BYTE, SHORT, INTEGER, FLOAT = 5121, 5123, 5125, 5126  # types of numbers; the first three without a sign
VERTICES, FACES = 34962, 34963  # what a part of the buffer is for


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
