"""Meshes of simple bodies, and merging many of them into one: fewer draw calls are faster on a tablet."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.scene.meshes.palette import Colour

Vector = tuple[float, float, float]
ROUND = 16  # sides of what should look round


@dataclass(frozen=True, slots=True)
class Mesh:
    """Triangles: `vertices` (n, 3) in m and `faces` (m, 3), counter-clockwise from outside."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.int64]

    def moved(self, x: float = 0.0, y: float = 0.0, z: float = 0.0, heading: float = 0.0) -> "Mesh":
        """Return the mesh rotated by `heading` (rad) about the vertical, then moved (m)."""
        cos, sin = math.cos(heading), math.sin(heading)
        turn = np.array([[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]])
        return Mesh(self.vertices @ turn + (x, y, z), self.faces)

    def tilted(self, angle: float) -> "Mesh":
        """Return the mesh rotated by `angle` (rad) about the left axis; a positive angle tilts forward."""
        cos, sin = math.cos(angle), math.sin(angle)
        turn = np.array([[cos, 0.0, -sin], [0.0, 1.0, 0.0], [sin, 0.0, cos]])
        return Mesh(self.vertices @ turn, self.faces)


class Part(NamedTuple):
    """A mesh of one colour, drawn with one call."""

    mesh: Mesh
    colour: Colour


def merged(meshes: Iterable[Mesh]) -> Mesh:
    """Return one mesh of many."""
    parts = list(meshes)
    if not parts:
        return Mesh(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64))
    starts = np.cumsum([0] + [len(part.vertices) for part in parts[:-1]])
    return Mesh(
        np.concatenate([part.vertices for part in parts]),
        np.concatenate([part.faces + start for part, start in zip(parts, starts, strict=True)]),
    )


def quads(corners: NDArray[np.float64]) -> Mesh:
    """Return the mesh of flat quadrilaterals (n, 4, 3), each with its own vertices, so that edges look sharp."""
    count = len(corners)
    first = 4 * np.arange(count)[:, np.newaxis]
    faces = np.concatenate([first + np.array([0, 1, 2]), first + np.array([0, 2, 3])])
    return Mesh(corners.reshape(-1, 3).astype(np.float64), faces.astype(np.int64))


def surface(grid: NDArray[np.float64], *, is_closed: bool = False) -> Mesh:
    """Return the smooth surface through a grid of points (n_rows, n_columns, 3).

    The last column is joined to the first, and with `is_closed` the last row to the first, too. Seen from outside,
    columns run to the right and rows downwards.
    """
    numbers = np.arange(grid.shape[0] * grid.shape[1]).reshape(grid.shape[:2])
    numbers = np.hstack([numbers, numbers[:, :1]])
    if is_closed:
        numbers = np.vstack([numbers, numbers[:1]])
    corner, below, across, right = numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:]
    faces = np.concatenate([np.stack([corner, below, across], axis=-1), np.stack([corner, across, right], axis=-1)])
    return Mesh(grid.reshape(-1, 3), faces.reshape(-1, 3))


def rectangle(x_min: float, y_min: float, x_max: float, y_max: float, z: float) -> Mesh:
    """Return a horizontal rectangle at height `z` (m) that faces up, with sides along x and y."""
    return quads(np.array([[[x_min, y_min, z], [x_max, y_min, z], [x_max, y_max, z], [x_min, y_max, z]]]))


_BOX_FACES = np.array(
    [
        [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]],
        [[-1, 1, -1], [1, 1, -1], [1, -1, -1], [-1, -1, -1]],
        [[1, -1, -1], [1, 1, -1], [1, 1, 1], [1, -1, 1]],
        [[-1, 1, -1], [-1, -1, -1], [-1, -1, 1], [-1, 1, 1]],
        [[1, 1, -1], [-1, 1, -1], [-1, 1, 1], [1, 1, 1]],
        [[-1, -1, -1], [1, -1, -1], [1, -1, 1], [-1, -1, 1]],
    ],
    dtype=np.float64,
)


def box(size: Vector, middle: Vector = (0.0, 0.0, 0.0)) -> Mesh:
    """Return a box of `size` around `middle` (m)."""
    return quads(_BOX_FACES * (np.array(size) / 2) + np.array(middle))


def standing_box(length: float, width: float, low: float, high: float, x: float = 0.0, y: float = 0.0) -> Mesh:
    """Return a box over the place (x, y), from height `low` to `high` (m)."""
    return box((length, width, high - low), (x, y, (low + high) / 2))


