"""The joints that names of channels say, in the words of several programs and languages."""

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.layout import MAX_JOINTS
from app.signals.joint_names import channel_names, layout_from_names, proposed_joints


@pytest.mark.parametrize(
    ("names", "joints"),
    [
        (["LeftForeArm Xrotation", "LeftArm Xrotation", "Hips"], ["left_elbow", "left_shoulder", "body"]),
        (["P1:LSHO X", "P1:RELB Y"], ["left_shoulder", "right_elbow"]),
        (["Winkel Ellbogen links [°]", "muñeca derecha X"], ["left_elbow", "right_wrist"]),
        (["Winkel der linken Hand", "Beugung der Schulter rechts [°]"], ["left_wrist", "right_shoulder"]),
        (["Kraft der Hand", "Hand der Person"], ["wrist", "wrist"]),
        (["hombro_der_x", "Codo der. [°]", "codo izq"], ["right_shoulder", "right_elbow", "left_elbow"]),
        (["R Upper Leg", "L Lower Arm", "Sternum"], ["right_hip", "left_elbow", "trunk"]),
        (["right_elbow_1", "right_elbow_2", "trunk_1"], ["right_elbow", "right_elbow", "trunk"]),
        (["left_ear_1", "left_ear_2"], ["left_ear", "left_ear"]),
        (["Acc_X", "Acc_Y", "Gyr_X"], ["body", "body", "body"]),
        (["A", "B", "EMG 3"], ["body", "body", "body"]),
        ([f"place{chr(97 + i)} x" for i in range(20)], ["body"] * 20),
    ],
)
def test_a_name_says_its_joint(names, joints):
    assert list(proposed_joints(names).values()) == joints


@given(st.lists(st.text(max_size=40), min_size=1, max_size=64, unique=True))
def test_any_names_give_channels_of_a_layout(names):
    proposed = proposed_joints(names)
    joints = [proposed[name] for name in names]
    assert len(set(joints)) <= MAX_JOINTS
    layout = layout_from_names(Path("walk.parquet"), channel_names(joints))
    assert [channel.joint for channel in layout.channels] == joints
