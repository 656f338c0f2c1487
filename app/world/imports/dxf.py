"""Imports a DXF drawing as a floor plan: lines become walls, and the layer PATH (or a proposal) becomes the path."""

import re
from itertools import pairwise
from pathlib import Path
from typing import Any, Final

import numpy as np

from app.world.floorplan import MAX_WALLS
from app.world.imports.draft import Draft, path_document, plain_name
from app.world.imports.dxf_lines import Drawing, read_dxf
from app.world.imports.inside import inside_of_building
from app.world.imports.raster import free_cells
from app.world.imports.route import propose_route
from app.world.imports.wall_pieces import DECIMALS as MILLIMETRES
from app.world.imports.wall_pieces import Point, chain_pieces, join_pieces
from app.world.path import Path as Line

PATH_LAYER: Final = "path"
WORDS_ON: Final = re.compile(r"text|dim|anno|bema|ma(ß|ss)|hatch|defpoints|title|frame|grid|axis", re.IGNORECASE)
WALL_THICKNESS: Final = 0.02  # m; small, because the lines of drawings are surfaces of walls
WIDEST: Final = 500.0  # m
NARROWEST: Final = 1.0  # m
FINEST: Final = 0.05  # m per cell of the grid on which a path is searched
MOST_CELLS: Final = 1_000_000
MOST_PATHS: Final = 20
DECIMALS: Final = 4


def import_dxf(
    file: Path,
    unit: str | None = None,
    layers: tuple[str, ...] | None = None,
    title: str | None = None,
    name: str | None = None,
) -> Draft:
    """Return a floor plan made of a drawing's lines, with its lower left corner at the origin.

    `unit` (mm, cm, m, inch or foot) is needed when the drawing does not contain it. `layers` are those whose lines
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
    _check_size(file, float(size[0]), float(size[1]))
    x, y = float(low[0]), float(low[1])
    walls = join_pieces(((a[0] - x, a[1] - y), (b[0] - x, b[1] - y)) for a, b in pieces)
    edges = sum(len(wall) - 1 for wall in walls)
    if edges > MAX_WALLS:
        raise ValueError(
            f"{file}: this drawing has {edges:,} wall pieces and at most {MAX_WALLS:,} are taken, choose fewer layers"
        )
    drawn = _drawn_paths(drawing, (x, y))
    paths = drawn or _propose_path(walls, (float(size[0]), float(size[1])))
    document: dict[str, Any] = {
        "name": name or plain_name(file.stem),
        "title": title or file.stem[:80],
        "walls": walls,
        "wall_thickness": WALL_THICKNESS,
        "paths": paths,
    }
    return Draft(document, tuple(_sentences(drawing, edges, drawn, paths)), offered, chosen)


def _choose_layers(file: Path, offered: tuple[str, ...], layers: tuple[str, ...] | None) -> tuple[str, ...]:
    if layers is None:
        return tuple(layer for layer in offered if not WORDS_ON.search(layer))
    for layer in layers:
        if layer not in offered:
            known = ", ".join(offered[:10]) or "none"
            raise ValueError(f"{file}: there is no layer '{layer[:40]}' with lines, use some of these: {known}")
    return layers


def _check_size(file: Path, width: float, height: float) -> None:
    if max(width, height) > WIDEST:
        raise ValueError(
            f"{file}: this drawing is {width:,.0f} x {height:,.0f} m large, give its unit, "
            "or remove what lies far from the building"
        )
    if max(width, height) < NARROWEST:
        raise ValueError(f"{file}: this drawing is only {width:.3f} x {height:.3f} m large, give its unit")


def _drawn_paths(drawing: Drawing, origin: Point) -> list[dict[str, Any]]:
    """Return the paths on the layer PATH; lines that meet are joined into one path."""
    lines = [line for layer, found in drawing.layers.items() if layer.lower() == PATH_LAYER for line in found]
    polylines = [line for line in lines if len(line) > 2]
    loose = [(line[0], line[1]) for line in lines if len(line) == 2]
    polylines += [_in_drawn_direction(chain, loose) for chain in chain_pieces(loose)]
    paths: list[dict[str, Any]] = []
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


def _propose_path(walls: list[list[Point]], size: tuple[float, float]) -> list[dict[str, Any]]:
    """Return a list of one path through the largest part of the building; an empty list when a chair fits nowhere."""
    resolution = max(FINEST, float(np.sqrt(size[0] * size[1] / MOST_CELLS)), max(size) / MOST_CELLS)
    free = free_cells(walls, WALL_THICKNESS, size, resolution)
    inside = inside_of_building(free, resolution)
    route = None if inside is None else propose_route(inside.free, resolution)
    if route is None:
        return []
    points = (route.cells * resolution).round(DECIMALS).tolist()
    return [path_document(points)] if Line(points).length > 0 else []


def _sentences(drawing: Drawing, edges: int, drawn: list[dict[str, Any]], paths: list[dict[str, Any]]) -> list[str]:
    words = [f"{edges} wall pieces."]
    if drawn:
        words.append(f"{len(drawn)} from the layer PATH." if len(drawn) > 1 else "The path is that of the layer PATH.")
    elif paths:
        words.append("The path is a proposal: change it as you like.")
    else:
        words.append("A chair fits nowhere, so there is no path yet: draw one, or check the unit.")
    if drawing.left_out:
        kinds = ", ".join(f"{count} {kind}" for kind, count in sorted(drawing.left_out.items())[:8])
        words.append(f"Not taken over: {kinds}.")
    return words
