"""The first layout of a file of signals, which the computing process makes: to read a file loads a large library."""

from pathlib import Path
from typing import Final, NamedTuple

from app.channel_names import different_names, joint_in_name, plain_channel_name
from app.features.layouts.joint_groups import JointGroups, joint_groups
from app.layout import MAX_JOINTS, Channel, Joint, ShirtLayout
from app.signals.column_names import bare_names

WHOLE: Final = "body"  # the joint of all channels, where their names say no joints


class FileDraft(NamedTuple):
    """A layout to begin with, and what the signals say of its joints."""

    layout: ShirtLayout
    groups: JointGroups | None  # channels that move together; None: the names of the columns say the joints


def draft_of_file(file: Path) -> FileDraft:
    """Return the layout of the channels of a file of signals, in its order, and where needed those that move together.

    A channel has the name of its column as far as a layout takes it. Its joint is that name without the number or axis
    at its end, where all names have one and they give at least two joints. Otherwise all are of the joint WHOLE.

    Raises
    ------
    ValueError
        One sentence when the file cannot be read.
    """
    from app.signals.signals import read_signals  # noqa: PLC0415  (loads pyarrow)

    signals = read_signals(file)
    labels = [
        plain_channel_name(name) or f"channel_{number}"
        for number, (name, _) in enumerate(bare_names(signals.channel_names), 1)
    ]
    joints = [joint_in_name(label) for label in labels]
    is_numbered = all(joint != label for joint, label in zip(joints, labels, strict=True))
    has_joints = is_numbered and 2 <= len(set(joints)) <= MAX_JOINTS
    if not has_joints:
        joints = [WHOLE] * len(labels)
    layout = ShirtLayout(
        name=plain_channel_name(file.stem) or WHOLE,
        channels=tuple(
            Channel(name=name, joint=joint) for name, joint in zip(different_names(labels), joints, strict=True)
        ),
        joints=tuple(Joint(name=joint, label=joint.replace("_", " ").capitalize()) for joint in dict.fromkeys(joints)),
    )
    return FileDraft(layout, None if has_joints else joint_groups(signals.values, signals.sample_rate))
