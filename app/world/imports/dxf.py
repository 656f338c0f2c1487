"""Imports a DXF drawing as a floor plan: lines become walls, and the layer PATH (or a proposal) becomes the path."""

import re
from collections import Counter
from collections.abc import Iterable
from itertools import pairwise
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt

from app.texts import Figure, Text, Value
from app.world.floorplan import MAX_WALLS
from app.world.imports.draft import Draft, PathDocument, PlanDocument, path_document, plain_name
from app.world.imports.dxf_lines import UNITS, DxfDrawing, read_dxf
from app.world.imports.inside import inside_of_building
from app.world.imports.route import propose_route
from app.world.imports.wall_pieces import DECIMALS as MILLIMETRES
from app.world.imports.wall_pieces import Point, chain_pieces, join_pieces
from app.world.path import Path as Line

MARK_STEP: Final = 0.4  # cells between two points along a wall whose cells are marked
PATH_LAYER: Final = "path"
TEXT_LAYERS: Final = re.compile(
    r"(te?xte?s?|beschriftung(en)?|label(s|ling)?|dim(s|ensions?)?|anno(tations?)?|(be|ver)?ma(ß|ss)(e|ung|ungen|ketten?)?"
    r"|cotes?|hatch(es|ing)?|schraffur(en)?|defpoints|title(s|block)?|border|frame|rahmen|grid(s|lines?)?|raster"
    r"|ax[ie]s|achsen?|axes)",
    re.IGNORECASE,
)
WALL_LAYERS: Final = re.compile(r"w(a|ae|ä)nde?|mauer|wall|mur|muro|parete|pared", re.IGNORECASE)
WALL_THICKNESS: Final = 0.02  # m; small, because the lines of drawings are surfaces of walls
WIDEST: Final = 500.0  # m
NARROWEST: Final = 1.0  # m
METRIC: Final = ("mm", "cm", "m")
PROBABLE: Final = (3.0, 150.0)  # m, the longer side of a storey: outside of this, the unit is asked for
FINEST: Final = 0.05  # m per cell of the grid on which a path is searched
MOST_CELLS: Final = 1_000_000
MOST_PATHS: Final = 20
MOST_LISTED: Final = 8  # things left out that are named
DECIMALS: Final = 4


def import_dxf(
    file: Path,
    unit: str | None = None,
    layers: tuple[str, ...] | None = None,
    title: str | None = None,
    name: str | None = None,
) -> Draft:
    """Return a floor plan made of a drawing's lines, with its lower left corner at the origin.

    `unit` (mm, cm, m, inch or foot) is needed when the drawing does not contain it, or when its size is improbable with
    the unit that it contains. `layers` are those whose lines
    become walls; when not given, all except those for text and dimensions.

    Raises
    ------
    ValueError
        One sentence that names the file and what to do.
    """
    drawing = read_dxf(file, unit)
    offered = tuple(sorted(layer for layer in drawing.layers if layer.lower() != PATH_LAYER))
    chosen = _choose_layers(file, offered, layers)
    pieces = [piece for layer in chosen for line in drawing.layers[layer] for piece in pairwise(line)]
    if not pieces:
        raise ValueError(Text("plan-drawing-empty", file=str(file)))
    corners = np.array(pieces).reshape(-1, 2)
    low = corners.min(axis=0)
    size = corners.max(axis=0) - low
    width, height = float(size[0]), float(size[1])
    if unit is None:
        _check_unit(file, drawing.unit, width, height)
    else:
        _check_size(file, width, height)
    x, y = float(low[0]), float(low[1])
    walls = join_pieces(((a[0] - x, a[1] - y), (b[0] - x, b[1] - y)) for a, b in pieces)
    edges = sum(len(wall) - 1 for wall in walls)
    if edges > MAX_WALLS:
        raise ValueError(Text("plan-drawing-walls-too-many", file=str(file), count=edges, most=MAX_WALLS))
    drawn_paths = _drawn_paths(drawing, (x, y))
    paths = drawn_paths or _propose_path(walls, (width, height))
    document: PlanDocument = {
        "name": name or plain_name(file.stem),
        "title": title or file.stem[:80],
        "walls": walls,
        "wall_thickness": WALL_THICKNESS,
        "paths": paths,
    }
    sentences = [
        Text("plan-wall-pieces", count=edges),
        _path_sentence(drawn_paths, paths),
        _size_sentence(drawing.unit, width, height, is_given=unit is not None),
        *_left_out_sentences(drawing, () if layers else tuple(sorted(set(offered) - set(chosen)))),
    ]
    return Draft(document, tuple(sentences), offered, chosen)


