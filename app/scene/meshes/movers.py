"""The meshes of movers: a person on foot, a person in a chair, a ball; x ahead, the origin on the floor."""

from typing import Final

from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, Part, Vector, ball, limb, merged, tube
from app.scene.meshes.palette import Colour
from app.scene.meshes.wheelchair import chair_parts, person_parts
from app.world.movers import Mover

HALF_WIDTH: Final = 0.3  # m, of the person as drawn here


def mover_parts(mover: Mover) -> list[Part]:
    """Return the body of a mover, one part for each colour."""
    match mover.kind:
        case "chair":
            meshes = merge_colours([chair_parts(), _other_clothes(person_parts())])
        case "person":
            meshes = _walker(mover.radius / HALF_WIDTH)
        case "ball":
            meshes = _ball(mover.radius)
    return [Part(mesh, colour) for colour, mesh in sorted(meshes.items())]


def merge_colours(bodies: list[dict[Colour, Mesh]]) -> dict[Colour, Mesh]:
    """Merge the meshes of several bodies into one for each colour."""
    colours = {colour for body in bodies for colour in body}
    return {colour: merged(body[colour] for body in bodies if colour in body) for colour in colours}


def _other_clothes(person: dict[Colour, Mesh]) -> dict[Colour, Mesh]:
    return {palette.JACKET if colour == palette.SHIRT else colour: mesh for colour, mesh in person.items()}


def _walker(width: float) -> dict[Colour, Mesh]:
    """Return a person in the middle of a step, 1.75 m tall and `width` times as broad as usual."""
    return {
        palette.JACKET: merged(
            [
                ball((0.0, 0.0, 1.17), (0.13, 0.2 * width, 0.34)),
                *(limb(_arm(side, width), 0.05) for side in (-1, 1)),
            ]
        ),
        palette.TROUSERS: merged(
            [ball((0.0, 0.0, 0.93), (0.12, 0.165 * width, 0.14)), *(limb(_leg(side), 0.075) for side in (-1, 1))]
        ),
        palette.SKIN: merged(
            [
                ball((0.02, 0.0, 1.62), (0.1, 0.08, 0.12)),
                tube((0.0, 0.0, 1.42), (0.01, 0.0, 1.54), 0.05),
                *(ball(_arm(side, width)[2], 0.048, 12) for side in (-1, 1)),
            ]
        ),
        palette.HAIR: ball((-0.005, 0.0, 1.655), (0.105, 0.088, 0.105)),
        palette.DARK: merged(
            [ball((_leg(side)[2][0] + 0.05, side * 0.09, 0.045), (0.13, 0.05, 0.045)) for side in (-1, 1)]
        ),
    }


def _arm(side: int, width: float) -> list[Vector]:
    return [
        (0.0, side * 0.2 * width, 1.4),
        (-0.04 * side, side * 0.27 * width, 1.14),
        (0.06 - 0.14 * side, side * 0.26 * width, 0.92),
    ]


def _leg(side: int) -> list[Vector]:
    return [(0.0, side * 0.09, 0.9), (0.06 + 0.06 * side, side * 0.09, 0.5), (0.2 * side - 0.02, side * 0.09, 0.1)]


def _ball(radius: float) -> dict[Colour, Mesh]:
    band = tube((0.0, 0.0, 0.84 * radius), (0.0, 0.0, 1.16 * radius), 1.005 * radius, sides=32)
    return {palette.JACKET: ball((0.0, 0.0, radius), radius, 24), palette.CERAMIC: band}
