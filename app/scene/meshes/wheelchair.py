"""The meshes of the chair and of the person in it; x ahead, the origin on the floor between the drive wheels."""

from typing import Final

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, Vector, ball, limb, merged, standing_box, tube, wheel
from app.scene.meshes.palette import Colour
from app.world.footprint import CHAIR_RADIUS

DRIVE_WHEEL: Final = 0.17  # m, radius
CASTOR: Final = 0.085
HALF_WIDTH: Final = CHAIR_RADIUS - 0.03  # m, to the middle of a drive wheel, whose tyre ends at the footprint's edge
SEAT: Final = 0.5  # m, height of the cushion's top


def chair_parts() -> dict[Colour, Mesh]:
    """Return the powered chair, one mesh for each colour."""
    return {
        palette.TYRE: merged(
            [
                *(wheel((0.0, side * HALF_WIDTH, DRIVE_WHEEL), DRIVE_WHEEL, 0.07, 0.075) for side in (-1, 1)),
                *(wheel((0.4, side * 0.22, CASTOR), CASTOR, 0.045, 0.05) for side in (-1, 1)),
                *(wheel((-0.34, side * 0.2, CASTOR), CASTOR, 0.045, 0.05) for side in (-1, 1)),
            ]
        ),
        palette.METAL: merged(
            [
                *(_hub(0.0, side * HALF_WIDTH, DRIVE_WHEEL, 0.11, 0.05) for side in (-1, 1)),
                *(_hub(x, side * y, CASTOR, 0.045, 0.03) for x, y in ((0.4, 0.22), (-0.34, 0.2)) for side in (-1, 1)),
                *(
                    limb([(0.3, side * 0.2, 0.3), (0.42, side * 0.2, 0.3), (0.42, side * 0.22, 0.18)], 0.018, 8)
                    for side in (-1, 1)
                ),
                *(
                    limb([(0.24, side * 0.13, 0.42), (0.46, side * 0.12, 0.36), (0.56, side * 0.11, 0.14)], 0.016, 8)
                    for side in (-1, 1)
                ),
                *(limb([(-0.22, side * 0.2, 0.4), (-0.34, side * 0.2, 0.22)], 0.018, 8) for side in (-1, 1)),
                *(tube((-0.1, side * 0.26, 0.42), (-0.1, side * 0.26, 0.7), 0.014) for side in (-1, 1)),
                *(limb([(-0.27, side * 0.19, 0.9), (-0.4, side * 0.19, 0.93)], 0.014, 8) for side in (-1, 1)),
            ]
        ),
        palette.FRAME: merged(
            [
                standing_box(0.52, 0.4, 0.2, 0.36, x=-0.02),
                standing_box(0.24, 0.36, 0.24, 0.4, x=-0.26),
                standing_box(0.5, 0.44, 0.395, 0.43, x=0.0),
                *(_mudguard(side) for side in (-1, 1)),
            ]
        ),
        palette.CUSHION: merged(
            [
                standing_box(0.46, 0.42, 0.43, SEAT, x=0.02),
                standing_box(0.07, 0.42, 0.0, 0.52).tilted(-0.12).moved(x=-0.22, z=0.46),
                standing_box(0.06, 0.24, 0.0, 0.14).tilted(-0.12).moved(x=-0.3, z=1.06),
                *(standing_box(0.34, 0.07, 0.7, 0.745, x=0.03, y=side * 0.26) for side in (-1, 1)),
                *(standing_box(0.16, 0.13, 0.1, 0.125, x=0.6, y=side * 0.1) for side in (-1, 1)),
                standing_box(0.09, 0.06, 0.745, 0.785, x=0.2, y=-0.26),
                tube((0.21, -0.26, 0.785), (0.21, -0.26, 0.84), 0.012),
            ]
        ),
    }


def person_parts() -> dict[Colour, Mesh]:
    """Return a person who sits in the chair, arms on the rests, wearing the shirt."""
    return {
        palette.SHIRT: merged(
            [
                ball((-0.11, 0.0, 0.8), (0.13, 0.185, 0.32)),
                *(limb(_arm(side)[:2], 0.055) for side in (-1, 1)),
                *(limb(_arm(side)[1:], 0.043) for side in (-1, 1)),
            ]
        ),
        palette.SKIN: merged(
            [
                ball((-0.09, 0.0, 1.27), (0.095, 0.08, 0.115)),
                tube((-0.1, 0.0, 1.05), (-0.095, 0.0, 1.2), 0.05),
                *(ball((0.2, side * 0.255, 0.775), (0.06, 0.04, 0.03), 12) for side in (-1, 1)),
            ]
        ),
        palette.HAIR: ball((-0.11, 0.0, 1.3), (0.1, 0.088, 0.105)),
        palette.TROUSERS: merged([limb(_leg(side), 0.072) for side in (-1, 1)]),
        palette.DARK: merged([ball((0.63, side * 0.1, 0.165), (0.12, 0.048, 0.045), 14) for side in (-1, 1)]),
    }


def _arm(side: int) -> list[Vector]:
    return [(-0.12, side * 0.2, 1.0), (-0.06, side * 0.27, 0.79), (0.15, side * 0.255, 0.775)]


def _leg(side: int) -> list[Vector]:
    return [(-0.1, side * 0.1, 0.57), (0.42, side * 0.11, 0.57), (0.55, side * 0.1, 0.2)]


def _hub(x: float, y: float, z: float, radius: float, width: float) -> Mesh:
    return tube((x, y - width / 2, z), (x, y + width / 2, z), radius)


def _mudguard(side: int) -> Mesh:
    return standing_box(0.3, 0.035, 0.36, 0.4, y=side * 0.235)
