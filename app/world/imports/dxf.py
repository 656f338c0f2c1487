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
        raise ValueError(f"{file}: there are no lines in this drawing (on the chosen layers), choose others")
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
        raise ValueError(
            f"{file}: this drawing has {edges:,} wall pieces and at most {MAX_WALLS:,} are taken, choose fewer layers"
        )
    drawn_paths = _drawn_paths(drawing, (x, y))
    paths = drawn_paths or _propose_path(walls, (width, height))
    document: PlanDocument = {
        "name": name or plain_name(file.stem),
        "title": title or file.stem[:80],
        "walls": walls,
        "wall_thickness": WALL_THICKNESS,
        "paths": paths,
    }
    unit_sentence = f"as given, in {drawing.unit}" if unit else _as_drawn(drawing.unit, width, height)
    sentences = [
        f"{edges} wall pieces.",
        *_path_sentences(drawn_paths, paths),
        f"The drawing is {width:.1f} x {height:.1f} m large, {unit_sentence}.",
        *_left_out_sentences(drawing, () if layers else tuple(sorted(set(offered) - set(chosen)))),
    ]
    return Draft(document, tuple(sentences), offered, chosen)


def _choose_layers(file: Path, offered: tuple[str, ...], layers: tuple[str, ...] | None) -> tuple[str, ...]:
    if layers is None:
        return tuple(layer for layer in offered if not _is_for_text(layer))
    for layer in layers:
        if layer not in offered:
            names = ", ".join(offered[:10]) or "none"
            raise ValueError(f"{file}: there is no layer '{layer[:40]}' with lines, use some of these: {names}")
    return layers


def _is_for_text(layer: str) -> bool:
    """Return whether one of the words in a layer's name means text or dimensions, and none means a wall."""
    parts = re.findall(r"[^\W\d_]+", layer)
    return any(TEXT_LAYERS.fullmatch(part) for part in parts) and not WALL_LAYERS.search(layer)


def _check_unit(file: Path, unit: str, width: float, height: float) -> None:
    """Raise ValueError when the drawing's own unit gives a storey an improbable size."""
    if PROBABLE[0] <= max(width, height) <= PROBABLE[1]:
        return
    raise ValueError(
        f"{file}: in {unit}, as it says, this drawing is {width:,.1f} x {height:,.1f} m large, which is improbable for "
        f"a storey, give its unit{_other_units(unit, width, height, UNITS)}, or remove what lies far from the building"
    )


def _as_drawn(unit: str, width: float, height: float) -> str:
    """Return the drawing's own unit, and its size in metric units: many drawings are marked as inch or foot wrongly."""
    metric = [] if unit in {"mm", "cm", "m"} else ["mm", "cm", "m"]
    return f"in {unit} as it says{_other_units(unit, width, height, metric)}"


def _other_units(unit: str, width: float, height: float, units: Iterable[str]) -> str:
    """Return the probable sizes (m) of a drawing in other units, in brackets."""
    factors = [(name, UNITS[name] / UNITS[unit]) for name in units if name != unit]
    sizes = [
        f"{width * factor:.1f} x {height * factor:.1f} m in {name}"
        for name, factor in factors
        if PROBABLE[0] <= max(width, height) * factor <= PROBABLE[1]
    ]
    return f" ({', '.join(sizes)})" if sizes else ""


def _check_size(file: Path, width: float, height: float) -> None:
    if max(width, height) > WIDEST:
        raise ValueError(
            f"{file}: this drawing is {width:,.0f} x {height:,.0f} m large, give its unit, "
            "or remove what lies far from the building"
        )
    if max(width, height) < NARROWEST:
        raise ValueError(f"{file}: this drawing is only {width:.3f} x {height:.3f} m large, give its unit")


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
            number = len(paths) + 1
            paths.append(path_document(points, "main" if number == 1 else f"path-{number}", f"Path {number}"))
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


def _path_sentences(drawn_paths: list[PathDocument], paths: list[PathDocument]) -> list[str]:
    if len(drawn_paths) > 1:
        return [f"{len(drawn_paths)} paths are from the layer PATH."]
    if drawn_paths:
        return ["The path is that of the layer PATH."]
    if paths:
        return ["The path is a proposal: change it as you like."]
    return ["A chair fits nowhere, so there is no path yet: draw one, or check the unit."]


def _left_out_sentences(drawing: DxfDrawing, by_name: tuple[str, ...]) -> list[str]:
    """Return what is not in the plan, with counts; `by_name` are the layers left out because of their names."""
    lines = Counter({layer: len(drawing.layers[layer]) for layer in by_name})
    sentences = []
    if lines:
        sentences.append(f"Left out by the names of their layers, which can be chosen: {_listed(lines)}.")
    if drawing.hidden:
        sentences.append(f"On layers that are off or frozen: {_listed(drawing.hidden)}.")
    if drawing.files:
        sentences.append(f"In other files, bind them to the drawing to have them: {_listed(drawing.files)}.")
    if drawing.left_out:
        sentences.append(f"Not taken over: {_listed(drawing.left_out)}.")
    return sentences


def _listed(counts: Counter[str]) -> str:
    list_text = ", ".join(f"{count} {name[:60]}" for name, count in sorted(counts.items())[:MOST_LISTED])
    remaining = len(counts) - MOST_LISTED
    return f"{list_text} and {remaining} more" if remaining > 0 else list_text


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
