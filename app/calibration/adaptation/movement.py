"""What the last trials show of each joint: when it moved, when it rested, how strong its strokes were."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.calibration.fit.pieces import fill_forward
from app.calibration.profile import JointMap
from app.calibration.vocabulary import DriveParameters, Gesture
from app.signals.smoothing import smooth

MOST = 2.0  # times as fast as any other joint, each against its own full: then a movement is this joint's own
CLOSED = 0.2  # s: a stroke turns round at its top, which is no pause
SHORTEST_PIECE = 0.25  # s
SHORTEST_STROKE = 0.1  # s above the dead-zone
REST_WINDOW = 0.5  # s
REST_SHARE = 0.3  # of the windows are surely at rest: strokes leave every limb more than half of the time

Numbers = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Movement:
    """One trial's frames, NaN where a sample is missing, and where motion was permitted."""

    values: NDArray[np.floating]  # (n, n_channels) signal units
    sample_rate: float  # Hz
    armed: Mask  # (n,)


@dataclass(frozen=True, slots=True)
class Heard:
    """One trial as the map of today hears it."""

    values: Numbers  # (n, n_channels), without holes
    sample_rate: float
    armed: Mask
    rate: dict[str, Numbers]  # joint -> (n,) FS/s, rising towards the gesture of the calibration
    own: dict[str, Mask]  # joint -> (n,) where it moves, and moves most


def hear(parameters: DriveParameters, movements: Sequence[Movement]) -> list[Heard]:
    """Return the trials as the map hears them; those without a frame are left out.

    A joint *moves* while motion is permitted, its rate (either way: a limb that comes back moves too) is beyond its
    dead-zone, and it is at least twice as fast as any other joint, each measured against its own full. So neither
    tremor nor what leaks from a neighbour counts as its movement.
    """
    return [_heard(parameters, one) for one in movements if len(one.values)]


def _heard(parameters: DriveParameters, movement: Movement) -> Heard:
    values = fill_forward(np.asarray(movement.values, dtype=np.float64))
    armed = np.asarray(movement.armed, dtype=np.bool_)
    rate, speed, fast = {}, {}, {}
    for joint in parameters.profile.joints:
        rate[joint.name] = rate_along(joint, np.array(joint.weights), values, movement.sample_rate, parameters.cutoff)
        gesture = gesture_of(parameters, joint.name)
        on_pc1 = gesture is not None and joint.map == "pca"  # the handles of a guided map are of another scale
        dead_zone, full = (gesture.dead_zone, gesture.full) if gesture and on_pc1 else (joint.dead_zone, joint.full)
        size = np.abs(rate[joint.name])
        speed[joint.name], fast[joint.name] = size / max(full, 1e-9), size > dead_zone
    own = {}
    for name in rate:
        others = [other for key, other in speed.items() if key != name]
        strongest = np.max(others, axis=0) if others else np.zeros(len(values))
        own[name] = armed & fast[name] & (speed[name] >= MOST * strongest)
    return Heard(values, movement.sample_rate, armed, rate, own)


def gesture_of(parameters: DriveParameters, joint: str) -> Gesture | None:
    """Return the first bound gesture that reads a joint's rate, None when there is none."""
    bound = {name for binding in parameters.bindings for name in binding.gestures}
    for gesture in parameters.gestures:
        if gesture.joint == joint and gesture.feature == "rate" and gesture.name in bound:
            return gesture
    return None


def rate_along(joint: JointMap, weights: Numbers, values: Numbers, sample_rate: float, cutoff: float) -> Numbers:
    """Return the rate (n,) in FS/s that a joint has with these weights, as the decoder makes it."""
    place = (values[:, list(joint.channels)] - np.array(joint.mean)) @ weights
    smoothed = smooth(place * (joint.sign / joint.span), cutoff, sample_rate)
    return np.diff(smoothed, prepend=smoothed[0]) * sample_rate


def moved_rows(heard: Sequence[Heard], joint: JointMap) -> Numbers:
    """Return what the joint's channels did while it moved (m, k), oldest first.

    Each stretch of movement is taken about its own mean, as the calibration takes its prompts: drift between two
    movements is no movement.
    """
    rows = [np.empty((0, len(joint.channels)))]
    for trial in heard:
        signals = trial.values[:, list(joint.channels)]
        pieces = stretches(trial.own[joint.name], CLOSED, SHORTEST_PIECE, trial.sample_rate)
        rows.extend(signals[piece] - signals[piece].mean(axis=0) for piece in pieces)
    return np.concatenate(rows)


def strokes(heard: Sequence[Heard], joint: str, rates: Sequence[Numbers], dead_zone: float) -> list[Numbers]:
    """Return the rates (FS/s) of each of the joint's strokes above the dead-zone; `rates` (n,) one per trial."""
    found = []
    for trial, rate in zip(heard, rates, strict=True):
        above = trial.own[joint] & (rate > dead_zone)
        found += [rate[piece] for piece in stretches(above, 0.0, SHORTEST_STROKE, trial.sample_rate)]
    return found


def rest_noise(rates: Sequence[Numbers], sample_rates: Sequence[float]) -> float | None:
    """Return the rate's noise at rest (FS/s), None for less than a few seconds.

    Whether somebody rests cannot be told from the dead-zone when tremor has outgrown it. But strokes leave a limb at
    rest for more than half of the time: the typical one among the calmest half seconds tells the noise.
    """
    spreads: list[Numbers] = []
    for rate, sample_rate in zip(rates, sample_rates, strict=True):
        length = max(2, round(REST_WINDOW * sample_rate))
        count = len(rate) // length
        spreads.append(rate[: count * length].reshape(count, length).std(axis=1))
    windows = np.concatenate(spreads) if spreads else np.empty(0)
    return float(np.quantile(windows, REST_SHARE)) if len(windows) >= 10 else None


def stretches(mask: Mask, closed: float, shortest: float, sample_rate: float) -> list[slice]:
    """Return where a mask (n,) is true without a break longer than `closed` (s), for at least `shortest` (s)."""
    edges = np.flatnonzero(np.diff(np.concatenate(([False], mask, [False])).astype(np.int8)))
    joined: list[list[int]] = []
    for start, stop in edges.reshape(-1, 2).tolist():
        if joined and start - joined[-1][1] <= closed * sample_rate:
            joined[-1][1] = stop
        else:
            joined.append([start, stop])
    return [slice(start, stop) for start, stop in joined if stop - start >= max(2.0, shortest * sample_rate)]
