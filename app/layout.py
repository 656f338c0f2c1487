"""The shirt layout: the channels of a shirt, the joint of each, and its place on the body."""

from collections.abc import Mapping
from typing import Annotated, Final, Literal, Protocol, Self

from pydantic import Field, model_validator

from app.quantities import Document, Fraction, Line, Name, Title
from app.texts import Text

MAX_CHANNELS = 64
MAX_JOINTS = 16
Unit = Annotated[Line, Field(min_length=1, max_length=16)]
MIN_RING = 3  # sensors: two look alike when they change places
USUAL_JOINTS: Final[Mapping[str, tuple[Text, Text]]] = {
    "left_shoulder": (Text("joint-left-shoulder"), Text("joint-within-left-shoulder")),
    "right_shoulder": (Text("joint-right-shoulder"), Text("joint-within-right-shoulder")),
    "left_elbow": (Text("joint-left-elbow"), Text("joint-within-left-elbow")),
    "right_elbow": (Text("joint-right-elbow"), Text("joint-within-right-elbow")),
    "left_wrist": (Text("joint-left-wrist"), Text("joint-within-left-wrist")),
    "right_wrist": (Text("joint-right-wrist"), Text("joint-within-right-wrist")),
    "left_fingers": (Text("joint-left-fingers"), Text("joint-within-left-fingers")),
    "right_fingers": (Text("joint-right-fingers"), Text("joint-within-right-fingers")),
    "trunk": (Text("joint-trunk"), Text("joint-within-trunk")),
    "head": (Text("joint-head"), Text("joint-within-head")),
    "left_hip": (Text("joint-left-hip"), Text("joint-within-left-hip")),
    "right_hip": (Text("joint-right-hip"), Text("joint-within-right-hip")),
    "left_knee": (Text("joint-left-knee"), Text("joint-within-left-knee")),
    "right_knee": (Text("joint-right-knee"), Text("joint-within-right-knee")),
    "left_ankle": (Text("joint-left-ankle"), Text("joint-within-left-ankle")),
    "right_ankle": (Text("joint-right-ankle"), Text("joint-within-right-ankle")),
}
"""What people call joints that most shirts have: alone or at the beginning of a sentence, and within one."""


def is_missing(value: object) -> bool:
    """Return whether a field is not set."""
    return value is None


class Channel(Document):
    """One sensor signal; `position` is (x, y) in 0..1 of the body outline, x from its left, y from its top.

    Sensors of one joint that lie in a ring round the limb have the ring's name in `ring`, and in `place` where in the
    ring they are, counted round the limb. Without places, the ring is in the order of the layout.
    """

    name: Name
    joint: Name
    position: tuple[Fraction, Fraction] | None = None
    side: Literal["front", "back"] | None = None
    # Left out where they are not set, so that layouts from before keep their hash.
    ring: Name | None = Field(default=None, exclude_if=is_missing)
    place: Annotated[int, Field(strict=True, ge=0, lt=MAX_CHANNELS)] | None = Field(default=None, exclude_if=is_missing)
    unit: Unit | None = Field(default=None, exclude_if=is_missing)  # of its values, where the device says it
    # What shows that the sensor works. None: its value, which always changes a little. "arrival": that it sends; its
    # value may stay constant, because the driver makes it NaN as soon as nothing arrives (safety S5).
    liveness: Literal["arrival"] | None = Field(default=None, exclude_if=is_missing)


class Joint(Document):
    """A body part that is calibrated on its own."""

    name: Name
    label: Title


class NamedJoint(Protocol):
    """A joint with its name in documents and its label."""

    @property
    def name(self) -> str: ...  # noqa: D102
    @property
    def label(self) -> str: ...  # noqa: D102


def joint_title(joint: NamedJoint) -> Text | str:
    """Return what people call a joint, alone or at the beginning of a sentence: "Left elbow"."""
    return USUAL_JOINTS[joint.name][0] if _is_usual(joint) else joint.label


def joint_within(joint: NamedJoint) -> Text | str:
    """Return what people call a joint within a sentence: "left elbow"."""
    return USUAL_JOINTS[joint.name][1] if _is_usual(joint) else joint.label


def _is_usual(joint: NamedJoint) -> bool:
    """Return whether a joint has a name in each language, and its layout does not label it otherwise."""
    return joint.name in USUAL_JOINTS and joint.label.lower() == joint.name.replace("_", " ")


