"""Movements of each joint in the last trials: when it moved, and its noise at rest."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.calibration.gaps import fill_forward
from app.calibration.profile import JointMap
from app.calibration.vocabulary import DriveParameters, Gesture
from app.signals.low_pass import smooth

OWN_FACTOR = 2.0  # a movement is this joint's own when it is so many times as fast as any other joint's (rate / full)
LONGEST_BREAK = 0.2  # s: shorter breaks, such as the turning point of a stroke, do not end a movement
SHORTEST_PIECE = 0.25  # s
SHORTEST_STROKE = 0.1  # s above the dead-zone
REST_WINDOW = 0.5  # s
REST_QUANTILE = 0.3  # of the windows' spreads: between strokes, each limb rests for more than half of the time

Numbers = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Movement:
    """The frames of one trial, NaN where a sample is missing, and whether motion was permitted."""

    values: NDArray[np.floating]  # (n, n_channels) signal units
    sample_rate: float  # Hz
    armed: Mask  # (n,) whether motion was permitted


@dataclass(frozen=True, slots=True)
class MappedTrial:
    """The rates of all joints in one trial, computed with the present map."""

    values: Numbers  # (n, n_channels), without holes
    sample_rate: float
    armed: Mask
    rate: dict[str, Numbers]  # joint -> (n,) FS/s, rising towards the gesture of the calibration
    own: dict[str, Mask]  # joint -> (n,) whether it makes a movement of its own


def map_trials(parameters: DriveParameters, movements: Sequence[Movement]) -> list[MappedTrial]:
    """Return the rates and own movements of all joints in each trial; trials without a frame are left out.

    A joint makes a movement of its own while motion is permitted, its rate in either direction is beyond its dead-zone,
    and rate / full is at least twice that of any other joint. Tremor and cross-talk from a neighbour do not count.
    """
    return [_map_trial(parameters, movement) for movement in movements if len(movement.values)]


def _map_trial(parameters: DriveParameters, movement: Movement) -> MappedTrial:
    values = fill_forward(np.asarray(movement.values, dtype=np.float64))
    armed = np.asarray(movement.armed, dtype=np.bool_)
    rate, speed, fast = {}, {}, {}
    for joint in parameters.profile.joints:
        rate[joint.name] = rate_along(joint, np.array(joint.direction), values, movement.sample_rate, parameters.cutoff)
        gesture = gesture_of(parameters, joint.name)
        on_pc1 = gesture is not None and joint.map == "pca"  # the thresholds of a guided map have another scale
        handles = gesture if gesture and on_pc1 else joint.pca
        dead_zone, full = handles.dead_zone, handles.full
        size = np.abs(rate[joint.name])
        speed[joint.name], fast[joint.name] = size / max(full, 1e-9), size > dead_zone
    own_values = {}
    for name in rate:
        others = [other for key, other in speed.items() if key != name]
        strongest = np.max(others, axis=0) if others else np.zeros(len(values))
        own_values[name] = armed & fast[name] & (speed[name] >= OWN_FACTOR * strongest)
    return MappedTrial(values, movement.sample_rate, armed, rate, own_values)


def gesture_of(parameters: DriveParameters, joint: str) -> Gesture | None:
    """Return the first bound gesture that reads a joint's rate, None when there is none."""
    gestures = (parameters.gestures[index] for index in parameters.bound_gestures)
    return next((gesture for gesture in gestures if gesture.joint == joint and gesture.feature == "rate"), None)


def rate_along(joint: JointMap, weights: Numbers, values: Numbers, sample_rate: float, cutoff: float) -> Numbers:
    """Return the rate (n,) in FS/s of a joint with `weights`, computed as by the decoder."""
    place = (values[:, list(joint.channels)] - np.array(joint.mean)) @ weights
    smoothed = smooth(place / joint.span, cutoff, sample_rate)
    return np.diff(smoothed, prepend=smoothed[0]) * sample_rate


def movement_rows(trials: Sequence[MappedTrial], joint: JointMap) -> Numbers:
    """Return the values (m, k) of the joint's channels during its own movements, oldest first.

    The mean of each movement is subtracted, as the calibration does with its prompts: drift between two movements is
    no movement.
    """
    rows = [np.empty((0, len(joint.channels)))]
    for trial in trials:
        signals = trial.values[:, list(joint.channels)]
        pieces = stretches(trial.own[joint.name], LONGEST_BREAK, SHORTEST_PIECE, trial.sample_rate)
        rows.extend(signals[piece] - signals[piece].mean(axis=0) for piece in pieces)
    return np.concatenate(rows)


def rest_noise(rates: Sequence[Numbers], sample_rates: Sequence[float]) -> float | None:
    """Return the rate's noise at rest (FS/s), None for less than 5 s of trials.

    The dead-zone cannot tell rest from movement when tremor exceeds it. But between strokes a limb rests for more than
    half of the time: the noise is the 0.3 quantile of the standard deviations of all half-second windows.
    """
    spreads: list[Numbers] = []
    for rate, sample_rate in zip(rates, sample_rates, strict=True):
        length = max(2, round(REST_WINDOW * sample_rate))
        count = len(rate) // length
        spreads.append(rate[: count * length].reshape(count, length).std(axis=1))
    windows = np.concatenate(spreads) if spreads else np.empty(0)
    return float(np.quantile(windows, REST_QUANTILE)) if len(windows) >= 10 else None


def stretches(mask: Mask, longest_break: float, shortest: float, sample_rate: float) -> list[slice]:
    """Return where a mask (n,) is true for at least `shortest` (s), breaks of up to `longest_break` (s) included."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], mask, [False])).astype(np.int8)))
    joined: list[list[int]] = []
    for start, stop in edges.reshape(-1, 2).tolist():
        if joined and start - joined[-1][1] <= longest_break * sample_rate:
            joined[-1][1] = stop
        else:
            joined.append([start, stop])
    return [slice(start, stop) for start, stop in joined if stop - start >= max(2.0, shortest * sample_rate)]
