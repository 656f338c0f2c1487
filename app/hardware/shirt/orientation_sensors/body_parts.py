"""The parts of the body that wear a sensor of their own: the joint that each moves, its place, its neighbour."""

from collections.abc import Collection, Iterable, Mapping
from typing import Final, Literal, NamedTuple

from app.layout import Channel, Joint, ShirtLayout
from app.texts import Text

CHAIR: Final = "chair"
TRUNK: Final = "trunk"
BASES: Final = (TRUNK, CHAIR)
"""What the other parts are measured from: the trunk, and without a sensor there the chair."""


class BodyPart(NamedTuple):
    """A part of the body, or the chair, that carries a sensor."""

    joint: str | None  # that moves it; None: its movements are no signals
    towards: str | None  # the next part towards the chair
    position: tuple[float, float] | None  # of the sensor on the outline of a layout; None: not on that outline


PARTS: Final[Mapping[str, BodyPart]] = {
    CHAIR: BodyPart(None, None, None),
    TRUNK: BodyPart("trunk", CHAIR, (0.5, 0.42)),
    "head": BodyPart("head", TRUNK, (0.5, 0.1)),
    "right_upper_arm": BodyPart("right_shoulder", TRUNK, (0.22, 0.36)),
    "left_upper_arm": BodyPart("left_shoulder", TRUNK, (0.78, 0.36)),
    "right_forearm": BodyPart("right_elbow", "right_upper_arm", (0.15, 0.56)),
    "left_forearm": BodyPart("left_elbow", "left_upper_arm", (0.85, 0.56)),
    "right_hand": BodyPart("right_wrist", "right_forearm", (0.09, 0.74)),
    "left_hand": BodyPart("left_wrist", "left_forearm", (0.91, 0.74)),
    "right_fingers": BodyPart("right_fingers", "right_hand", (0.07, 0.84)),
    "left_fingers": BodyPart("left_fingers", "left_hand", (0.93, 0.84)),
    "right_thigh": BodyPart("right_hip", TRUNK, (0.4, 0.95)),
    "left_thigh": BodyPart("left_hip", TRUNK, (0.6, 0.95)),
    "right_lower_leg": BodyPart("right_knee", "right_thigh", None),
    "left_lower_leg": BodyPart("left_knee", "left_thigh", None),
    "right_foot": BodyPart("right_ankle", "right_lower_leg", None),
    "left_foot": BodyPart("left_ankle", "left_lower_leg", None),
}
BESIDE: Final = 0.035  # of the outline's width, between the three signals of one sensor


def part_title(part: str) -> Text:
    """Return what people call a part, within a sentence."""
    return Text(f"shirtdev-part-{part.replace('_', '-')}")


def reference_of(part: str, worn: Collection[str], from_neighbour: bool) -> str | None:
    """Return the part whose sensor `part` is measured from; None: the room, as no part towards the chair has one.

    Parameters
    ----------
    part : str
        A name of PARTS.
    worn : names of PARTS
        The parts that wear a sensor of their orientation.
    from_neighbour : bool
        Whether a limb is measured from the next sensor towards the trunk, in place of the trunk's own.
    """
    other = PARTS[part].towards
    while other is not None and not (other in worn and (from_neighbour or other in BASES)):
        other = PARTS[other].towards
    return other


def channel_names(part: str, bends: Collection[str]) -> list[str]:
    """Return the names of the channels of a part: of a strain sensor one, else of a rotation vector three."""
    joint = PARTS[part].joint
    return [] if joint is None else [f"{joint}_{number}" for number in range(1, 2 if part in bends else 4)]


def layout_of(name: str, parts: Iterable[str], bends: Collection[str] = ()) -> ShirtLayout:
    """Return the layout of sensors on `parts`, in the order of PARTS; those in `bends` are strain sensors.

    At least one of the parts has a joint. Orientations may stay constant: trackers and browsers leave out what has not
    changed, so that a sensor shows by what it sends that it works.
    """
    worn = [part for part in PARTS if part in parts and PARTS[part].joint is not None]
    channels = []
    for part in worn:
        joint, _, position = PARTS[part]
        names = channel_names(part, bends)
        is_turned = part not in bends
        for number, channel in enumerate(names):
            beside = BESIDE * (number - (len(names) - 1) / 2)
            place = None if position is None else (position[0] + beside, position[1])
            side: Literal["front"] | None = None if position is None else "front"
            channels.append(
                Channel(
                    name=channel,
                    joint=str(joint),
                    position=place,
                    side=side,
                    unit="rad" if is_turned else None,
                    liveness="arrival" if is_turned else None,
                )
            )
    joints = [str(PARTS[part].joint) for part in worn]
    return ShirtLayout(
        name=name,
        channels=tuple(channels),
        joints=tuple(Joint(name=joint, label=joint.replace("_", " ").capitalize()) for joint in joints),
    )
