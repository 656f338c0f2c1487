"""Which values of a channel are this body's, after the shirt was put on again.

Safety's S5 silences a gesture while one of its channels is outside 1.5 times its calibrated range. Putting the shirt on
again moves the levels of the channels by up to two standard deviations of their movement, and then sound channels
are taken for broken ones. So the range is moved along, never widened, and only for a channel that is seen to move with
its joint as it did: one that hangs loose keeps the range that exposes it.
"""

from collections.abc import Sequence

import numpy as np

from app.calibration.adaptation.movement import Movement, Numbers
from app.calibration.fit.pieces import fill_forward
from app.calibration.profile import CalibrationProfile, JointMap
from app.calibration.quality import channel_quality

SEEN = (0.5, 99.5)  # percentiles: a single spike is no range
LEAST_AGREEMENT = 0.7  # multiple correlation: half of a channel is told by the rest of its joint
FURTHEST = 1.0  # of the range's own width, away from the calibration
SLACK = 0.1  # of the width, either way: S5 leaves a quarter on either side of it
SOUND = {"good", "near", "noisy"}


def range_moved(
    profile: CalibrationProfile, movements: Sequence[Movement], calibrated: CalibrationProfile | None = None
) -> CalibrationProfile:
    """Return the profile with ranges and means moved to where the channels are now; the same when all fit.

    `calibrated` is the calibration that the profile goes back to; ranges stay within their own width of it.
    """
    seen = [fill_forward(np.asarray(one.values, dtype=np.float64)) for one in movements if len(one.values)]
    if not seen:
        return profile
    origin = calibrated or profile
    values = np.concatenate(seen)
    shift = np.zeros(values.shape[1])
    for joint in profile.joints:
        for channel in sound_channels(profile, joint, movements):
            moved = _shift(profile, origin, channel, values[:, channel])
            if moved and _agreement(joint, channel, values) >= LEAST_AGREEMENT:
                shift[channel] = moved
    if not shift.any():
        return profile
    return profile.model_copy(
        update={
            "low": tuple(float(value) for value in np.array(profile.low) + shift),
            "high": tuple(float(value) for value in np.array(profile.high) + shift),
            "joints": tuple(
                joint.model_copy(
                    update={"mean": tuple(float(v) for v in np.array(joint.mean) + shift[list(joint.channels)])}
                )
                for joint in profile.joints
            ),
        }
    )


def sound_channels(profile: CalibrationProfile, joint: JointMap, movements: Sequence[Movement]) -> list[int]:
    """Return which of the joint's channels the map weighs, and that were neither dead nor railed nor gone."""
    sound = {channel for channel, weight in zip(joint.channels, joint.weights, strict=True) if weight != 0.0}
    groups = [profile.layout.channels_of_joint[joint.name]]
    for one in movements:
        if len(one.values):
            quality = channel_quality(np.asarray(one.values, dtype=np.float64), groups, one.sample_rate)
            sound -= {channel for channel in sound if quality[channel].condition not in SOUND}
    return sorted(sound)


def _agreement(joint: JointMap, channel: int, values: Numbers) -> float:
    """Return how well the joint's other channels tell a channel: their multiple correlation, 1 when it is alone.

    Not its correlation with the map: a channel that feels the joint's second way to move, and so has next to no weight,
    is sound all the same.
    """
    others = [other for other in joint.channels if other != channel]
    if not others:
        return 1.0
    signal, known = values[:, channel] - values[:, channel].mean(), values[:, others] - values[:, others].mean(axis=0)
    total = float(signal @ signal)
    if not 0.0 < total < np.inf or not np.isfinite(known).all():
        return 0.0
    shared = known.T @ signal
    told = float(shared @ np.linalg.pinv(known.T @ known, hermitian=True) @ shared)
    return float(np.sqrt(min(1.0, max(0.0, told / total))))


def _shift(profile: CalibrationProfile, origin: CalibrationProfile, channel: int, signal: Numbers) -> float:
    """Return the smallest shift of the range (signal units) that takes in what is seen, kept near the calibration."""
    low, high = profile.low[channel], profile.high[channel]
    bottom, top = (float(value) for value in np.percentile(signal, SEEN))
    if top - bottom > high - low:
        wanted = (top + bottom - high - low) / 2  # it does not fit: about the middle
    else:
        wanted = max(0.0, top - high) + min(0.0, bottom - low)
        if abs(wanted) <= SLACK * (high - low):
            return 0.0
    reach = FURTHEST * (high - low)
    return min(max(wanted, origin.low[channel] - reach - low), origin.low[channel] + reach - low)
