"""The straight lines of a DXF drawing's model space, by layer, blocks taken apart and curves as chords."""

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
MOST_ENTITIES: Final = 200_000  # looked at, those in blocks each time the block is placed
MOST_POINTS: Final = 400_000
DEEPEST: Final = 16  # blocks in blocks
SAGITTA: Final = 0.01  # m that a chord may lie beside its curve
SMALLEST_ARC: Final = 4  # curves that a full circle is made of before it becomes chords
FARTHEST: Final = 1e7  # m; a place beyond this is a mistake, and makes too many chords

UNITS: Final = {"mm": 0.001, "cm": 0.01, "m": 1.0, "inch": 0.0254, "foot": 0.3048}  # m
HEADER_UNITS: Final = {1: "inch", 2: "foot", 4: "mm", 5: "cm", 6: "m"}  # $INSUNITS, DXF reference, HEADER section
LINES: Final = frozenset({"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE"})
WORDS: Final = frozenset({"TEXT", "MTEXT", "DIMENSION", "ATTDEF", "ATTRIB", "LEADER", "MULTILEADER", "VIEWPORT"})


class Drawing(NamedTuple):
    """What was read: lines in m by layer, and how many things of which kind could not be."""

    layers: dict[str, list[list[Point]]]
    left_out: Counter[str]


def read_dxf(file: Path, unit: str | None = None) -> Drawing:
    """Read the lines of a DXF file; `unit` (a key of UNITS) is used instead of what the drawing says.

    Layers that are off or frozen are left out, as the drawing program does. Heights are left out.

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
        # The reader checks little of what a drawing says, and raises whatever comes.
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
    """Return how many metres one unit of the drawing is."""
    said = document.header.get("$INSUNITS", 0)
    found = unit or HEADER_UNITS.get(said)
    if found is None:
        raise ValueError(
            f"{file}: this drawing does not say in which unit it is drawn, give its unit ({', '.join(UNITS)})"
        )
    return UNITS[found]


class _Reader:
    """Walks through the drawing, counting, so that blocks in blocks cannot take for ever."""

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
        """Take in entities that lie in a block's coordinates; what is on layer 0 of a block is on the block's layer."""
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
                self._take_block(entity, matrix, layer, depth)
            elif kind in LINES:
                self._take_line(entity, matrix, layer)
            else:
                self._left_out[kind] += 1

    def _take_block(self, insert: Any, matrix: Matrix44, layer: str, depth: int) -> None:
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
        """Yield where a block stands: once, or in rows and columns."""
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

    def _take_line(self, entity: Any, matrix: Matrix44, layer: str) -> None:
        try:
            path = ezdxf.path.make_path(entity, segments=SMALLEST_ARC)
        except TypeError:  # meshes are polylines, too
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
