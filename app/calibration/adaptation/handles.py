"""Dead-zone and full of a gesture, from rest noise and strokes of the last trials (signal-chain.md, section 6)."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from app.calibration.adaptation.movement import Heard, Numbers, rest_noise, strokes
from app.calibration.fit.joint_fit import LEAST_RANGE, REST_NOISE_FACTOR, SMALLEST_DEAD_ZONE
from app.calibration.profile import JointMap
from app.calibration.vocabulary import Gesture

FEWEST_STROKES = 9
ALIKE = 0.25  # of full: strokes are no prompts; with nothing changed, they ask for 0.85 to 1.23 of what prompts did
DEAD_ZONE_STEP = 0.10  # of itself, at most, for each new trial
DEAD_ZONE_UPDATE = 0.20  # of itself, at most, however many trials there were
FULL_STEP = 0.04
FULL_UPDATE = 0.08
FURTHEST = 2.5  # times the full that the calibration suggested, or its part: beyond it, calibrate again
LARGEST_SHARE = 0.5  # of that full, for the dead-zone: half of the movement must stay to drive with
WORTH_IT = 0.01  # of itself: a smaller change is chance, and no new version


class Handles(NamedTuple):
    """The two handles of a gesture, FS/s."""

    dead_zone: float
    full: float


def wanted_dead_zone(joint: JointMap, heard: Sequence[Heard], rates: Sequence[Numbers]) -> float | None:
    """Return the dead-zone that the rest of the last trials asks for, None when there was too little of it."""
    noise = rest_noise(rates, [trial.sample_rate for trial in heard])
    if noise is None:
        return None
    return min(max(REST_NOISE_FACTOR * noise, SMALLEST_DEAD_ZONE), max(LARGEST_SHARE * joint.full, joint.dead_zone))


def wanted_full(joint: JointMap, heard: Sequence[Heard], rates: Sequence[Numbers], gesture: Gesture) -> float | None:
    """Return the full that the strokes of the last trials ask for; None when they ask for none that is clearly another.

    As in the calibration, the 90th percentile of the rates above the dead-zone.
    """
    found = strokes(heard, joint.name, rates, gesture.dead_zone)
    if len(found) < FEWEST_STROKES:
        return None
    asked = float(np.percentile(np.concatenate(found), 90))
    if abs(asked - gesture.full) <= ALIKE * gesture.full:
        return None
    return min(max(asked, joint.full / FURTHEST), joint.full * FURTHEST)


def stepped(gesture: Gesture, wanted: Handles, fresh: int) -> Handles:
    """Return the handles after one careful step from `gesture` towards `wanted`, `fresh` trials since the last."""
    dead_zone = _step(gesture.dead_zone, wanted.dead_zone, min(DEAD_ZONE_UPDATE, DEAD_ZONE_STEP * fresh))
    full = _step(gesture.full, wanted.full, min(FULL_UPDATE, FULL_STEP * fresh))
    if full < dead_zone + LEAST_RANGE:
        return Handles(gesture.dead_zone, gesture.full)  # a slope must stay: nothing is better than a switch
    return Handles(dead_zone, full)


def _step(before: float, wanted: float, most: float) -> float:
    change = min(max(wanted - before, -most * before), most * before)
    return before if abs(change) <= WORTH_IT * before else round(before + change, 4)
