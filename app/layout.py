"""The shirt layout: the channels of a shirt, the joint of each, and its place on the body."""

from collections.abc import Mapping
from typing import Annotated, Literal, Self

from pydantic import Field, model_validator

from app.quantities import Document, Fraction, Name, Title

MAX_CHANNELS = 64
MAX_JOINTS = 16


class Channel(Document):
    """One sensor signal; `position` is (x, y) in 0..1 of the body outline, x from its left, y from its top."""

    name: Name
    joint: Name
    position: tuple[Fraction, Fraction] | None = None
    side: Literal["front", "back"] | None = None


class Joint(Document):
    """A body part that is calibrated on its own."""

    name: Name
    label: Title


class ShirtLayout(Document):
    """The document that names and places a shirt's channels."""

    name: Title
    channels: Annotated[tuple[Channel, ...], Field(min_length=1, max_length=MAX_CHANNELS)]
    joints: Annotated[tuple[Joint, ...], Field(min_length=1, max_length=MAX_JOINTS)]

    @model_validator(mode="after")
    def _names_are_unique_and_known(self) -> Self:
        channels = [channel.name for channel in self.channels]
        joints = [joint.name for joint in self.joints]
        for what, names in (("channel", channels), ("joint", joints)):
            for name in names:
                if names.count(name) > 1:
                    raise ValueError(f"{what} '{name}' stands there twice: give each its own name")
        for channel in self.channels:
            if channel.joint not in joints:
                raise ValueError(
                    f"channel '{channel.name}' names joint '{channel.joint}', which is not among the joints: "
                    f"add it or use one of {', '.join(joints)}"
                )
        for joint in joints:
            if not any(channel.joint == joint for channel in self.channels):
                raise ValueError(f"joint '{joint}' has no channel: give it one or leave it out")
        return self

    @property
    def channel_names(self) -> list[str]:
        """Names in the order of a frame's values."""
        return [channel.name for channel in self.channels]

    @property
    def joint_names(self) -> list[str]:
        """Names in the order of a profile's joints."""
        return [joint.name for joint in self.joints]

    @property
    def channels_of_joint(self) -> Mapping[str, list[int]]:
        """Indices into a frame's values, per joint name."""
        return {
            joint.name: [i for i, channel in enumerate(self.channels) if channel.joint == joint.name]
            for joint in self.joints
        }
