"""Gestures, their bindings to controls, and the parameter set that drives."""

import hashlib
import json
import math
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from app.calibration.profile import CalibrationProfile
from app.messages import MAX_GESTURES
from app.quantities import Cutoff, Document, Name, Threshold
from app.signals.low_pass import STANDARD_CUTOFF
from app.speed_limits import Speeds
from app.texts import Text

Control = Literal["u1+", "u1-", "u2+", "u2-", "stop"]
Feature = Literal["rate", "displacement"]
ControlMode = Literal["velocity", "acceleration"]

Gain = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=5)]
CruiseTime = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=1, le=30)]  # s
SetTitle = Annotated[
    str, Field(min_length=1, max_length=80)
]  # visible characters are checked on input only: older sets stay readable
TurnCruiseTime = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=1, le=10)]  # s


class Gesture(Document):
    """A movement that a person can repeat at will: one joint, one direction, one feature.

    `dead_zone` and `full` are in FS/s for the feature `rate`, in FS for `displacement`.
    """

    name: Name
    joint: Name
    direction: Literal[1, -1] = 1
    feature: Feature = "rate"
    dead_zone: Threshold
    full: Threshold

    @model_validator(mode="after")
    def _full_is_above_dead_zone(self) -> Self:
        if self.full < self.dead_zone + 0.01:
            # Rounded apart, so that the two numbers are never written alike.
            full, least = math.floor(100 * self.full), math.ceil(round(100 * self.dead_zone + 1, 6))
            raise ValueError(Text("calibration-full-too-low", gesture=self.name, full=full, least=least))
        return self


class Binding(Document):
    """What gestures control. For `stop`, all of the named gestures together; otherwise each on its own."""

    control: Control
    gestures: Annotated[tuple[Name, ...], Field(max_length=MAX_GESTURES)]
    gain: Gain = 1.0


class DriveParameters(Document):
    """All parameters that turn a body's movement into a twist; the same set is used to practise and to drive."""

    title: SetTitle = "Standard"
    profile: CalibrationProfile
    gestures: Annotated[tuple[Gesture, ...], Field(min_length=1, max_length=MAX_GESTURES)]
    bindings: Annotated[tuple[Binding, ...], Field(max_length=16)]
    mode_u1: ControlMode = "acceleration"
    mode_u2: ControlMode = "velocity"
    cutoff: Cutoff = STANDARD_CUTOFF  # Hz
    speeds: Speeds = Speeds()
    cruise_time: CruiseTime = 10.0  # s without a gesture for u1, after which a cruising chair slows to standstill
    turn_cruise_time: TurnCruiseTime = 3.0  # s: the time-out of turning

    @property
    def keeps_speed(self) -> bool:
        """Whether a chair goes on by itself, forward or turning, while the body is at rest."""
        return "acceleration" in (self.mode_u1, self.mode_u2)

    @model_validator(mode="after")
    def _names_fit_together(self) -> Self:
        names = [gesture.name for gesture in self.gestures]
        joints = [joint.name for joint in self.profile.joints]
        for gesture in self.gestures:
            if names.count(gesture.name) > 1:
                raise ValueError(Text("calibration-gesture-twice", gesture=gesture.name))
            if gesture.joint not in joints:
                known = ", ".join(joints)
                raise ValueError(
                    Text("calibration-gesture-joint", gesture=gesture.name, joint=gesture.joint, joints=known)
                )
        for binding in self.bindings:
            for name in binding.gestures:
                if name not in names:
                    known = ", ".join(names)
                    raise ValueError(Text("calibration-binding", control=binding.control, gesture=name, gestures=known))
        return self

    @property
    def bound_gestures(self) -> list[int]:
        """Indices of the gestures that are bound to a control."""
        bound = {name for binding in self.bindings for name in binding.gestures}
        return [index for index, gesture in enumerate(self.gestures) if gesture.name in bound]

    @property
    def hash(self) -> str:
        """SHA-256 of the canonical JSON, hex: sets with equal hashes drive alike."""
        canonical = json.dumps(self.model_dump(mode="json"), sort_keys=True, separators=(",", ":"))
        return hashlib.sha256(canonical.encode()).hexdigest()


def arming_hash(parameters_hash: str, chair_document: str) -> str:
    """Return the hash with which a chair is armed: of the parameter set, and of the chair's document where it has one.

    Without a chair document it is that of the set, by which practice on the virtual chair is compared.

    Parameters
    ----------
    parameters_hash : str
        `DriveParameters.hash`.
    chair_document : str
        The hexadecimal digits of the chair document as the chair tells them; empty: it has none.
    """
    if not chair_document:
        return parameters_hash
    return hashlib.sha256(bytes.fromhex(parameters_hash) + bytes.fromhex(chair_document)).hexdigest()


# The paper's vocabulary: joint -> control, for shirts with these joints.
PAPER_VOCABULARY: dict[str, Control] = {
    "right_elbow": "u1+",
    "left_elbow": "u1-",
    "right_shoulder": "u2+",
    "left_shoulder": "u2-",
}
STOP_TOGETHER = ("right_elbow", "left_elbow")

# Without the elbows: for a camera before somebody who moves shoulders, trunk and head.
UPRIGHT_VOCABULARY: dict[str, Control] = {
    "trunk": "u1+",
    "head": "u1-",
    "right_shoulder": "u2+",
    "left_shoulder": "u2-",
}


def standard_parameters(profile: CalibrationProfile) -> DriveParameters:
    """Return the standard vocabulary on `profile`, with the dead-zones and fulls that the calibration suggests.

    It is that of the paper, or the one of trunk, head and shoulders where these four were prompted and neither elbow
    was, or where these four have a direction and neither elbow has. A joint whose direction is not known is not bound,
    unless no joint's direction is: without prompts, only other people's maps have one.
    """
    gestures = tuple(
        Gesture(name=joint.name, joint=joint.name, dead_zone=joint.thresholds[0], full=joint.thresholds[1])
        for joint in profile.joints
    )
    directed = [joint.name for joint in profile.joints if joint.has_direction]
    names = directed or [gesture.name for gesture in gestures]
    prompted = [joint.name for joint in profile.joints if joint.prompted]
    is_upright = any(
        UPRIGHT_VOCABULARY.keys() <= set(known) and not any(name in known for name in STOP_TOGETHER)
        for known in (prompted, directed)
    )
    vocabulary = UPRIGHT_VOCABULARY if is_upright else PAPER_VOCABULARY
    bindings = [Binding(control=control, gestures=(name,)) for name, control in vocabulary.items() if name in names]
    if not is_upright and all(name in names for name in STOP_TOGETHER):
        bindings.append(Binding(control="stop", gestures=STOP_TOGETHER))
    return DriveParameters(profile=profile, gestures=gestures, bindings=tuple(bindings))
