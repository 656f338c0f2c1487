"""Reads the lines of a DXF drawing's model space by layer, with blocks resolved and curves approximated by chords."""

import math
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, Final, NamedTuple

import ezdxf.path
import ezdxf.recover
from ezdxf.math import Matrix44

from app.world.imports.wall_pieces import Point

MOST_BYTES: Final = 20_000_000
MOST_ENTITIES: Final = 200_000  # visited; those in a block count each time the block is placed
MOST_POINTS: Final = 400_000
DEEPEST: Final = 16  # levels of blocks in blocks
SAGITTA: Final = 0.01  # m, largest distance of a chord from its curve
SMALLEST_ARC: Final = 4  # curves that a full circle is divided into before the chords are made
FARTHEST: Final = 1e7  # m; coordinates beyond are errors of the drawing and would make too many chords

UNITS: Final = {"mm": 0.001, "cm": 0.01, "m": 1.0, "inch": 0.0254, "foot": 0.3048}  # m
HEADER_UNITS: Final = {1: "inch", 2: "foot", 4: "mm", 5: "cm", 6: "m"}  # $INSUNITS, DXF reference, HEADER section
LINES: Final = frozenset({"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE"})
WORDS: Final = frozenset({"TEXT", "MTEXT", "DIMENSION", "ATTDEF", "ATTRIB", "LEADER", "MULTILEADER", "VIEWPORT"})


class Drawing(NamedTuple):
    """The lines of a drawing."""

    layers: dict[str, list[list[Point]]]  # layer -> lines, m
    left_out: Counter[str]  # kind of entity -> how many were not read


def read_dxf(file: Path, unit: str | None = None) -> Drawing:
    """Read the lines of a DXF file; `unit` (a key of UNITS) overrides the unit in the drawing.

    Layers that are off or frozen are left out, as in drawing programs; z coordinates are dropped.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    if unit is not None and unit not in UNITS:
        raise ValueError(f"the unit '{unit}' is not known: use one of {', '.join(UNITS)}")
    document = _document(file)
    try:
        return _Reader(file, document, _scale(file, document, unit)).read()
    except ValueError as error:
        if str(error).startswith(f"{file}: "):
            raise
        raise ValueError(f"{file}: something in this drawing is damaged, save it again as DXF") from error
    except Exception as error:
        # ezdxf checks little of a drawing's content and may raise any exception.
        raise ValueError(f"{file}: something in this drawing is damaged, save it again as DXF") from error


def _document(file: Path) -> Any:
    try:
        with file.open("rb") as opened:
            content = opened.read(MOST_BYTES + 1)
    except FileNotFoundError as error:
        raise ValueError(f"{file}: there is no such file, check its name") from error
    except OSError as error:
        raise ValueError(f"{file}: this file cannot be read ({error.strerror or error}), check it") from error
    if len(content) > MOST_BYTES:
        raise ValueError(f"{file}: this is larger than {MOST_BYTES // 1_000_000} MB, draw only what stands there")
    if content[:2] == b"AC":
        raise ValueError(f"{file}: this is a DWG drawing, save it as DXF")
    if b"SECTION" not in content:
        raise ValueError(f"{file}: this is no DXF drawing that can be read, save it again as DXF")
    try:
        document, _ = ezdxf.recover.readfile(file)
    except Exception as error:
        raise ValueError(f"{file}: this is no DXF drawing that can be read, save it again as DXF") from error
    return document


def _scale(file: Path, document: Any, unit: str | None) -> float:
    """Return the length of one unit of the drawing, m."""
    name = unit or HEADER_UNITS.get(document.header.get("$INSUNITS", 0))
    if name is None:
        raise ValueError(
            f"{file}: this drawing does not say in which unit it is drawn, give its unit ({', '.join(UNITS)})"
        )
    return UNITS[name]


class _Reader:
    """Visits the entities of a drawing and counts them, so that nested blocks cannot take unlimited time."""

    def __init__(self, file: Path, document: Any, scale: float) -> None:
        self._file = file
        self._document = document
        self._scale = scale
        self._seen = self._points = 0
        self._layers: defaultdict[str, list[list[Point]]] = defaultdict(list)
        self._left_out: Counter[str] = Counter()
        self._hidden = {layer.dxf.name.lower() for layer in document.layers if layer.is_off() or layer.is_frozen()}

    def read(self) -> Drawing:
        self._walk(self._document.modelspace(), Matrix44.scale(self._scale), None, 0)
        return Drawing(dict(self._layers), self._left_out)

    def _walk(self, entities: Iterable[Any], matrix: Matrix44, inherited: str | None, depth: int) -> None:
        """Read entities in a block's coordinates; layer 0 of a block means the layer that the block is placed on."""
        for entity in entities:
            self._seen += 1
            if self._seen > MOST_ENTITIES:
                raise ValueError(
                    f"{self._file}: this has more than {MOST_ENTITIES:,} things in it, draw only the walls"
                )
            layer = str(entity.dxf.layer)
            layer = inherited if inherited is not None and layer == "0" else layer
            kind = entity.dxftype()
            if layer.lower() in self._hidden or kind in WORDS:
                continue
            if kind == "INSERT":
                self._read_block(entity, matrix, layer, depth)
            elif kind in LINES:
                self._read_line(entity, matrix, layer)
            else:
                self._left_out[kind] += 1

    def _read_block(self, insert: Any, matrix: Matrix44, layer: str, depth: int) -> None:
        block = insert.block()
        if block is None or block.is_any_layout:
            self._left_out["INSERT"] += 1
            return
        if depth >= DEEPEST:
            raise ValueError(f"{self._file}: its blocks lie in each other more than {DEEPEST} deep, explode them")
        for place in self._places(insert):
            self._seen += 1
            self._walk(block, place * matrix, layer, depth + 1)

    def _places(self, insert: Any) -> Iterator[Matrix44]:
        """Yield the transformation of each placement of a block: one, or rows and columns of them."""
        dxf, here = insert.dxf, insert.matrix44()
        rows, columns = max(1, dxf.row_count), max(1, dxf.column_count)
        if rows * columns > MOST_ENTITIES:
            raise ValueError(f"{self._file}: a block stands there {rows * columns:,} times, draw only the walls")
        angle = math.radians(dxf.rotation)
        cos, sin = math.cos(angle), math.sin(angle)
        for row in range(rows):
            for column in range(columns):
                x, y = column * dxf.column_spacing, row * dxf.row_spacing
                yield here * Matrix44.translate(x * cos - y * sin, x * sin + y * cos, 0)

    def _read_line(self, entity: Any, matrix: Matrix44, layer: str) -> None:
        try:
            path = ezdxf.path.make_path(entity, segments=SMALLEST_ARC)
        except TypeError:  # a POLYLINE may also be a mesh
            self._left_out[entity.dxftype()] += 1
            return
        path = path.transform(matrix)
        if not len(path):
            return
        if any(not _is_near(vertex) for vertex in path.control_vertices()):
            raise ValueError(f"{self._file}: something on layer '{layer[:40]}' lies very far away, remove it")
        line = [(point.x, point.y) for point in path.flattening(SAGITTA, segments=1)]
        self._points += len(line)
        if self._points > MOST_POINTS:
            raise ValueError(f"{self._file}: this has more than {MOST_POINTS:,} lines in it, draw only the walls")
        self._layers[layer].append(line)


def _is_near(vertex: Any) -> bool:
    return all(math.isfinite(value) and abs(value) <= FARTHEST for value in (vertex.x, vertex.y, vertex.z))
