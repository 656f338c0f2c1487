"""Adapts dead-zone and full of a gesture in limited steps (docs/learning/adapting.md, "The rule").

Both are rates of the joint's map, of whatever kind. To make the span of a PCA map smaller by a factor is the same as to
multiply both by it, and other maps have no span: therefore the thresholds follow the person, and the span stays.
"""

import math
from typing import NamedTuple

from app.calibration.dead_zone import LARGEST_ADAPTED_SHARE, LEAST_RANGE, REST_NOISE_FACTOR, SMALLEST_DEAD_ZONE
from app.calibration.profile import JointMap
from app.calibration.vocabulary import Gesture

# Largest relative changes at once. A dead-zone that noise has outgrown keeps the whole chair from starting, so it may
# follow far; that it makes small movements count less is hardly felt.
DEAD_ZONE_RISE = 1.0
DEAD_ZONE_FALL = 0.2
FULL_UPDATE = 0.08  # the command of every movement changes by as much: felt
LARGEST_FACTOR = 2.5  # between full and the calibration's full, either way: beyond it, calibrate again
LEAST_CHANGE = 0.01  # relative: smaller changes are chance and make no new version
OWN_SCALE = ("pca", "guided")  # maps whose rate is in FS/s of the joint's span, so that SMALLEST_DEAD_ZONE is theirs


class Thresholds(NamedTuple):
    """The two adjustable thresholds of a gesture, FS/s."""

    dead_zone: float
    full: float


def least_dead_zone(joint: JointMap) -> float:
    """Return the smallest dead-zone (FS/s) that a calibration gives the joint, however calm it is at rest."""
    return SMALLEST_DEAD_ZONE if joint.map in OWN_SCALE else joint.thresholds[0]


def dead_zone_for(joint: JointMap, noise: float) -> float:
    """Return the dead-zone (FS/s) for a noise of the rate at rest (FS/s); `joint` is as calibrated."""
    dead_zone, full = joint.thresholds
    return min(max(REST_NOISE_FACTOR * noise, least_dead_zone(joint)), max(LARGEST_ADAPTED_SHARE * full, dead_zone))


def full_for(joint: JointMap, full: float, growth: float) -> float:
    """Return the full (FS/s) for strokes that have grown by the logarithm `growth`; `joint` is as calibrated."""
    calibrated = joint.thresholds[1]
    return min(max(full * math.exp(growth), calibrated / LARGEST_FACTOR), calibrated * LARGEST_FACTOR)


def step_thresholds(gesture: Gesture, wanted: Thresholds) -> Thresholds:
    """Return the thresholds after one limited step from those of `gesture` towards `wanted`."""
    dead_zone = _step(gesture.dead_zone, wanted.dead_zone, DEAD_ZONE_RISE, DEAD_ZONE_FALL)
    full = _step(gesture.full, wanted.full, FULL_UPDATE, FULL_UPDATE)
    if full < dead_zone + LEAST_RANGE:
        return Thresholds(gesture.dead_zone, gesture.full)  # no change is better than a gesture that acts as a switch
    return Thresholds(dead_zone, full)


def _step(before: float, wanted: float, rise: float, fall: float) -> float:
    change = min(max(wanted - before, -fall * before), rise * before)
    return before if abs(change) <= LEAST_CHANGE * before else round(before + change, 4)
