"""A shirt of two joints with four channels each, and strokes in a known direction."""

import math

import numpy as np

from app.calibration.vocabulary import Binding, DriveParameters, Gesture
from app.layout import Channel, Joint, ShirtLayout
from building import joint_map, profile_of

RATE = 100.0
JOINTS = ("right_elbow", "left_elbow")
COUNT = 4  # channels of a joint
NOISE = 1e-4  # keeps a channel from being flat
SECONDS = 40.0


def parameters(bound: tuple[str, ...] = JOINTS, *, stop: bool = False) -> DriveParameters:
    layout = ShirtLayout(
        name="Known",
        channels=tuple(Channel(name=f"{joint}_{i}", joint=joint) for joint in JOINTS for i in range(COUNT)),
        joints=tuple(Joint(name=joint, label=joint.replace("_", " ")) for joint in JOINTS),
    )
    rates, weights = (0.5, 0.0, 0.0, 0.0), [0.5] * COUNT
    maps = [
        joint_map(joint, range(COUNT * place, COUNT * place + COUNT), rates, weights, dead_zone=0.15, rest_rate=0.01)
        for place, joint in enumerate(JOINTS)
    ]
    profile = profile_of(layout, maps, -1.0, 3.0, RATE)
    gestures = tuple(Gesture(name=joint, joint=joint, dead_zone=0.15, full=1.0) for joint in JOINTS)
    controls = ("u1+", "u1-")
    bindings = [Binding(control=control, gestures=(joint,)) for control, joint in zip(controls, bound, strict=False)]
    if stop:
        bindings.append(Binding(control="stop", gestures=JOINTS))
    return DriveParameters(profile=profile, gestures=gestures, bindings=tuple(bindings))


def strokes(share: float = 1.0, seconds: float = SECONDS) -> np.ndarray:
    """Return strokes of 1 s to `share` of full scale and back, each followed by 1 s of rest: (n,) in FS."""
    t = np.arange(round(seconds * RATE)) / RATE
    phase = np.minimum(t % 2.0, 1.0)
    return share * (0.5 - 0.5 * np.cos(2 * math.pi * phase))


def frames(right: np.ndarray, left: np.ndarray | None = None) -> np.ndarray:
    """Return the shirt's signals (n, 8) for movements (n, 4) of the right elbow, and of the left one."""
    other = np.zeros_like(right) if left is None else left
    noise = NOISE * np.random.default_rng(1).standard_normal((len(right), 2 * COUNT))
    return np.concatenate((right, other), axis=1) + noise


def along(direction: np.ndarray, movement: np.ndarray) -> np.ndarray:
    return 2.0 * movement[:, np.newaxis] * direction  # span 2.0


def turned(degrees: float) -> np.ndarray:
    return np.array([math.cos(math.radians(degrees)), 0.0, math.sin(math.radians(degrees)), 0.0])
