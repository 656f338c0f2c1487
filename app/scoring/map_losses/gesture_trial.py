"""The figures of a gesture in one trial, read with a parameter set: noise at rest, size of its strokes, time missed.

The figures are of the rate that the decoder gives, whatever kind of map the joint has.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.adaptation.change_limits import STANDARD_LIMITS
from app.calibration.adaptation.direction import principal, share_along
from app.calibration.adaptation.movement import (
    LONGEST_BREAK,
    SHORTEST_PIECE,
    SHORTEST_STROKE,
    Movement,
    rest_noise,
    stretches,
)
from app.calibration.adaptation.thresholds import dead_zone_for, least_dead_zone
from app.calibration.gaps import fill_forward
from app.calibration.profile import JointMap
from app.calibration.vocabulary import DriveParameters
from app.pipeline.channel_health import ChannelHealth
from app.pipeline.projection import projections
from app.pipeline.replay.batch import decode_block

FEWEST_STROKES = 3  # of a gesture in a trial
OWN_FACTOR = (
    2.0  # a stroke is this gesture's own where it is at least this many times as strong as any other (rate / full)
)
MOST_BAD = 0.2  # share of a trial; a gesture that read bad channels for longer has no figures of its movement

Numbers = NDArray[np.float64]
Flags = NDArray[np.bool_]


class GestureTrial(NamedTuple):
    """The figures of one gesture in one trial; None where the trial has too little rest or too few strokes."""

    noise: float | None  # ln of the rate's noise at rest (FS/s)
    size: float | None  # ln of the 90th percentile of its strokes' rates (FS/s)
    missed: float | None  # share of its strokes' time that the present dead-zone leaves unanswered
    blind: float | None  # share of the joint's rate that the direction of a PCA map does not see
    silent: float  # share of the trial in which safety rule S5 silenced it


def gesture_trials(parameters: DriveParameters, movement: Movement) -> dict[str, GestureTrial]:
    """Return the figures of each bound gesture that reads a rate, by its name, as `parameters` read the trial.

    A stroke is a stretch of the rate above the dead-zone that the noise of this trial needs, not above the present one:
    otherwise a dead-zone that is too large would hide what it costs.
    """
    bound = [i for i in parameters.bound_gestures if parameters.gestures[i].feature == "rate"]
    if not len(movement.values) or not bound:
        return {}
    values, sample_rate = np.asarray(movement.values, dtype=np.float32), movement.sample_rate
    uses = projections(parameters).uses
    health = ChannelHealth(parameters.profile, np.asarray(uses.any(axis=0)), sample_rate)
    bad = health.block(values.astype(np.float64), None)
    decoded = decode_block(parameters, sample_rate, np.arange(len(values)) / sample_rate, values)
    rates = decoded.rate
    strength = np.abs(rates) / np.array([gesture.full for gesture in parameters.gestures])
    filled = fill_forward(values.astype(np.float64))
    armed = np.asarray(movement.armed, dtype=np.bool_)
    joints = {joint.name: joint for joint in parameters.profile.joints}
    figures = {}
    for i in bound:
        gesture, joint = parameters.gestures[i], joints[parameters.gestures[i].joint]
        silent = float(decoded.silent[:, i].mean())
        is_unsure = decoded.silent[:, i] | (bad & uses[i]).any(axis=1)  # an estimate of a channel is no measurement
        if is_unsure.mean() > MOST_BAD:
            figures[gesture.name] = GestureTrial(None, None, None, None, silent)
            continue
        other_gestures = [other for other in bound if parameters.gestures[other].joint != joint.name]
        is_own = (
            armed & ~is_unsure & (strength[:, i] >= OWN_FACTOR * strength[:, other_gestures].max(axis=1, initial=0.0))
        )
        noise = rest_noise([rates[:, i]], [sample_rate])
        needed = least_dead_zone(joint) if noise is None else dead_zone_for(joint, noise)
        strokes = _strokes(rates[:, i], is_own, needed, sample_rate)
        figures[gesture.name] = GestureTrial(
            noise=math.log(noise) if noise else None,
            size=math.log(float(np.percentile(strokes, 90))) if strokes is not None else None,
            missed=float(np.mean(strokes <= gesture.dead_zone)) if strokes is not None else None,
            blind=blindness(joint, filled, is_own & (np.abs(rates[:, i]) > needed), sample_rate),
            silent=silent,
        )
    return figures


def _strokes(rate: Numbers, is_own: Flags, above: float, sample_rate: float) -> Numbers | None:
    """Return the rates (FS/s) of all strokes above a rate, one after the other; None for fewer than three strokes."""
    strokes = [rate[piece] for piece in stretches(is_own & (rate > above), 0.0, SHORTEST_STROKE, sample_rate)]
    return np.concatenate(strokes) if len(strokes) >= FEWEST_STROKES else None


def blindness(joint: JointMap, values: Numbers, moving: NDArray[np.bool_], sample_rate: float) -> float | None:
    """Return the share (0..1) of the movement's rate that is lost because the map points beside the movement.

    It is 1 - sqrt(share of the variance along the map / share along the movement's own main direction). A direction
    that is 8 degrees off loses 0.01, one of 18 degrees 0.05, one of 26 degrees 0.10.

    Parameters
    ----------
    joint
        With a PCA map; other maps have no direction to turn, and the answer is None.
    values
        (n, n_channels) signal units, without missing samples.
    moving
        (n,) where the joint makes a movement of its own.
    sample_rate
        Hz.
    """
    weights = np.array(joint.direction)
    if joint.map != "pca":
        return None
    signals = values[:, list(joint.channels)] * (weights != 0.0)
    pieces = stretches(moving, LONGEST_BREAK, SHORTEST_PIECE, sample_rate)
    rows = [signals[piece] - signals[piece].mean(axis=0) for piece in pieces]
    if sum(map(len, rows)) < STANDARD_LIMITS.least_movement * sample_rate:
        return None
    moved = np.concatenate(rows)
    covariance = moved.T @ moved
    main = principal(covariance, weights)
    if main is None or main.share <= 0.0:
        return None
    return max(0.0, 1.0 - math.sqrt(min(1.0, share_along(covariance, weights) / main.share)))
