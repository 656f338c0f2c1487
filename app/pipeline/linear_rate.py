"""The projections of linear maps; the rate of a guided map, frame by frame: two slow averages, one low-pass."""

import math

import numpy as np
from numpy.typing import NDArray

from app.butterworth import Coefficients
from app.calibration.profile import AVERAGING_TIMES, LinearMap
from app.calibration.vocabulary import DriveParameters, Gesture
from app.pipeline.low_pass import LowPass

PARTS = 3  # projections of a guided map: the one that is differentiated, and two levels


def linear_map_of(parameters: DriveParameters, gesture: Gesture) -> LinearMap | None:
    """Return the linear map that a gesture reads; None for the PCA map, which a displacement gesture always reads."""
    if gesture.feature != "rate":
        return None
    return next(joint.linear for joint in parameters.profile.joints if joint.name == gesture.joint)


def linear_projection(parameters: DriveParameters) -> tuple[NDArray[np.float64], dict[int, slice]]:
    """Return weights (n_rows, n_channels) in FS and FS/s, and which rows belong to each gesture with a linear map.

    The rows of a gesture are the parts of its map; those of a gesture against the prompted direction have the opposite
    sign.
    """
    channels = {joint.name: list(joint.channels) for joint in parameters.profile.joints}
    count = len(parameters.profile.layout.channels)
    rows: list[NDArray[np.float64]] = []
    places = {}
    for index, gesture in enumerate(parameters.gestures):
        linear = linear_map_of(parameters, gesture)
        if linear is None:
            continue
        places[index] = slice(len(rows), len(rows) + len(linear.parts))
        for part in linear.parts:
            row = np.zeros(count)
            row[channels[gesture.joint]] = gesture.direction * np.array(part)
            rows.append(row)
    return np.array(rows).reshape(-1, count), places


class GuidedRate:
    """The rate of one gesture."""

    def __init__(self, coefficients: Coefficients, sample_rate: float) -> None:
        self._low_pass = LowPass(coefficients)
        self._per_frame = [1.0 / (sample_rate * memory) for memory in AVERAGING_TIMES]
        self._usual = [1.0 - math.exp(-share) for share in self._per_frame]
        self.reset()

    def reset(self) -> None:
        """Reset all state; the next frame settles the filters."""
        self._low_pass.reset()
        self._fresh = True
        self._last = 0.0
        self._slow = [0.0] * len(AVERAGING_TIMES)

    def step(self, products: list[float], periods: float, sample_rate: float) -> float:
        """Return the rate in FS/s after the three projections of a frame, `periods` sample periods after the last."""
        slow = self._slow
        moved = 0.0 if self._fresh else products[0] - self._last
        self._last = products[0]
        levels = 0.0
        for i, usual in enumerate(self._usual):
            level = products[i + 1]
            if self._fresh:
                slow[i] = level
            share = usual if periods == 1.0 else 1.0 - math.exp(-periods * self._per_frame[i])
            slow[i] += share * (level - slow[i])
            levels += level - slow[i]
        self._fresh = False
        return self._low_pass.step(moved * sample_rate / periods + levels)