def tube(start: Vector, end: Vector, radius: float, end_radius: float | None = None, sides: int = ROUND) -> Mesh:
    """Return a closed cylinder (or cone) from `start` to `end` (m)."""
    a, b = np.array(start), np.array(end)
    along = (b - a) / np.linalg.norm(b - a)
    across = np.cross(along, (0.0, 0.0, 1.0) if abs(along[2]) < 0.9 else (1.0, 0.0, 0.0))
    across /= np.linalg.norm(across)
    third = np.cross(along, across)
    turns = np.linspace(0.0, math.tau, sides, endpoint=False)
    ring = np.cos(turns)[:, np.newaxis] * across + np.sin(turns)[:, np.newaxis] * third
    low = a + radius * ring
    high = b + (radius if end_radius is None else end_radius) * ring
    fan = np.array([[0, k, k + 1] for k in range(1, sides - 1)])
    return merged([surface(np.stack([high, low])), Mesh(high, fan), Mesh(low, fan[:, ::-1])])


def ball(middle: Vector, radius: float | Vector, sides: int = ROUND) -> Mesh:
    """Return a sphere, or an ellipsoid with three radii (m)."""
    polar = np.linspace(0.0, math.pi, sides // 2 + 1)
    turns = np.linspace(0.0, math.tau, sides, endpoint=False)
    x, y = np.outer(np.sin(polar), np.cos(turns)), np.outer(np.sin(polar), np.sin(turns))
    z = np.outer(np.cos(polar), np.ones(sides))
    return surface(np.stack([x, y, z], axis=-1) * np.array(radius) + np.array(middle))


def limb(points: Sequence[Vector], radius: float, sides: int = 12) -> Mesh:
    """Return a round line through points, with balls at its bends: an arm, a leg, a bent pipe."""
    bends = [ball(point, radius, sides) for point in points]
    pieces = [tube(a, b, radius, sides=sides) for a, b in pairwise(points)]
    return merged([*bends, *pieces])


def ring(middle: Vector, inner: float, outer: float, sides: int = 48) -> Mesh:
    """Return a flat ring that looks up (m)."""
    turns = np.linspace(0.0, math.tau, sides + 1)
    circle = np.stack([np.cos(turns), np.sin(turns), np.zeros(sides + 1)], axis=-1)
    small, large = inner * circle + middle, outer * circle + middle
    return quads(np.stack([small[:-1], large[:-1], large[1:], small[1:]], axis=1))


def wheel(middle: Vector, radius: float, width: float, tyre: float, sides: int = 28) -> Mesh:
    """Return a tyre about the left axis: a ring of round section, `tyre` being its thickness (m)."""
    turns = np.linspace(0.0, math.tau, sides, endpoint=False)
    section = np.linspace(0.0, math.tau, 10, endpoint=False)
    reach = radius - tyre / 2 + np.cos(section) * tyre / 2
    x, z = np.outer(reach, np.cos(turns)), np.outer(reach, np.sin(turns))
    y = np.outer(np.sin(section) * width / 2, np.ones(sides))
    return surface(np.stack([x, y, z], axis=-1) + np.array(middle), is_closed=True)


def strip(points: Sequence[Sequence[float]], width: float, z: float) -> Mesh:
    """Return a flat band of `width` along a line through `points` (x, y), with mitred corners (m).

    A corner sharper than about 30 degrees is cut off rather than drawn out into a spike.
    """
    line = np.array([point[:2] for point in points], dtype=np.float64)
    is_distinct = np.concatenate([[True], np.linalg.norm(np.diff(line, axis=0), axis=1) > 1e-9])
    line = line[is_distinct]
    along = np.diff(line, axis=0)
    along /= np.linalg.norm(along, axis=1)[:, np.newaxis]
    normals = np.stack([-along[:, 1], along[:, 0]], axis=1)
    bisectors = np.concatenate([normals[:1], normals[:-1] + normals[1:], normals[-1:]])
    lengths = np.linalg.norm(bisectors, axis=1)
    turned_back = lengths < 1e-6
    bisectors[turned_back] = np.concatenate([normals[:1], normals])[turned_back]
    bisectors /= np.linalg.norm(bisectors, axis=1)[:, np.newaxis]
    cosines = np.einsum("ij,ij->i", bisectors, np.concatenate([normals[:1], normals]))
    offset = bisectors * (width / 2 / np.maximum(cosines, 0.25))[:, np.newaxis]
    left, right = line + offset, line - offset
    height = np.full((len(line), 1), z)
    left3, right3 = np.hstack([left, height]), np.hstack([right, height])
    return quads(np.stack([right3[:-1], right3[1:], left3[1:], left3[:-1]], axis=1))
