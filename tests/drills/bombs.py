"""Files that ask for far more memory or time than their size lets expect, for tests and drills.

Each is a request: the address, the name of the form's field, and the files to send.
"""

import io
import json
import struct
import zlib
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import pyarrow as pa
import pyarrow.parquet as pa_parquet

GLB_JSON, GLB_BINARY = 0x4E4F534A, 0x004E4942
FLOAT, VEC3 = 5126, "VEC3"


class Bomb(NamedTuple):
    """One request and what is in it."""

    address: str
    files: list[tuple[str, tuple[str, bytes]]]
    form: dict[str, str]


@cache
def png(side: int, depth: int = 8, colour: int = 2) -> bytes:
    """Return a black PNG of side x side pixels, compressed about a thousand times."""
    bits = {0: 1, 2: 3, 6: 4}[colour] * depth
    row = bytes(1 + (side * bits + 7) // 8)
    packer = zlib.compressobj(9)
    block, count = row * 64, side // 64
    data = b"".join(packer.compress(block) for _ in range(count)) + packer.compress(row * (side % 64)) + packer.flush()
    header = struct.pack(">2I5B", side, side, depth, colour, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", data), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body)) for name, body in chunks
    )


def jpeg(side: int) -> bytes:
    """Return a JPEG whose header claims side x side pixels."""
    from PIL import Image

    stream = io.BytesIO()
    Image.new("L", (8, 8)).save(stream, "JPEG")
    content = bytearray(stream.getvalue())
    at = content.index(b"\xff\xc0") + 5
    content[at : at + 4] = struct.pack(">2H", side, side)
    return bytes(content)


def picture(kind: str, side: int, **more: Any) -> bytes:
    """Return a picture of another format, in black and white."""
    from PIL import Image

    stream = io.BytesIO()
    Image.new("1", (side, side)).save(stream, kind, **more)
    return stream.getvalue()


def gif(frames: int) -> bytes:
    """Return a GIF of many large frames."""
    head = b"GIF89a" + struct.pack("<2H3B", 65_000, 65_000, 0x80, 0, 0) + b"\0\0\0\xff\xff\xff"
    frame = b"\x2c" + struct.pack("<4HB", 0, 0, 65_000, 65_000, 0) + b"\x02\x02\x4c\x01\x00"
    return head + frame * frames + b";"


def glb(document: dict[str, Any], body: bytes = b"") -> bytes:
    """Return a GLB file of a description and its binary chunk."""
    words = json.dumps({"asset": {"version": "2.0"}} | document).encode()
    words += b" " * (-len(words) % 4)
    body += bytes(-len(body) % 4)
    chunks = struct.pack("<2I", len(words), GLB_JSON) + words
    if body:
        chunks += struct.pack("<2I", len(body), GLB_BINARY) + body
    return b"glTF" + struct.pack("<2I", 2, 12 + len(chunks)) + chunks


def triangle(**more: Any) -> tuple[dict[str, Any], bytes]:
    """Return the description of one triangle, changed by `more`, and its binary chunk."""
    points = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    corners = struct.pack("<6f", 0, 0, 1, 0, 0, 1)
    document = {
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {}}],
        "buffers": [{"byteLength": len(points + corners)}],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(points)},
            {"buffer": 0, "byteOffset": len(points), "byteLength": len(corners)},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": FLOAT, "count": 3, "type": VEC3, "min": [0, 0, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": FLOAT, "count": 3, "type": "VEC2"},
        ],
    } | more
    return document, points + corners


def glb_with_pictures(content: bytes, times: int = 1) -> bytes:
    """Return a triangle with a picture on it that the file names so many times."""
    document, body = triangle()
    document["buffers"] = [{"byteLength": len(body) + len(content)}]
    document["bufferViews"].append({"buffer": 0, "byteOffset": len(body), "byteLength": len(content)})
    document["images"] = [{"bufferView": 2, "mimeType": "image/png"}] * times
    document["textures"] = [{"source": i} for i in range(times)]
    document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": i}}} for i in range(times)]
    (mesh,) = document["meshes"]
    mesh["primitives"] = [mesh["primitives"][0] | {"material": i} for i in range(times)]
    return glb(document, body + content)


def _model(content: bytes) -> Bomb:
    return Bomb("/models", [("file", ("thing.glb", content))], {})


def _plan(*files: tuple[str, bytes], **options: Any) -> Bomb:
    return Bomb("/floorplans/import", [("files", file) for file in files], {"options": json.dumps(options)})


def _map(image: bytes, suffix: str = "pgm") -> Bomb:
    words = f"image: hall.{suffix}\nresolution: 0.05\norigin: [0, 0, 0]\n".encode()
    return _plan(("hall.yaml", words), (f"hall.{suffix}", image))


def _claimed_vertices() -> Bomb:
    document, body = triangle()
    document["accessors"][0]["count"] = 4_000_000_000
    return _model(glb(document, body))


def _beyond_the_buffer() -> Bomb:
    document, body = triangle()
    document["accessors"][0]["count"] = 900_000
    document["meshes"][0]["primitives"][0]["indices"] = 1
    return _model(glb(document, body))


