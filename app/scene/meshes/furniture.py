"""The meshes of obstacles, by the words of their labels; each fills the footprint at which the chair stops."""

import math
from collections.abc import Callable, Sequence

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, merged
from app.scene.meshes.furniture_shapes import BOX_SHAPES, LONG_SIDE_ALONG_X, ROUND_SHAPES, Piece, block, column
from app.scene.meshes.palette import Colour
from app.scene.meshes.rock import rock
from app.scene.models.objects import Model
from app.world.obstacles import Box, Cylinder, Obstacle

ModelOf = Callable[[str], Model | None]
"""Returns the 3D object of a name, None when there is none."""


def no_model(_name: str) -> Model | None:
    """Return None: every obstacle is drawn as its label says."""
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
    words = obstacle.label.lower()
    model = model_of(obstacle.model) if isinstance(obstacle, Box) and obstacle.model else None
    if isinstance(obstacle, Box) and model is not None:
        pieces = [(part.colour, part.mesh) for part in model.scaled(*obstacle.size, obstacle.height)]
        turn = obstacle.angle
    elif not isinstance(obstacle, Box) and "rock" in words:
        pieces = [_rock(obstacle)]
        turn = 0.0
    elif isinstance(obstacle, Box):
        shape = next((shape for word, shape in BOX_SHAPES if word in words), block)
        length, width = obstacle.size
        turn = obstacle.angle
        if width > length and shape in LONG_SIDE_ALONG_X:
            length, width, turn = width, length, turn + math.pi / 2
        pieces = shape(length, width, obstacle.height)
    else:
        shape = next((shape for word, shape in ROUND_SHAPES if word in words), column)
        pieces = shape(2 * obstacle.radius, 2 * obstacle.radius, obstacle.height)
        turn = 0.0
    return [(colour, mesh.moved(x, y, heading=turn)) for colour, mesh in pieces]


def _rock(obstacle: Cylinder) -> Piece:
    x, y = obstacle.position
    colour = palette.PALE_ROCK if math.sin(7 * x + 5 * y) > 0 else palette.ROCK
    return colour, rock(obstacle.radius, obstacle.height, (x, y))
