"""How gestures read a frame: the projections of their joints."""

# Compiled in a wheel (hatch_build.py).

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.linear_map import KINDS
from app.calibration.vocabulary import DriveParameters

Array = NDArray[np.float64]


class Projections(NamedTuple):
    """The weights of g gestures; those of a gesture against the prompted direction have the opposite sign."""

    score: Array  # (g, n_channels) FS per signal unit
    offset: Array  # (g,) FS: score = score . values - offset
    parts: Array  # (g, KINDS, n_channels) of `LinearMap.parts`: FS, then FS/s per signal unit

    @property
    def is_read(self) -> NDArray[np.bool_]:
        """Which parts (g, KINDS) each gesture reads."""
        return np.asarray((self.parts != 0.0).any(axis=2))

    @property
    def uses(self) -> NDArray[np.bool_]:
        """Which channels (g, n_channels) each gesture reads, by its score or by its map."""
        return np.asarray((self.score != 0.0) | (self.parts != 0.0).any(axis=1))


def projections(parameters: DriveParameters) -> Projections:
    """Return how the gestures read a frame. A displacement gesture reads its score, whichever map decodes its joint."""
    joints = {joint.name: joint for joint in parameters.profile.joints}
    count = len(parameters.profile.layout.channels)
    score = np.zeros((len(parameters.gestures), count))
    offset = np.zeros(len(score))
    parts = np.zeros((len(score), KINDS, count))
    for row, gesture in enumerate(parameters.gestures):
        joint = joints[gesture.joint]
        channels = list(joint.channels)
        score[row, channels] = gesture.direction * np.array(joint.pca.rates[0])
        offset[row] = score[row, channels] @ np.array(joint.mean)
        linear = joint.linear if gesture.feature == "rate" else joint.pca
        parts[row][:, channels] = gesture.direction * np.array(linear.parts)
    return Projections(score, offset, parts)
