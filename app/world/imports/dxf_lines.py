"""Reads the lines of a DXF drawing's model space by layer, with blocks resolved and curves approximated by chords."""

import math
from collections import Counter, defaultdict
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Final, NamedTuple, TypeAlias

import ezdxf.path
import ezdxf.recover
from ezdxf.audit import AuditError
from ezdxf.document import Drawing
from ezdxf.math import Matrix44, Vec3
from ezdxf.xclip import XClip

from app.texts import Text, text_of
from app.world.imports.file_limits import MOST_PLAN_BYTES
from app.world.imports.wall_pieces import Point

MOST_ENTITIES: Final = 200_000  # visited; those in a block count each time the block is placed
MOST_POINTS: Final = 400_000
DEEPEST: Final = 16  # levels of blocks in blocks
SAGITTA: Final = 0.01  # m, largest distance of a chord from its curve
SMALLEST_ARC: Final = 4  # curves that a full circle is divided into before the chords are made
FARTHEST: Final = 1e7  # m; coordinates beyond are errors of the drawing and would make too many chords

UNITS: Final = {"mm": 0.001, "cm": 0.01, "m": 1.0, "inch": 0.0254, "foot": 0.3048}  # m
HEADER_UNITS: Final = {1: "inch", 2: "foot", 4: "mm", 5: "cm", 6: "m"}  # $INSUNITS, DXF reference, HEADER section
LINES: Final = frozenset({"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE", "ELLIPSE"})
TEXTS: Final = frozenset({"TEXT", "MTEXT", "DIMENSION", "ATTDEF", "ATTRIB", "LEADER", "MULTILEADER", "VIEWPORT"})


Entity: TypeAlias = Any
"""An entity of ezdxf, whose attributes are those of its kind."""


class DxfDrawing(NamedTuple):
    """The lines of a drawing, and how many things were not read."""

    layers: dict[str, list[list[Point]]]  # layer -> lines, m
    unit: str  # a key of UNITS
    left_out: Counter[str]  # by kind of entity, or as the message plan-left-out names it
    hidden: Counter[str]  # by layer, of those that are off or frozen
    files: Counter[str]  # by block, of blocks that are other drawings


