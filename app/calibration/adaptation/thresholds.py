"""Adapts dead-zone and full of a gesture to rest noise and strokes of the last trials (signal-chain.md, section 6)."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from app.calibration.adaptation.movement import MappedTrial, Numbers, rest_noise, strokes
from app.calibration.fit.joint_fit import LEAST_RANGE, REST_NOISE_FACTOR, SMALLEST_DEAD_ZONE
from app.calibration.profile import JointMap
from app.calibration.vocabulary import Gesture

FEWEST_STROKES = 9
# As a share of full: smaller differences are not adapted. Strokes differ from prompts: with nothing changed, the full
# computed from strokes is 0.85 to 1.23 times that computed from prompts.
LEAST_DIFFERENCE = 0.25
DEAD_ZONE_STEP = 0.10  # largest relative change of the dead-zone for each new trial
DEAD_ZONE_UPDATE = 0.20  # largest relative change of the dead-zone at once
FULL_STEP = 0.04  # largest relative change of full for each new trial
FULL_UPDATE = 0.08  # largest relative change of full at once
LARGEST_FACTOR = 2.5  # between full and the calibration's full, either way: beyond it, calibrate again
LARGEST_DEAD_ZONE = 0.5  # as a share of the calibration's full: half of the movement is left to drive with
LEAST_CHANGE = 0.01  # relative: smaller changes are chance and make no new version


class Thresholds(NamedTuple):
    """The two adjustable thresholds of a gesture, FS/s."""

    dead_zone: float
    full: float


def wanted_dead_zone(joint: JointMap, trials: Sequence[MappedTrial], rates: Sequence[Numbers]) -> float | None:
    """Return the dead-zone (FS/s) for the noise at rest in the last trials, None when they hold too little rest."""
    noise = rest_noise(rates, [trial.sample_rate for trial in trials])
    if noise is None:
        return None
    return min(max(REST_NOISE_FACTOR * noise, SMALLEST_DEAD_ZONE), max(LARGEST_DEAD_ZONE * joint.full, joint.dead_zone))


def wanted_full(
    joint: JointMap, trials: Sequence[MappedTrial], rates: Sequence[Numbers], gesture: Gesture
) -> float | None:
    """Return the full (FS/s) for the strokes of the last trials: the 90th percentile of the rates above the dead-zone.

    The calibration computes it likewise from the prompts. None for fewer than 9 strokes, or when the present full
    differs by at most 25 %.
    """
    found = strokes(trials, joint.name, rates, gesture.dead_zone)
    if len(found) < FEWEST_STROKES:
        return None
    full = float(np.percentile(np.concatenate(found), 90))
    if abs(full - gesture.full) <= LEAST_DIFFERENCE * gesture.full:
        return None
    return min(max(full, joint.full / LARGEST_FACTOR), joint.full * LARGEST_FACTOR)


def step_thresholds(gesture: Gesture, wanted: Thresholds, fresh: int) -> Thresholds:
    """Return the thresholds after one limited step from `gesture` towards `wanted`.

    `fresh`: number of new trials since the last step; it sets the size of the step.
    """
    dead_zone = _step(gesture.dead_zone, wanted.dead_zone, min(DEAD_ZONE_UPDATE, DEAD_ZONE_STEP * fresh))
    full = _step(gesture.full, wanted.full, min(FULL_UPDATE, FULL_STEP * fresh))
    if full < dead_zone + LEAST_RANGE:
        return Thresholds(gesture.dead_zone, gesture.full)  # no change is better than a gesture that acts as a switch
    return Thresholds(dead_zone, full)


def _step(before: float, wanted: float, most: float) -> float:
    change = min(max(wanted - before, -most * before), most * before)
    return before if abs(change) <= LEAST_CHANGE * before else round(before + change, 4)