class ShirtLayout(Document):
    """The document that names and places a shirt's channels."""

    name: Title
    channels: Annotated[tuple[Channel, ...], Field(min_length=1, max_length=MAX_CHANNELS)]
    joints: Annotated[tuple[Joint, ...], Field(min_length=1, max_length=MAX_JOINTS)]

    @model_validator(mode="after")
    def _names_are_unique_and_known(self) -> Self:
        channels = [channel.name for channel in self.channels]
        joints = [joint.name for joint in self.joints]
        for message, names in (("layout-channel-twice", channels), ("layout-joint-twice", joints)):
            for name in names:
                if names.count(name) > 1:
                    raise ValueError(Text(message, name=name))
        for channel in self.channels:
            if channel.joint not in joints:
                text = Text("layout-no-joint", channel=channel.name, joint=channel.joint, joints=", ".join(joints))
                raise ValueError(text)
        for joint in joints:
            if not any(channel.joint == joint for channel in self.channels):
                raise ValueError(Text("layout-no-channel", joint=joint))
        return self

    @model_validator(mode="after")
    def _rings_are_whole(self) -> Self:
        for channel in self.channels:
            if channel.ring is None and channel.place is not None:
                raise ValueError(Text("layout-no-ring", channel=channel.name))
        for ring in {channel.ring for channel in self.channels} - {None}:
            members = [channel for channel in self.channels if channel.ring == ring]
            if len({channel.joint for channel in members}) > 1:
                raise ValueError(Text("layout-ring-of-several", ring=str(ring)))
            places = [channel.place for channel in members if channel.place is not None]
            if places and sorted(places) != list(range(len(members))):
                count = len(members)
                raise ValueError(Text("layout-ring-places", ring=str(ring), count=count, last=count - 1))
        return self

    @property
    def without_rings(self) -> "ShirtLayout":
        """The layout without its rings, which say how the shirt may sit and not which channel is which."""
        channels = tuple(channel.model_copy(update={"ring": None, "place": None}) for channel in self.channels)
        return self.model_copy(update={"channels": channels})

    @property
    def without_liveness(self) -> "ShirtLayout":
        """The layout of a shirt whose driver watches over no sensor: every value has to change (safety S5)."""
        if not any(self.may_stay_constant):
            return self
        channels = tuple(channel.model_copy(update={"liveness": None}) for channel in self.channels)
        return self.model_copy(update={"channels": channels})

    @property
    def channel_names(self) -> list[str]:
        """Names in the order of a frame's values."""
        return [channel.name for channel in self.channels]

    @property
    def may_stay_constant(self) -> list[bool]:
        """Whether the value of each channel may stay constant, in the order of a frame's values (safety S5)."""
        return [channel.liveness is not None for channel in self.channels]

    def fits(self, other: "ShirtLayout") -> bool:
        """Return whether a calibration in one of both layouts decodes, and watches over, the frames of the other."""
        return self.channel_names == other.channel_names and self.may_stay_constant == other.may_stay_constant

    @property
    def joint_names(self) -> list[str]:
        """Names in the order of a profile's joints."""
        return [joint.name for joint in self.joints]

    @property
    def joint_labels(self) -> dict[str, str]:
        """What the layout itself calls each joint, by name."""
        return {joint.name: joint.label for joint in self.joints}

    @property
    def joint_titles(self) -> Mapping[str, Text | str]:
        """What people call each joint, alone or at the beginning of a sentence, by name."""
        return {joint.name: joint_title(joint) for joint in self.joints}

    @property
    def joints_within(self) -> Mapping[str, Text | str]:
        """What people call each joint within a sentence, by name."""
        return {joint.name: joint_within(joint) for joint in self.joints}

    @property
    def channels_of_joint(self) -> Mapping[str, list[int]]:
        """Indices into a frame's values, per joint name."""
        return {
            joint.name: [i for i, channel in enumerate(self.channels) if channel.joint == joint.name]
            for joint in self.joints
        }

    @property
    def rings(self) -> Mapping[str, list[int]]:
        """Indices into a frame's values, per ring of at least MIN_RING sensors, in their order round the limb."""
        members: dict[str, list[int]] = {}
        for i, channel in enumerate(self.channels):
            if channel.ring is not None:
                members.setdefault(channel.ring, []).append(i)
        return {
            ring: sorted(indices, key=lambda i: self.channels[i].place or 0)
            for ring, indices in members.items()
            if len(indices) >= MIN_RING
        }