def read_dxf(file: Path, unit: str | None = None) -> DxfDrawing:
    """Read the lines of a DXF file; `unit` (a key of UNITS) overrides the unit in the drawing.

    What drawing programs do not show is left out: layers that are off or frozen, and invisible entities (group code
    60). A block's lines are shown though the layer of the block is off, unless they lie on layer 0, which stands for
    that layer; on a frozen layer a block is hidden with all its lines. z coordinates are dropped.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    if unit is not None and unit not in UNITS:
        raise ValueError(f"the unit '{unit}' is not known: use one of {', '.join(UNITS)}")
    document, missing = _document(file)
    try:
        reader = _Reader(file, document, _unit(file, document, unit))
        reader.left_out["missing-blocks"] += missing
        return reader.read()
    except ValueError as error:
        if isinstance(text_of(error), Text):
            raise
        raise ValueError(Text("plan-drawing-damaged", file=str(file))) from error
    except Exception as error:
        # ezdxf checks little of a drawing's content and may raise any exception.
        raise ValueError(Text("plan-drawing-damaged", file=str(file))) from error


def _document(file: Path) -> tuple[Drawing, int]:
    """Return the drawing, and the number of references to blocks that it does not have."""
    try:
        with file.open("rb") as opened:
            content = opened.read(MOST_PLAN_BYTES + 1)
    except FileNotFoundError as error:
        raise ValueError(Text("plan-file-missing", file=str(file))) from error
    except OSError as error:
        reason = error.strerror or str(error)
        raise ValueError(Text("plan-file-unreadable", file=str(file), reason=reason)) from error
    if len(content) > MOST_PLAN_BYTES:
        raise ValueError(Text("plan-drawing-large", file=str(file), most=MOST_PLAN_BYTES // 1_000_000))
    if content[:2] == b"AC":
        raise ValueError(Text("plan-drawing-dwg", file=str(file)))
    if b"SECTION" not in content:
        raise ValueError(Text("plan-drawing-no-dxf", file=str(file)))
    try:
        document, auditor = ezdxf.recover.readfile(file)
    except Exception as error:
        raise ValueError(Text("plan-drawing-no-dxf", file=str(file))) from error
    return document, sum(fix.code == AuditError.UNDEFINED_BLOCK for fix in auditor.fixes)


def _unit(file: Path, document: Drawing, unit: str | None) -> str:
    """Return the unit of the drawing."""
    name = unit or HEADER_UNITS.get(document.header.get("$INSUNITS", 0))
    if name is None:
        raise ValueError(Text("plan-drawing-without-unit", file=str(file), units=", ".join(UNITS)))
    return name


class _Reader:
    """Visits the entities of a drawing and counts them, so that nested blocks cannot take unlimited time."""

    def __init__(self, file: Path, document: Drawing, unit: str) -> None:
        self._file = file
        self._document = document
        self._unit = unit
        self._visited = self._points = 0
        self._layers: defaultdict[str, list[list[Point]]] = defaultdict(list)
        self.left_out: Counter[str] = Counter()
        self._hidden: Counter[str] = Counter()
        self._files: Counter[str] = Counter()
        self._off = {layer.dxf.name.lower() for layer in document.layers if layer.is_off()}
        self._frozen = {layer.dxf.name.lower() for layer in document.layers if layer.is_frozen()}

    def read(self) -> DxfDrawing:
        self._walk(self._document.modelspace(), Matrix44.scale(UNITS[self._unit]), None, 0)
        return DxfDrawing(dict(self._layers), self._unit, +self.left_out, self._hidden, self._files)

    def _walk(self, entities: Iterable[Entity], matrix: Matrix44, inherited: str | None, depth: int) -> None:
        """Read entities in a block's coordinates; layer 0 of a block means the layer that the block is placed on."""
        for entity in entities:
            self._visited += 1
            if self._visited > MOST_ENTITIES:
                raise ValueError(Text("plan-drawing-too-much", file=str(self._file), most=MOST_ENTITIES))
            layer = str(entity.dxf.layer)
            layer = inherited if inherited is not None and layer == "0" else layer
            kind = entity.dxftype()
            if entity.dxf.get("invisible", 0):
                self.left_out["invisible"] += 1
            elif layer.lower() in self._frozen or (layer.lower() in self._off and kind != "INSERT"):
                self._hidden[layer] += 1
            elif kind in TEXTS:
                self.left_out["texts"] += 1
            elif kind == "INSERT":
                self._read_block(entity, matrix, layer, depth)
            elif kind == "MLINE":
                self._walk(entity.virtual_entities(), matrix, layer, depth)
            elif kind in LINES:
                self._read_line(entity, matrix, layer)
            else:
                self.left_out[kind] += 1

    def _read_block(self, insert: Entity, matrix: Matrix44, layer: str, depth: int) -> None:
        block = insert.block()
        if block is None or block.is_any_layout:
            self.left_out["missing-blocks"] += 1
            return
        if block.block.is_xref or block.block.is_xref_overlay:
            self._files[str(insert.dxf.name)] += 1
        if depth >= DEEPEST:
            raise ValueError(Text("plan-drawing-blocks-deep", file=str(self._file), most=DEEPEST))
        if XClip(insert).is_clipping_enabled:
            self.left_out["clipped-blocks"] += 1
        for place in self._places(insert):
            self._visited += 1
            self._walk(block, place.matrix44() * matrix, layer, depth + 1)

    def _places(self, insert: Entity) -> Iterable[Entity]:
        """Return the block references that an array of rows and columns stands for."""
        times = max(1, insert.dxf.row_count) * max(1, insert.dxf.column_count)
        if times > MOST_ENTITIES:
            raise ValueError(Text("plan-drawing-block-often", file=str(self._file), count=times))
        return insert.multi_insert() if insert.mcount > 1 else (insert,)

    def _read_line(self, entity: Entity, matrix: Matrix44, layer: str) -> None:
        try:
            path = ezdxf.path.make_path(entity, segments=SMALLEST_ARC)
        except TypeError:  # a POLYLINE may also be a mesh
            self.left_out[entity.dxftype()] += 1
            return
        path = path.transform(matrix)
        if not len(path):
            return
        if any(not _is_near(vertex) for vertex in path.control_vertices()):
            raise ValueError(Text("plan-drawing-far", file=str(self._file), layer=layer[:40]))
        line = [(point.x, point.y) for point in path.flattening(SAGITTA, segments=1)]
        self._points += len(line)
        if self._points > MOST_POINTS:
            raise ValueError(Text("plan-drawing-lines-too-many", file=str(self._file), most=MOST_POINTS))
        self._layers[layer].append(line)


def _is_near(vertex: Vec3) -> bool:
    return all(math.isfinite(value) and abs(value) <= FARTHEST for value in (vertex.x, vertex.y, vertex.z))