def _choose_layers(file: Path, offered: tuple[str, ...], layers: tuple[str, ...] | None) -> tuple[str, ...]:
    if layers is None:
        return tuple(layer for layer in offered if not _is_for_text(layer))
    for layer in layers:
        if layer not in offered:
            names = ", ".join(offered[:10]) or Text("plan-no-layers")
            raise ValueError(Text("plan-layer-unknown", file=str(file), layer=layer[:40], names=names))
    return layers


def _is_for_text(layer: str) -> bool:
    """Return whether one of the words in a layer's name means text or dimensions, and none means a wall."""
    parts = re.findall(r"[^\W\d_]+", layer)
    return any(TEXT_LAYERS.fullmatch(part) for part in parts) and not WALL_LAYERS.search(layer)


def _check_unit(file: Path, unit: str, width: float, height: float) -> None:
    """Raise ValueError when the drawing's own unit gives a storey an improbable size."""
    if PROBABLE[0] <= max(width, height) <= PROBABLE[1]:
        return
    size: dict[str, Value] = {"file": str(file), "unit": Text("plan-unit", unit=unit), "width": width, "height": height}
    if sizes := _other_units(unit, width, height, UNITS):
        raise ValueError(Text("plan-drawing-improbable-unit", **size, sizes=sizes))
    raise ValueError(Text("plan-drawing-improbable", **size))


def _size_sentence(unit: str, width: float, height: float, *, is_given: bool) -> Text:
    """Return the drawing's size and its unit, given or its own.

    An own unit that is not metric comes with the sizes in metric ones: many drawings are marked as inch or foot
    wrongly.
    """
    size: dict[str, Value] = {
        "unit": Text("plan-unit", unit=unit),
        "width": Figure(width, 1),
        "height": Figure(height, 1),
    }
    if is_given:
        return Text("plan-drawing-size-given", **size)
    if sizes := [] if unit in METRIC else _other_units(unit, width, height, METRIC):
        return Text("plan-drawing-size-units", **size, sizes=sizes)
    return Text("plan-drawing-size", **size)


def _other_units(unit: str, width: float, height: float, units: Iterable[str]) -> list[Text]:
    """Return the probable sizes (m) of a drawing in other units."""
    factors = [(name, UNITS[name] / UNITS[unit]) for name in units if name != unit]
    return [
        Text(
            "plan-size-in-unit",
            width=Figure(width * factor, 1),
            height=Figure(height * factor, 1),
            unit=Text("plan-unit", unit=name),
        )
        for name, factor in factors
        if PROBABLE[0] <= max(width, height) * factor <= PROBABLE[1]
    ]


def _check_size(file: Path, width: float, height: float) -> None:
    if max(width, height) > WIDEST:
        raise ValueError(Text("plan-drawing-wide", file=str(file), width=round(width), height=round(height)))
    if max(width, height) < NARROWEST:
        size = {"width": Figure(width, 3), "height": Figure(height, 3)}
        raise ValueError(Text("plan-drawing-small", file=str(file), **size))


def _drawn_paths(drawing: DxfDrawing, origin: Point) -> list[PathDocument]:
    """Return the paths on the layer PATH; lines that meet are joined into one path."""
    lines = [
        line for layer, layer_lines in drawing.layers.items() if layer.lower() == PATH_LAYER for line in layer_lines
    ]
    polylines = [line for line in lines if len(line) > 2]
    loose = [(line[0], line[1]) for line in lines if len(line) == 2]
    polylines += [_in_drawn_direction(chain, loose) for chain in chain_pieces(loose)]
    paths: list[PathDocument] = []
    for line in polylines[:MOST_PATHS]:
        points = [[round(x - origin[0], DECIMALS), round(y - origin[1], DECIMALS)] for x, y in line]
        if any(point != points[0] for point in points):
            paths.append(path_document(points, len(paths) + 1))
    return paths


