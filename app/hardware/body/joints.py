"""The degrees of freedom of a body, named after the joints of the shirt."""

from collections.abc import Sequence

SECOND_WAYS = {"shoulder": "up"}
"""Joints with a second degree of freedom that is no gesture: a shoulder also moves up and down."""

ARM_JOINTS = ("right_shoulder", "left_shoulder", "right_elbow", "left_elbow", "right_wrist", "left_wrist")


def second_way(joint: str) -> str | None:
    """Return the name of a joint's second degree of freedom, None when it has only one."""
    part = joint.rpartition("_")[2]
    return f"{joint}_{SECOND_WAYS[part]}" if part in SECOND_WAYS else None


def degrees_of_freedom(joints: Sequence[str]) -> tuple[str, ...]:
    """Return the names of all degrees of freedom of `joints`: each joint, followed by its second one."""
    return tuple(name for joint in joints for name in (joint, second_way(joint)) if name is not None)


ARM_DEGREES_OF_FREEDOM = degrees_of_freedom(ARM_JOINTS)
