"""A small real calibration profile: two joints, two channels each."""

from app.calibration.linear_map import LinearMap
from app.calibration.profile import CalibrationProfile, JointMap
from app.layout import Channel, Joint, ShirtLayout


def small_profile(joints: tuple[str, ...] = ("right_elbow", "left_elbow")) -> CalibrationProfile:
    layout = ShirtLayout(
        name="Small",
        channels=tuple(Channel(name=f"{joint}_1", joint=joint) for joint in joints),
        joints=tuple(Joint(name=joint, label=joint) for joint in joints),
    )
    maps = tuple(
        JointMap(
            name=joint,
            channels=(i,),
            mean=(0.0,),
            evr=0.9,
            prompted=True,
            rest_rate=0.04,
            pca=LinearMap(rates=((1.0,),), dead_zone=0.2, full=1.0),
            step=0.035,
            filtered_step=0.06,
            covariance=((1.0,),),
            grade="good",
            reason="Clear.",
        )
        for i, joint in enumerate(joints)
    )
    zeros = (0.0,) * len(joints)
    return CalibrationProfile(
        created="2025-01-01T00:00:00+00:00",
        software="0",
        layout=layout,
        sample_rate=100.0,
        left_out={},
        low=zeros,
        high=tuple(1.0 for _ in joints),
        noise=zeros,
        joints=maps,
    )