def _in_drawn_direction(chain: list[Point], pieces: list[tuple[Point, Point]]) -> list[Point]:
    """Return the chain in the direction in which most of its pieces are drawn."""
    drawn = {tuple((round(x, MILLIMETRES), round(y, MILLIMETRES)) for x, y in piece) for piece in pieces}
    ahead = sum((a, b) in drawn for a, b in pairwise(chain))
    back = sum((b, a) in drawn for a, b in pairwise(chain))
    return chain if ahead >= back else chain[::-1]


def _propose_path(walls: list[list[Point]], size: tuple[float, float]) -> list[PathDocument]:
    """Return a list of one path through the largest part of the building; an empty list when a chair fits nowhere."""
    resolution = max(FINEST, float(np.sqrt(size[0] * size[1] / MOST_CELLS)), max(size) / MOST_CELLS)
    free = free_cells(walls, WALL_THICKNESS, size, resolution)
    inside = inside_of_building(free, resolution)
    route = None if inside is None else propose_route(inside.free, resolution)
    if route is None:
        return []
    points = (route.cells * resolution).round(DECIMALS).tolist()
    return [path_document(points)] if Line(points).length > 0 else []


def _path_sentence(drawn_paths: list[PathDocument], paths: list[PathDocument]) -> Text:
    if drawn_paths:
        return Text("plan-drawing-paths", count=len(drawn_paths))
    return Text("plan-path-is-proposal") if paths else Text("plan-drawing-without-path")


def _left_out_sentences(drawing: DxfDrawing, by_name: tuple[str, ...]) -> list[Text]:
    """Return what is not in the plan, with counts; `by_name` are the layers left out because of their names."""
    lines = Counter({layer: len(drawing.layers[layer]) for layer in by_name})
    sentences = []
    if lines:
        sentences.append(Text("plan-drawing-layers-out", names=_counted(lines)))
    if drawing.hidden:
        sentences.append(Text("plan-drawing-hidden", names=_counted(drawing.hidden)))
    if drawing.files:
        sentences.append(Text("plan-drawing-files", names=_counted(drawing.files)))
    if drawing.left_out:
        things = [Text("plan-left-out", count=count, name=name) for name, count in sorted(drawing.left_out.items())]
        sentences.append(Text("plan-drawing-left-out", names=_first(things)))
    return sentences


def _counted(counts: Counter[str]) -> list[Text]:
    return _first([Text("plan-counted", count=count, name=name[:60]) for name, count in sorted(counts.items())])


def _first(texts: list[Text]) -> list[Text]:
    """Return the first texts, and how many more there are."""
    more = len(texts) - MOST_LISTED
    return [*texts[:MOST_LISTED], Text("plan-counted-more", count=more)] if more > 0 else texts


def free_cells(
    walls: list[list[Point]], thickness: float, size: tuple[float, float], resolution: float
) -> NDArray[np.bool_]:
    """Return which cells (rows, columns) of `resolution` (m) from the origin to `size` (m) are free of walls."""
    columns, rows = (int(np.ceil(side / resolution)) + 1 for side in size)
    marked = np.zeros((rows, columns), dtype=np.bool_)
    for wall in walls:
        points = np.array(wall)
        for a, b in pairwise(points):
            count = int(np.hypot(*(b - a)) / (resolution * MARK_STEP)) + 2
            places = (a + np.linspace(0.0, 1.0, count)[:, np.newaxis] * (b - a)) / resolution
            at = places.astype(int).clip(0, (columns - 1, rows - 1))
            marked[at[:, 1], at[:, 0]] = True
    if not marked.any():
        return ~marked
    return np.asarray(distance_transform_edt(~marked) * resolution > thickness / 2)
