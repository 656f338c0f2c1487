"""How gestures read a frame: the projections of their joints."""

import numpy as np
from numpy.typing import NDArray

from app.calibration.vocabulary import DriveParameters
from app.pipeline.linear_rate import linear_projection


def projection(parameters: DriveParameters) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return weights (n_gestures, n_channels) and offsets (n_gestures,): score = weights . values - offsets, in FS."""
    profile = parameters.profile
    joints = {joint.name: joint for joint in profile.joints}
    weights = np.zeros((len(parameters.gestures), len(profile.layout.channels)))
    offsets = np.zeros(len(parameters.gestures))
    for row, gesture in enumerate(parameters.gestures):
        joint = joints[gesture.joint]
        scale = gesture.direction * joint.sign / joint.span
        weights[row, list(joint.channels)] = scale * np.array(joint.weights)
        offsets[row] = weights[row, list(joint.channels)] @ np.array(joint.mean)
    return weights, offsets


def channels_used(parameters: DriveParameters) -> NDArray[np.bool_]:
    """Return which channels (n_gestures, n_channels) each gesture reads, by its score or by its linear map."""
    uses = projection(parameters)[0] != 0.0
    rows, places = linear_projection(parameters)
    for gesture, place in places.items():
        uses[gesture] |= (rows[place] != 0.0).any(axis=0)
    return np.asarray(uses)
