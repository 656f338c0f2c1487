"""Limits of speed, acceleration and jerk: of a parameter set, a clinic or a chair."""

from typing import Annotated

from pydantic import Field

from app.quantities import Document
from app.speed_ceiling import HIGHEST_SPEED, HIGHEST_TURN_RATE

Speed = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=HIGHEST_SPEED)]  # m/s
TurnRate = Annotated[float, Field(strict=True, allow_inf_nan=False, gt=0, le=HIGHEST_TURN_RATE)]  # rad/s
Acceleration = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.1, le=3.0)]  # m/s2
TurnAcceleration = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.1, le=20.0)]  # rad/s2
Jerk = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.5, le=20.0)]  # m/s3
TurnJerk = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=1.0, le=400.0)]  # rad/s3


class Speeds(Document):
    """Limits of speeds, accelerations and jerks, named as in wheelchair programming."""

    forward: Speed = 0.8  # m/s
    reverse: Speed = 0.3  # m/s
    turn: TurnRate = 1.2  # rad/s
    acceleration: Acceleration = 0.8  # m/s2, also A_f of the acceleration mode
    deceleration: Acceleration = 1.2  # m/s2
    turn_acceleration: TurnAcceleration = 6.0  # rad/s2
    jerk: Jerk = 8.0  # m/s3: full acceleration after 0.1 s, which is felt as soft and not as late
    turn_jerk: TurnJerk = 60.0  # rad/s3


HIGHEST_SPEEDS = Speeds(**{name: limit["maximum"] for name, limit in Speeds.model_json_schema()["properties"].items()})
"""The highest limits that a clinic or a chair can have."""


FIRST_CHAIR_SPEEDS = Speeds(forward=0.5, turn=0.8, acceleration=0.6, turn_acceleration=4.0)
"""Limits that are proposed for a chair that nobody here has driven yet: an indoor walking pace."""


def most_restrictive(*levels: Speeds) -> Speeds:
    """Return the smallest value of each limit over several levels of limits."""
    return Speeds(**{name: min(getattr(level, name) for level in levels) for name in Speeds.model_fields})


DIAL_FIELDS = ("forward", "reverse", "turn")


def apply_dial(speeds: Speeds, share: float) -> Speeds:
    """Return the limits with forward, reverse and turn speed multiplied by the speed dial's `share` (0.1 to 1)."""
    return speeds.model_copy(update={name: share * getattr(speeds, name) for name in DIAL_FIELDS})
