"""Soft cones: they stand until the chair touches them, and then lie on their side until the next trial."""

import math
from typing import Final

from app.geometry import Pose
from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, Part, merged, standing_box, tube
from app.world.kinematics import CHAIR_RADIUS
from app.world.scenery import Cone

TIP: Final = 0.14  # of the radius
BODY: Final = 0.78
PLATE: Final = 0.68  # half side, of the radius: its corners stay inside the circle
PLATE_HEIGHT: Final = 0.03  # m
BAND: Final = (0.45, 0.7)  # of the height
PROUD: Final = 1.04  # of the band's radius over the cone's


class Cones:
    """The cones of a plan and which of them lie."""

    def __init__(self, cones: tuple[Cone, ...]) -> None:
        self._cones = cones
        self._fell: dict[int, float] = {}  # the number of a cone that lies, and the direction (rad) in which it fell
        self._parts: dict[str, Part] | None = None

    @property
    def lying(self) -> int:
        """Return how many were touched."""
        return len(self._fell)

    def touch(self, pose: Pose) -> None:
        """Let the chair be there."""
        for number, cone in enumerate(self._cones):
            x, y = cone.position[0] - pose.x, cone.position[1] - pose.y
            if number not in self._fell and math.hypot(x, y) < CHAIR_RADIUS + cone.radius:
                self._fell[number] = math.atan2(y, x)
                self._parts = None

    def stand_up(self) -> None:
        """Put them all up again."""
        if self._fell:
            self._fell.clear()
            self._parts = None

    def parts(self) -> dict[str, Part]:
        """Return all cones as they stand or lie: the same object until that changes."""
        if self._parts is None:
            self._parts = self._drawn() if self._cones else {}
        return self._parts

    def _drawn(self) -> dict[str, Part]:
        bodies, bands = [], []
        for number, cone in enumerate(self._cones):
            fell = self._fell.get(number)
            bodies.append(_placed(_body(cone), cone, fell))
            bands.append(_placed(_band(cone), cone, fell))
        return {"cones": Part(merged(bodies), palette.CONE), "cone_bands": Part(merged(bands), palette.CERAMIC)}


def _body(cone: Cone) -> Mesh:
    side = 2 * PLATE * cone.radius
    plate = min(PLATE_HEIGHT, cone.height / 4)
    return merged(
        [
            standing_box(side, side, 0.0, plate),
            tube((0.0, 0.0, plate), (0.0, 0.0, cone.height), _radius(cone, plate), _radius(cone, cone.height)),
        ]
    )


def _band(cone: Cone) -> Mesh:
    low, high = (share * cone.height for share in BAND)
    return tube((0.0, 0.0, low), (0.0, 0.0, high), PROUD * _radius(cone, low), PROUD * _radius(cone, high))


def _radius(cone: Cone, height: float) -> float:
    return cone.radius * (BODY + (TIP - BODY) * height / cone.height)


def _placed(mesh: Mesh, cone: Cone, fell: float | None) -> Mesh:
    if fell is None:
        return mesh.moved(*cone.position)
    # It rests on the edge of its plate and on its tip.
    lean = math.pi / 2 + math.atan2((PLATE - TIP) * cone.radius, cone.height)
    return mesh.tilted(lean).moved(z=PLATE * cone.radius).moved(*cone.position, heading=fell)
