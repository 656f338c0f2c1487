"""The rate of a guided map, frame by frame: three projections, two slow averages, one low-pass."""

import math

import numpy as np
from numpy.typing import NDArray

from app.butterworth import Coefficients
from app.calibration.profile import AVERAGING_TIMES
from app.calibration.vocabulary import DriveParameters, Gesture
from app.pipeline.low_pass import LowPass

PARTS = 3  # projections of a guided map: the one that is differentiated, and two levels


def is_guided(parameters: DriveParameters, gesture: Gesture) -> bool:
    """Return whether a gesture reads the guided map of its joint; a displacement gesture never does."""
    joints = {joint.name: joint for joint in parameters.profile.joints}
    return gesture.feature == "rate" and joints[gesture.joint].map == "guided"


def guided_projection(parameters: DriveParameters) -> NDArray[np.float64]:
    """Return weights (3 * n_guided, n_channels), three rows for each guided gesture in their order, in FS and FS/s.

    The rows of a gesture against the prompted direction have the opposite sign.
    """
    joints = {joint.name: joint for joint in parameters.profile.joints}
    rows = []
    for gesture in parameters.gestures:
        joint = joints[gesture.joint]
        if not is_guided(parameters, gesture) or joint.guided is None:
            continue
        for part in (joint.guided.rate, joint.guided.short, joint.guided.long):
            row = np.zeros(len(parameters.profile.layout.channels))
            row[list(joint.channels)] = gesture.direction * np.array(part)
            rows.append(row)
    return np.array(rows).reshape(-1, len(parameters.profile.layout.channels))


class GuidedRate:
    """The rate of one gesture; a change while a channel was bad does not count as a movement afterwards."""

    def __init__(self, coefficients: Coefficients, sample_rate: float) -> None:
        self._low_pass = LowPass(coefficients)
        self._per_frame = [1.0 / (sample_rate * memory) for memory in AVERAGING_TIMES]
        self._usual = [1.0 - math.exp(-share) for share in self._per_frame]
        self.reset()

    def reset(self) -> None:
        """Reset all state; the next frame settles the filters."""
        self._low_pass.reset()
        self._fresh = True
        self._last = [0.0] * PARTS
        self._unseen = [0.0] * PARTS
        self._slow = [0.0] * len(AVERAGING_TIMES)

    def step(self, products: list[float], bad: bool, was_bad: bool, periods: float, sample_rate: float) -> float:
        """Return the rate in FS/s after the three projections of a frame, `periods` sample periods after the last.

        The projections of a `bad` frame do not count; `was_bad`: the frame before was bad.
        """
        last, unseen, slow = self._last, self._unseen, self._slow
        moved = 0.0
        if not bad:
            if was_bad:
                for part in range(PARTS):
                    unseen[part] += products[part] - last[part]
            elif not self._fresh:
                moved = products[0] - last[0]
            self._last = last = products
        levels = 0.0
        for i, usual in enumerate(self._usual):
            level = last[i + 1] - unseen[i + 1]
            if self._fresh:
                slow[i] = level
            share = usual if periods == 1.0 else 1.0 - math.exp(-periods * self._per_frame[i])
            slow[i] += share * (level - slow[i])
            levels += level - slow[i]
        self._fresh = False
        return self._low_pass.step(moved * sample_rate / periods + levels)
