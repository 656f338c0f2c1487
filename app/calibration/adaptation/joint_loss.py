"""The loss of a joint's present map, to which a proposal reacts; `app/scoring/map_losses` measures it."""

from typing import NamedTuple

from app.texts import Text


class JointLoss(NamedTuple):
    """What has to change in the map of one joint, and why."""

    message: Text  # sentences that say what is lost
    dead_zone: float | None = None  # FS/s that the noise at rest asks for; None: the dead-zone stays
    growth: float | None = None  # ln of the strokes' size over that of the first trials; None: full stays
    turns: bool = False  # whether the direction of the map sees too little of the movement
    silenced: bool = False  # whether safety rule S5 silenced the gesture, so that the range has to follow the shirt
