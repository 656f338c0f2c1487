"""The proposal of an adaptation as a document: the change of each joint, and the reasons."""

from typing import Literal

from app.calibration.vocabulary import DriveParameters
from app.json_values import JsonDocument
from app.quantities import Document
from app.stored_text import StoredText

Status = Literal["applied", "refused", "unchanged"]


class JointChange(Document):
    """The proposed change of one joint; None where the movements were too few to compute a value."""

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
    range_moved: bool = False  # whether the range that S5 checks was shifted to the shirt's present levels
    status: Status
    reason: StoredText


class Proposal(Document):
    """The parameter set proposed after the last trials, with the reasons; what drives now is not changed by it.

    Status of a joint: `applied`, its change is in `parameters`; `refused`, its map loses something, but a limit forbids
    the change, and the values after are those before; `unchanged`, nothing is lost.
    """

    trials: int
    joints: tuple[JointChange, ...]
    felt_change: float  # the largest of those applied
    warns: bool  # whether the felt change is 5 % or more
    parameters: DriveParameters | None  # None when nothing changes
    difference: JsonDocument  # from the parent version, kept with the new version
    reason: StoredText
