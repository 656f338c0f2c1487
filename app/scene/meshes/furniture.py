"""The meshes of obstacles, chosen by their labels; each fills the footprint at which the chair stops."""

import math
from collections.abc import Callable, Sequence
from typing import Final

import numpy as np

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, ball, limb, merged, standing_box, tube
from app.scene.meshes.palette import Colour
from app.scene.models.objects import Model
from app.world.obstacles import Box, Cylinder, Obstacle

Piece = tuple[Colour, Mesh]
Shape = Callable[[float, float, float], list[Piece]]  # length, width, height in m, around the origin
ModelOf = Callable[[str], Model | None]
"""Returns the 3D object of a name, None when there is none."""

CUTS = 14
SUNK = 0.3  # share of the half height that is below the floor, so that the boulder does not stand on a point
SIDES = 12


def no_model(_name: str) -> Model | None:
    """Return None: every obstacle is drawn by its label."""
    return None


def furniture(obstacles: Sequence[Obstacle], model_of: ModelOf = no_model) -> dict[Colour, Mesh]:
    """Return the meshes of all obstacles, merged into one for each colour."""
    by_colour: dict[Colour, list[Mesh]] = {}
    for obstacle in obstacles:
        for colour, mesh in _pieces(obstacle, model_of):
            by_colour.setdefault(colour, []).append(mesh)
    return {colour: merged(meshes) for colour, meshes in by_colour.items()}


def _pieces(obstacle: Obstacle, model_of: ModelOf) -> list[Piece]:
    x, y = obstacle.position
    label = obstacle.label.lower()
    model = model_of(obstacle.model) if isinstance(obstacle, Box) and obstacle.model else None
    if isinstance(obstacle, Box) and model is not None:
        pieces = [(part.colour, part.mesh) for part in model.scaled(*obstacle.size, obstacle.height)]
        turn = obstacle.angle
    elif not isinstance(obstacle, Box) and "rock" in label:
        pieces = [_rock(obstacle)]
        turn = 0.0
    elif isinstance(obstacle, Box):
        shape = next((shape for word, shape in BOX_SHAPES if word in label), block)
        length, width = obstacle.size
        turn = obstacle.angle
        if width > length and shape in LONG_SIDE_ALONG_X:
            length, width, turn = width, length, turn + math.pi / 2
        pieces = shape(length, width, obstacle.height)
    else:
        shape = next((shape for word, shape in ROUND_SHAPES if word in label), column)
        pieces = shape(2 * obstacle.radius, 2 * obstacle.radius, obstacle.height)
        turn = 0.0
    return [(colour, mesh.moved(x, y, heading=turn)) for colour, mesh in pieces]


def _rock(obstacle: Cylinder) -> Piece:
    x, y = obstacle.position
    colour = palette.PALE_ROCK if math.sin(7 * x + 5 * y) > 0 else palette.ROCK
    return colour, rock(obstacle.radius, obstacle.height, (x, y))


def rock(radius: float, height: float, seed: tuple[float, float]) -> Mesh:
    """Return a boulder that fits exactly into a cylinder of `radius` and `height`.

    Parameters
    ----------
    radius, height
        Size, m.
    seed
        The boulder's place in the plan (m), so that it looks the same each time.
    """
    rng = np.random.default_rng([int(1000 * abs(value)) for value in seed])
    sphere = ball((0.0, 0.0, 0.0), 1.0, SIDES)
    points = sphere.vertices.copy()
    planes = rng.normal(size=(CUTS, 3))
    planes /= np.linalg.norm(planes, axis=1)[:, np.newaxis]
    for plane, depth in zip(planes, rng.uniform(0.68, 0.95, CUTS), strict=True):
        reach = points @ plane
        points *= np.where(reach > depth, depth / np.maximum(reach, depth), 1.0)[:, np.newaxis]
    points[:, :2] *= radius / np.hypot(points[:, 0], points[:, 1]).max()
    points[:, 2] = height * (points[:, 2] + SUNK) / (points[:, 2].max() + SUNK)
    faces = sphere.faces[np.linalg.norm(_normals(points, sphere.faces), axis=1) > 1e-9]
    # Each face has its own points, so that edges look sharp.
    return Mesh(points[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3))


