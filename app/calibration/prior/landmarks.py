"""Where the front and the outer side of a limb lie in a ring of sensors, so that a picture of it can be followed."""

import cmath
import math
from collections.abc import Sequence
from typing import NamedTuple

from app.layout import ShirtLayout

LEAST_DIFFERENCE = 0.1  # of the largest possible one: with less, the sensors of both sides are mixed
MIDDLE = 0.5  # of the body outline, from its left


class Landmarks(NamedTuple):
    """Places in a ring, 0 to the number of its sensors, also between two of them; None where the layout cannot tell."""

    front: float | None
    outside: float | None  # the side away from the middle of the body


def landmarks(layout: ShirtLayout, ring: str) -> Landmarks:
    """Return where a ring has its front and its outer side, from `side` and `position` of its channels."""
    channels = [layout.channels[i] for i in layout.rings[ring]]
    fronts = [channel.side == "front" for channel in channels if channel.side is not None]
    outward = [abs(channel.position[0] - MIDDLE) for channel in channels if channel.position is not None]
    return Landmarks(_direction(fronts, len(channels)), _direction(outward, len(channels)))


def _direction(values: Sequence[float], count: int) -> float | None:
    """Return the place towards which the values of a ring's `count` sensors are largest; None without a value each."""
    if len(values) != count or max(values) == min(values):
        return None
    mean, half = sum(values) / count, (max(values) - min(values)) / 2.0
    step = 2j * math.pi / count
    pointer = sum((value - mean) / half * cmath.exp(step * place) for place, value in enumerate(values)) / count
    if abs(pointer) < LEAST_DIFFERENCE:
        return None
    return round(cmath.phase(pointer) / (2.0 * math.pi) * count, 3) % count