def _lists_of_nothing() -> Bomb:
    """Accessors without a buffer view are zeros: no byte in the file, 64 bytes each in memory."""
    document, body = triangle()
    document["accessors"] += [{"componentType": FLOAT, "count": 1_000_000, "type": "MAT4"}] * 200
    return _model(glb(document, body))


def _copies() -> Bomb:
    document, body = triangle()
    document["accessors"].append({"componentType": FLOAT, "count": 1_000_000, "type": VEC3})
    document["accessors"].append({"componentType": 5125, "count": 3, "type": "SCALAR"})
    document["meshes"] = [{"primitives": [{"attributes": {"POSITION": 2}, "indices": 3}]}]
    document["nodes"] = [{"mesh": 0} for _ in range(9000)]
    document["scenes"] = [{"nodes": list(range(9000))}]
    return _model(glb(document, body))


def _deep() -> Bomb:
    nodes: list[dict[str, Any]] = [{"children": [i + 1], "translation": [0, 1, 0]} for i in range(9_000)]
    document, body = triangle(nodes=[*nodes, {"mesh": 0}])
    return _model(glb(document, body))


def _cycle() -> Bomb:
    document, body = triangle(nodes=[{"mesh": 0, "children": [1]}, {"children": [0]}])
    return _model(glb(document, body))


def _meshopt() -> Bomb:
    document, body = triangle(extensionsUsed=["EXT_meshopt_compression"])
    claim = {"buffer": 0, "byteLength": 4, "byteStride": 252, "count": 2**31, "mode": "ATTRIBUTES"}
    document["bufferViews"][0]["extensions"] = {"EXT_meshopt_compression": claim}
    return _model(glb(document, body))


def _laughs() -> Bomb:
    lines = ["a: &a [x, x, x, x, x, x, x, x, x, x]"]
    for before, name in zip("abcdefgh", "bcdefghi", strict=True):
        lines.append(f"{name}: &{name} [{', '.join([f'*{before}'] * 10)}]")
    lines += ["image: *i", "resolution: 0.05", "origin: [0, 0, 0]"]
    return _plan(("hall.yaml", "\n".join(lines).encode()), ("hall.pgm", b"P5 2 2 255\n0000"))


def _blocks() -> Bomb:
    """Ten blocks in each other, each placed ten times: ten thousand million lines."""
    import ezdxf.filemanagement

    drawing = ezdxf.filemanagement.new()
    drawing.header["$INSUNITS"] = 6
    block = drawing.blocks.new("B0")
    block.add_line((0, 0), (1, 1))
    for level in range(1, 11):
        block = drawing.blocks.new(f"B{level}")
        for place in range(10):
            block.add_blockref(f"B{level - 1}", (place, 0))
    drawing.modelspace().add_blockref("B10", (0, 0))
    text = io.StringIO()
    drawing.write(text)
    return _plan(("hall.dxf", text.getvalue().encode()))


def _rows() -> Bomb:
    """Parquet packs equal values: a hundred million rows in some kilobytes."""
    stream = io.BytesIO()
    zeros = pa.array([0.0]).take(pa.array([0] * 1_000_000))
    table = pa.table({"t": zeros, "a": zeros})
    with pa_parquet.ParquetWriter(stream, table.schema, compression="zstd") as writer:
        for _ in range(100):
            writer.write_table(table)
    return Bomb("/equipment/files", [("file", ("walk.parquet", stream.getvalue()))], {})


BOMBS: dict[str, Callable[[], Bomb]] = {
    "a picture of 13,000 x 13,000 in a GLB": lambda: _model(glb_with_pictures(png(13_000))),
    "a GLB that names one picture 300 times": lambda: _model(glb_with_pictures(png(3_900), 300)),
    "a GLB that claims 4,000 million points": _claimed_vertices,
    "a GLB whose list ends beyond its buffer": _beyond_the_buffer,
    "a GLB with 200 lists of zeros": _lists_of_nothing,
    "a GLB with 9,000 copies of a million points": _copies,
    "a GLB of 9,000 nodes in each other": _deep,
    "a GLB whose nodes go in a circle": _cycle,
    "a GLB with meshopt compression": _meshopt,
    "a PNG of 30,000 x 30,000": lambda: _plan(("hall.png", png(30_000, 1, 0)), width=20.0),
    "a JPEG that claims 65,000 x 65,000": lambda: _plan(("hall.jpg", jpeg(65_000)), width=20.0),
    "a GIF of 50,000 frames, named PNG": lambda: _map(gif(50_000), "png"),
    "a TIFF of 30,000 x 30,000, named PNG": lambda: _map(picture("TIFF", 30_000, compression="group4"), "png"),
    "a map of 1,000 million cells": lambda: _map(b"P5 32000 32000 255\n" + bytes(1000)),
    "a YAML document of 1,000 million words": _laughs,
    "a DXF of 10,000 million lines": _blocks,
    "a Parquet file of 100 million rows": _rows,
}