def _normals(points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return a normal of each face (m, 3), its length twice the face's area."""
    a, b, c = (points[faces[:, corner]] for corner in range(3))
    normals: np.ndarray = np.cross(b - a, c - a)
    return normals


def block(length: float, width: float, height: float) -> list[Piece]:
    """Return a plain box."""
    return [(palette.WOOD, standing_box(length, width, 0.0, height))]


def _table(length: float, width: float, height: float) -> list[Piece]:
    top = min(0.05, height / 2)
    inset = min(0.06, length / 4, width / 4)
    legs = [
        standing_box(0.05, 0.05, 0.0, height - top, sx * (length / 2 - inset), sy * (width / 2 - inset))
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    return [(palette.WOOD, standing_box(length, width, height - top, height)), (palette.METAL, merged(legs))]


def _bed(length: float, width: float, height: float) -> list[Piece]:
    base = 0.55 * height
    pillow = ball((length / 2 - 0.28, 0.0, height), (0.18, 0.38 * width, 0.09))
    return [
        (palette.WOOD, standing_box(length, width, 0.12 * height, base)),
        (palette.LINEN, merged([standing_box(0.97 * length, 0.94 * width, base, height), pillow])),
        (
            palette.FABRIC,
            standing_box(0.6 * length, 0.98 * width, 0.75 * height, height + 0.03, x=-0.18 * length),
        ),
        (palette.DARK, standing_box(0.9 * length, 0.85 * width, 0.0, 0.12 * height)),
    ]


def _couch(length: float, width: float, height: float) -> list[Piece]:
    """Return an examination or treatment couch, a padded top on a column."""
    pad = min(0.12, height / 3)
    raised = standing_box(0.3 * length, 0.94 * width, 0.0, 0.06).tilted(-0.25).moved(x=0.34 * length, z=height)
    return [
        (palette.FABRIC, merged([standing_box(length, width, height - pad, height), raised])),
        (palette.METAL, merged([standing_box(0.75 * length, 0.6 * width, 0.12, height - pad)])),
        (palette.DARK, standing_box(0.85 * length, 0.8 * width, 0.0, 0.12)),
    ]


def _sofa(length: float, width: float, height: float) -> list[Piece]:
    seat = min(0.45, 0.6 * height)
    arm = min(0.16, length / 6)
    low_arm = min(seat + 0.18, height)
    back = standing_box(length, 0.28 * width, 0.06, height, y=-0.36 * width)
    arms = [standing_box(arm, width, 0.06, low_arm, x=side * (length - arm) / 2) for side in (-1, 1)]
    cushion = standing_box(length - 2 * arm, 0.72 * width, 0.06, seat, y=0.14 * width)
    return [(palette.FABRIC, merged([back, *arms, cushion]))]


def _bench(length: float, width: float, height: float) -> list[Piece]:
    legs = [standing_box(0.08, 0.9 * width, 0.0, 0.86 * height, x=side * 0.4 * length) for side in (-1, 1)]
    return [(palette.WOOD, standing_box(length, width, 0.86 * height, height)), (palette.METAL, merged(legs))]


def _chair(length: float, width: float, height: float) -> list[Piece]:
    seat = min(0.46, 0.6 * height)
    legs = [
        standing_box(0.04, 0.04, 0.0, seat, sx * (length / 2 - 0.03), sy * (width / 2 - 0.03))
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    soft = [
        standing_box(length, width, seat - 0.06, seat),
        standing_box(0.05, width, seat, height, x=-length / 2 + 0.025),
    ]
    return [(palette.ACCENT, merged(soft)), (palette.METAL, merged(legs))]


def _cupboard(length: float, width: float, height: float) -> list[Piece]:
    """Return a cupboard with a darker plinth and lines between its doors, on both long sides."""
    lines = [
        standing_box(0.012, width + 0.008, 0.14, height - 0.06, x=offset * length) for offset in (-0.25, 0.0, 0.25)
    ]
    return [
        (palette.WOOD, standing_box(length, width, 0.1, height)),
        (palette.DARK_WOOD, merged([standing_box(0.98 * length, 0.96 * width, 0.0, 0.1), *lines])),
    ]


def _shelf(length: float, width: float, height: float) -> list[Piece]:
    count = max(2, round(height / 0.38))
    boards = [standing_box(length, width, z, z + 0.03) for z in np.linspace(0.05, height - 0.03, count)]
    ends = [standing_box(0.03, width, 0.0, height, x=side * (length / 2 - 0.015)) for side in (-1, 1)]
    step = height / count
    books = [
        standing_box(0.8 * length, 0.7 * width, 0.05 + row * step + 0.03, 0.05 + row * step + 0.72 * step)
        for row in range(count - 1)
    ]
    colours = (palette.FABRIC, palette.ACCENT, palette.LINEN)
    filled = [(colours[row % 3], mesh) for row, mesh in enumerate(books)]
    return [(palette.WOOD, merged([*boards, *ends])), *filled]


def _counter(length: float, width: float, height: float) -> list[Piece]:
    return [
        (palette.LINEN, standing_box(0.98 * length, 0.96 * width, 0.08, height - 0.04)),
        (palette.DARK, merged([standing_box(length, width, height - 0.04, height)])),
        (palette.METAL, standing_box(0.94 * length, 0.9 * width, 0.0, 0.08)),
    ]


def _ceramic(length: float, width: float, height: float) -> list[Piece]:
    body = standing_box(0.7 * length, 0.7 * width, 0.0, 0.85 * height)
    bowl = standing_box(length, width, 0.82 * height, height)
    inside = standing_box(0.7 * length, 0.7 * width, height, height + 0.004)
    return [(palette.CERAMIC, merged([body, bowl])), (palette.METAL, inside)]


def _toilet(length: float, width: float, height: float) -> list[Piece]:
    seat = min(0.45, height)
    tank = standing_box(0.28 * length, width, 0.0, max(height, seat), x=-0.36 * length)
    bowl = ball((0.12 * length, 0.0, 0.6 * seat), (0.38 * length, 0.46 * width, 0.4 * seat))
    foot = standing_box(0.62 * length, 0.5 * width, 0.0, 0.5 * seat, x=0.1 * length)
    return [(palette.CERAMIC, merged([tank, bowl, foot]))]


def _mat(length: float, width: float, height: float) -> list[Piece]:
    return [(palette.FABRIC, standing_box(length, width, 0.0, height))]


def _bar(length: float, width: float, height: float) -> list[Piece]:
    across = min(length, width) / 2
    along_x = length >= width
    reach = max(length, width) / 2

    def at(along: float, z: float) -> tuple[float, float, float]:
        return (along, 0.0, z) if along_x else (0.0, along, z)

    posts = [tube(at(side * (reach - across), 0.0), at(side * (reach - across), height), across) for side in (-1, 1)]
    rail = limb([at(-reach + across, height - across), at(reach - across, height - across)], across, 8)
    return [(palette.METAL, merged([*posts, rail]))]


def _trolley(length: float, width: float, height: float) -> list[Piece]:
    decks = [standing_box(length, width, z, z + 0.04) for z in (0.15 * height, 0.55 * height, height - 0.04)]
    posts = [
        standing_box(0.03, 0.03, 0.0, height, sx * (length / 2 - 0.02), sy * (width / 2 - 0.02))
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    return [(palette.METAL, merged(posts)), (palette.CERAMIC, merged(decks))]


def _screen(length: float, width: float, height: float) -> list[Piece]:
    low = min(0.45, 0.5 * height)
    return [
        (palette.DARK_WOOD, standing_box(length, width, 0.0, low)),
        (palette.DARK, standing_box(0.86 * length, 0.2 * width, low + 0.04, height)),
    ]


def _plant(length: float, _width: float, height: float) -> list[Piece]:
    radius = length / 2
    pot = min(0.42 * height, 0.45)
    crown = height - pot
    leaves = [ball((0.0, 0.0, pot + 0.55 * crown), (0.8 * radius, 0.8 * radius, 0.5 * crown), 12)]
    for turn in np.linspace(0.0, math.tau, 4, endpoint=False):
        x, y = 0.5 * radius * math.cos(turn), 0.5 * radius * math.sin(turn)
        leaves.append(ball((x, y, pot + 0.4 * crown), (0.5 * radius, 0.5 * radius, 0.36 * crown), 8))
    return [
        (palette.ACCENT, tube((0.0, 0.0, 0.0), (0.0, 0.0, pot), 0.78 * radius, radius)),
        (palette.LEAF, merged(leaves)),
    ]


def _sphere(length: float, _width: float, height: float) -> list[Piece]:
    return [(palette.ACCENT, ball((0.0, 0.0, height / 2), (length / 2, length / 2, height / 2)))]


def _round_table(length: float, _width: float, height: float) -> list[Piece]:
    radius = length / 2
    return [
        (palette.WOOD, tube((0.0, 0.0, height - 0.05), (0.0, 0.0, height), radius, sides=32)),
        (
            palette.METAL,
            merged(
                [
                    tube((0.0, 0.0, 0.0), (0.0, 0.0, height - 0.05), 0.05),
                    tube((0.0, 0.0, 0.0), (0.0, 0.0, 0.04), 0.6 * radius),
                ]
            ),
        ),
    ]


def _stool(length: float, _width: float, height: float) -> list[Piece]:
    radius = length / 2
    return [
        (palette.FABRIC, tube((0.0, 0.0, height - 0.09), (0.0, 0.0, height), radius)),
        (
            palette.METAL,
            merged(
                [
                    tube((0.0, 0.0, 0.0), (0.0, 0.0, height - 0.09), 0.035),
                    tube((0.0, 0.0, 0.0), (0.0, 0.0, 0.05), 0.9 * radius),
                ]
            ),
        ),
    ]


def column(length: float, _width: float, height: float) -> list[Piece]:
    """Return a plain cylinder."""
    return [(palette.LINEN, tube((0.0, 0.0, 0.0), (0.0, 0.0, height), length / 2, sides=32))]


# The first of these words that an obstacle's label contains decides; a word stands before the words that it contains.
BOX_SHAPES: Final[tuple[tuple[str, Shape], ...]] = (
    ("treatment table", _couch),
    ("couch", _couch),
    ("bed", _bed),
    ("sofa", _sofa),
    ("armchair", _sofa),
    ("bench", _bench),
    ("chair", _chair),
    ("counter", _counter),
    ("bookshelf", _shelf),
    ("shelf", _shelf),
    ("cupboard", _cupboard),
    ("wardrobe", _cupboard),
    ("desk", _table),
    ("table", _table),
    ("washbasin", _ceramic),
    ("shower", _ceramic),
    ("toilet", _toilet),
    ("mat", _mat),
    ("bar", _bar),
    ("trolley", _trolley),
    ("television", _screen),
)


ROUND_SHAPES: Final[tuple[tuple[str, Shape], ...]] = (
    ("plant", _plant),
    ("tree", _plant),
    ("ball", _sphere),
    ("table", _round_table),
    ("stool", _stool),
    ("chair", _stool),
)


LONG_SIDE_ALONG_X: Final = frozenset({_bed, _couch, _sofa, _bench, _cupboard, _shelf})
