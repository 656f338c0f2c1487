"""What an adaptation may change, how far, and what it says of each joint."""

from dataclasses import dataclass
from typing import Any, Literal

from app.calibration.vocabulary import DriveParameters
from app.quantities import Document

Part = Literal["map", "dead_zones", "full"]
Status = Literal["applied", "shown", "refused", "unchanged"]

ALL_PARTS: tuple[Part, ...] = ("map", "dead_zones", "full")


@dataclass(frozen=True, slots=True)
class Limits:
    """How far a map may change so that a person can follow."""

    per_trial_deg: float = 2.0
    per_update_deg: float = 5.0
    least_evr: float = 0.8
    largest_angle_deg: float = 30.0  # from the calibration's direction
    cross_talk_slack: float = 0.01  # shares that differ by less do so by chance
    warn: float = 0.05  # felt change
    refuse: float = 0.10
    least_movement: float = 3.0  # s of the joint's own movement: less says nothing about its direction
    worth_it_deg: float = 0.5  # a smaller turn is chance, and no new version


STANDARD_LIMITS = Limits()


class JointChange(Document):
    """What would change for one joint; None where the movements said nothing."""

    name: str
    angle_proposed_deg: float | None = None  # between the map and the main direction of the movements
    angle_applied_deg: float = 0.0
    angle_from_calibration_deg: float = 0.0  # after the change
    evr_before: float | None = None  # share of the movements' variance along the map
    evr_after: float | None = None
    felt_change: float = 0.0
    cross_talk_before: float | None = None  # largest share of another joint's movement that this gesture answers to
    cross_talk_after: float | None = None
    dead_zone_before: float | None = None  # FS/s
    dead_zone_after: float | None = None
    full_before: float | None = None  # FS/s
    full_after: float | None = None
    range_moved: bool = False  # whether S5's range follows levels that the shirt's new seat has moved
    status: Status
    reason: str


class Proposal(Document):
    """What would be armed after the last trials, and why.

    `applied` of a joint means: in `parameters`. `shown`: the movements ask for a change, but its part is not to be
    adapted. `refused`: a gate is closed, and the figures after are those before;
    S5's range may follow the shirt all the same. Nothing here changes anything that drives.
    """

    trials: int
    joints: tuple[JointChange, ...]
    felt_change: float  # the largest of those applied
    warns: bool  # the person will feel it: 5 % or more
    parameters: DriveParameters | None  # None when nothing changes
    difference: dict[str, Any]  # to the parent, for its version
    reason: str  # in one sentence
