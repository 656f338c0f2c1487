"""The scale of a 3D object: glTF is in metres, but many files are written in other units without saying so."""

from typing import Final

from app.refusals import Refusal
from app.scene.meshes.bodies import Vector
from app.texts import Text

PROBABLE: Final = (0.1, 10.0)  # m, the longest side of a thing in a building
# m that one unit of a file may be: mm, cm, inch, foot; the last two undo a division by 100 or 1000 that was made twice.
SCALES: Final = (0.001, 0.01, 0.0254, 0.3048, 100.0, 1000.0)


class ScaleAsked(Refusal):
    """The size of an object is improbable in metres: a person chooses how many metres one of its units is."""

    def __init__(self, name: str, size: Vector) -> None:
        length, width, height = (float(f"{side:.3g}") for side in size)
        super().__init__(Text("object-improbable", file=name, length=length, width=width, height=height))
        self.scales = {scale: scaled(size, scale) for scale in SCALES if is_probable(scaled(size, scale))} | {1.0: size}


def is_probable(size: Vector) -> bool:
    """Return whether a thing of this size (m) may stand in a building."""
    return PROBABLE[0] <= round(max(size), 6) <= PROBABLE[1]


def scaled(size: Vector, scale: float) -> Vector:
    """Return a size times a scale."""
    length, width, height = size
    return length * scale, width * scale, height * scale
