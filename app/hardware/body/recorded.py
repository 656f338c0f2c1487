"""A body that repeats a recorded movement, given as the rotation of each joint over time."""

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from app.hardware.base import BodyView, HardwareError
from app.hardware.body.joints import ARM_DEGREES_OF_FREEDOM, ARM_JOINTS, second_way
from app.hardware.body.minimum_jerk import minimum_jerk
from app.texts import Text, text_of

AXES = ("x", "y", "z")
BLEND = 1.0  # s over which the end of the recording is blended into its beginning
SHORTEST = 4.0  # s of recording, so that beginning and end can be blended
SLOWEST = 10.0  # rows a second; fewer do not describe a movement
MOST_FILLED = 10  # largest ratio of rows after resampling to rows in the file
STILL = 1e-3  # rad: a joint that moves less has not moved
PERCENTILES = (1.0, 99.0)  # of the movement: rest and the full movement


class RecordedBody:
    """Plays `t, JOINT_x, JOINT_y, JOINT_z` (s; rotation vectors, rad) in a loop.

    Each joint's rotation vectors are projected on their own principal axes. The first axis is the joint's gesture
    (elbow flexion, a shoulder's protraction, wrist flexion in most recordings): 0 is the 1st percentile and 1 the 99th,
    in the direction in which the recording spends less of its time, because that is where people rest. The second axis
    is the shoulder's second degree of freedom, on the scale of the first, with 0 at its median. Joints that the file
    does not hold stay at rest.
    """

    def __init__(self, file: str | Path, joints: Sequence[str] = ARM_DEGREES_OF_FREEDOM) -> None:
        """Read the file.

        Raises
        ------
        HardwareError
            In one sentence, when the file cannot be read or holds no joint of this body.
        """
        self.joints = tuple(joints)
        self._dt, postures = _postures(Path(file), self.joints)
        self._postures = _looped(postures, round(BLEND / self._dt))
        self._posture = np.zeros(len(self.joints))
        self.reset()

    def reset(self) -> None:
        """Go back to the beginning of the recording."""
        self._t = 0.0

    @property
    def duration(self) -> float:
        """Seconds of one round."""
        return len(self._postures) * self._dt

    def step(self, dt: float, _view: BodyView) -> NDArray[np.float64]:
        """Advance by `dt` (s) and return the posture (n_joints,), linearly interpolated between samples."""
        self._t = (self._t + dt) % self.duration
        place = self._t / self._dt
        before = math.floor(place)
        share = place - before
        count = len(self._postures)
        np.multiply(self._postures[before % count], 1.0 - share, out=self._posture)
        self._posture += share * self._postures[(before + 1) % count]
        return self._posture


def principal_postures(rotations: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the postures (n,) along the first and the second principal axis of rotation vectors (n, 3), rad.

    Both are 0 for a joint that did not move.
    """
    centred = rotations - rotations.mean(axis=0)
    _, spread, axes = np.linalg.svd(centred, full_matrices=False)
    if spread[0] / math.sqrt(len(rotations)) < STILL:
        return np.zeros(len(rotations)), np.zeros(len(rotations))
    first, second = centred @ axes[0], centred @ axes[1]
    low, high = np.percentile(first, PERCENTILES)
    if np.median(first) > (low + high) / 2:
        first, low, high = -first, -high, -low
    return (first - low) / (high - low), (second - np.median(second)) / (high - low)


def _postures(file: Path, joints: tuple[str, ...]) -> tuple[float, NDArray[np.float64]]:
    """Return the time between samples (s) and the postures (n, n_joints) of a recording."""
    from app.signals.timed_table import read_timed  # noqa: PLC0415  (loads pyarrow, which other bodies do without)

    try:
        t, table = read_timed(file)
        named = [joint for joint in joints if any(f"{joint}_{axis}" in table.columns for axis in AXES)]
        if not named:
            columns = ", ".join(f"{ARM_JOINTS[0]}_{axis}" for axis in AXES)
            raise ValueError(Text("bodydev-file-no-joint", file=str(file), columns=columns))
        rotations = {joint: np.stack([table.numbers(f"{joint}_{axis}") for axis in AXES], axis=1) for joint in named}
    except ValueError as error:
        raise HardwareError(text_of(error)) from error
    steps = np.diff(t)
    if len(t) < 2 or not (steps > 0).all():
        raise HardwareError(Text("bodydev-file-times", file=str(file)))
    if t[-1] - t[0] < SHORTEST:
        length = round(float(t[-1] - t[0]), 2)
        raise HardwareError(Text("bodydev-file-short", file=str(file), length=length, least=SHORTEST))
    dt = float(np.median(steps))
    if dt > 1.0 / SLOWEST:
        raise HardwareError(Text("bodydev-file-slow", file=str(file), least=SLOWEST))
    if t[-1] - t[0] > MOST_FILLED * len(t) * dt:
        raise HardwareError(Text("bodydev-file-uneven", file=str(file)))
    even = t[0] + dt * np.arange(round((t[-1] - t[0]) / dt) + 1)
    postures = np.zeros((len(even), len(joints)))
    for joint, vectors in rotations.items():
        first, second = principal_postures(vectors)
        postures[:, joints.index(joint)] = np.interp(even, t, first)
        aside = second_way(joint)
        if aside in joints:
            postures[:, joints.index(aside)] = np.interp(even, t, second)
    return dt, postures


def _looped(postures: NDArray[np.float64], blend: int) -> NDArray[np.float64]:
    """Return the recording with its end blended into its beginning, `blend` rows shorter."""
    share = np.array([[minimum_jerk((i + 0.5) / blend)] for i in range(blend)])
    joined = postures[:-blend].copy()
    joined[:blend] = share * postures[:blend] + (1 - share) * postures[-blend:]
    return joined
