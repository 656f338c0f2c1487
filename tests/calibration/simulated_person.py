"""A simulated person for the tests of the calibration: joints that move, and channels that follow them."""

import numpy as np

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Repetition
from app.layout import Channel, Joint, ShirtLayout

JOINTS = ("right_elbow", "left_elbow", "right_shoulder", "left_shoulder")


def layout_of(joints=JOINTS, per_joint=5):
    return ShirtLayout(
        name="test shirt",
        channels=tuple(Channel(name=f"{joint}_{i}", joint=joint) for joint in joints for i in range(per_joint)),
        joints=tuple(Joint(name=joint, label=joint.replace("_", " ").capitalize()) for joint in joints),
    )


def stroke(sample_rate, move=1.0, back=1.5, before=0.5, after=0.5):
    """Return one smooth movement 0 -> 1 -> 0 and the slice in which it rises."""

    def ramp(seconds):
        s = np.linspace(0, 1, round(seconds * sample_rate), endpoint=False)
        return 10 * s**3 - 15 * s**4 + 6 * s**5

    rise = ramp(move)
    start = round(before * sample_rate)
    path = np.concatenate([np.zeros(start), rise, 1 - ramp(back), np.zeros(round(after * sample_rate))])
    return path, slice(start, start + len(rise))


class SimulatedPerson:
    """A person whose joint angles 0..1 become channels by random gains; every joint has a second way to move."""

    def __init__(self, layout, sample_rate=100.0, seed=1, noise=0.006, second=0.15, gain=1.0):
        self.layout, self.sample_rate, self.noise = layout, sample_rate, noise
        self.rng = np.random.default_rng(seed)
        joints, channels = len(layout.joints), len(layout.channels)
        self.gains = np.zeros((joints, channels))
        self.second = np.zeros((joints, channels))
        for row, indices in enumerate(layout.channels_of_joint.values()):
            self.gains[row, indices] = gain * self.rng.uniform(0.4, 1.0, len(indices))
            self.second[row, indices] = gain * second * self.rng.uniform(-1.0, 1.0, len(indices))
        self.offsets = self.rng.normal(size=channels)

    def signals(self, angles, others=None):
        """Return channels for joint angles (n, joints) and for angles of the second way to move."""
        others = np.zeros_like(angles) if others is None else others
        clean = angles @ self.gains + others @ self.second + self.offsets
        return clean + self.noise * self.rng.normal(size=clean.shape)

    def rest(self, seconds=3.0):
        return self.signals(np.zeros((round(seconds * self.sample_rate), len(self.gains))))

    def free(self, seconds=10.0):
        t = np.arange(round(seconds * self.sample_rate)) / self.sample_rate
        speeds = self.rng.uniform(0.4, 0.7, len(self.gains))
        phases = self.rng.uniform(0, 6, len(self.gains))
        angles = 0.5 - 0.5 * np.cos(2 * np.pi * speeds * t[:, np.newaxis] + phases)
        return self.signals(angles, np.sin(2 * np.pi * 0.31 * t[:, np.newaxis] + 2 * phases))

    def repetition(self, joint, size=1.0, along=None, shift=0, **how):
        """Return one prompted movement; `along` lets other joints move too, `shift` is an error of the label (rows)."""
        path, moving = stroke(self.sample_rate, **how)
        angles = np.zeros((len(path), len(self.gains)))
        for name, share in {joint: size, **(along or {})}.items():
            angles[:, self.layout.joint_names.index(name)] = share * path
        return Repetition(joint, self.signals(angles), slice(moving.start + shift, moving.stop + shift))

    def repetitions(self, count=3, **how):
        return [self.repetition(joint, **how) for joint in self.layout.joint_names for _ in range(count)]


def calibrate(person, **changes):
    """Return the profile after all steps; `changes` replace arguments of `CleanRecording.of`."""
    pieces = {"free": person.free(), "rest": person.rest(), "repetitions": person.repetitions()}
    return fit_profile(CleanRecording.of(person.layout, person.sample_rate, **{**pieces, **changes}))
