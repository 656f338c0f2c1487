"""A small real calibration profile: two joints, one channel each."""

from app.calibration.profile import CalibrationProfile
from app.layout import Channel, Joint, ShirtLayout
from building import joint_map, profile_of


def small_profile(joints: tuple[str, ...] = ("right_elbow", "left_elbow")) -> CalibrationProfile:
    layout = ShirtLayout(
        name="Small",
        channels=tuple(Channel(name=f"{joint}_1", joint=joint) for joint in joints),
        joints=tuple(Joint(name=joint, label=joint) for joint in joints),
    )
    profile: CalibrationProfile = profile_of(layout, [joint_map(joint, (i,), (1.0,)) for i, joint in enumerate(joints)])
    return profile
