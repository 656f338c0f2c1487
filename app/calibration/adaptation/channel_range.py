"""Shifts the calibrated ranges of the channels after the shirt was put on again.

Safety rule S5 silences a gesture while one of its channels is outside 1.5 times its calibrated range. Putting the shirt
on again moves the levels of the channels by up to two standard deviations of their movement, so that S5 would take
sound channels for broken ones. After a trial, therefore, the range of a channel is shifted, never widened, and only
while the channel still moves with its joint. A loose channel does not, keeps its calibrated range and is detected by
S5.
"""

from collections.abc import Collection, Sequence

import numpy as np

from app.calibration.adaptation.movement import Movement, Numbers
from app.calibration.channel_quality import channel_quality
from app.calibration.gaps import fill_forward
from app.calibration.profile import CalibrationProfile, JointMap

RANGE_PERCENTILES = (0.5, 99.5)  # of the samples of the last trials: single spikes are left out
LEAST_AGREEMENT = 0.7  # multiple correlation: the joint's other channels explain half of the channel's variance
LARGEST_SHIFT = 1.0  # as a share of the range's width, from the calibrated range
SLACK = 0.1  # as a share of the range's width: smaller shifts are not made. S5 allows 0.25 on either side
SOUND_CONDITIONS = {"good", "near", "noisy"}


def shift_ranges(
    profile: CalibrationProfile,
    movements: Sequence[Movement],
    calibrated: CalibrationProfile | None = None,
    joints: Collection[str] | None = None,
) -> CalibrationProfile:
    """Return the profile with ranges and means shifted to the present levels; `profile` itself when all ranges fit.

    `calibrated` is the calibration that `profile` descends from: no range is shifted further from it than its width.
    `joints` are those whose channels may be shifted; all when not given.
    """
    trials = [
        fill_forward(np.asarray(movement.values, dtype=np.float64)) for movement in movements if len(movement.values)
    ]
    if not trials:
        return profile
    origin = calibrated or profile
    values = np.concatenate(trials)
    shifts = np.zeros(values.shape[1])
    for joint in profile.joints if joints is None else [joint for joint in profile.joints if joint.name in joints]:
        for channel in sound_channels(profile, joint, movements):
            shift = _shift(profile, origin, channel, values[:, channel])
            if shift and agreement(joint, channel, values) >= LEAST_AGREEMENT:
                shifts[channel] = shift
    return with_ranges(profile, np.array(profile.low) + shifts, np.array(profile.high) + shifts)


def with_ranges(profile: CalibrationProfile, low: Numbers, high: Numbers) -> CalibrationProfile:
    """Return the profile with other ranges (n_channels,), and the means moved as the middles of the ranges move.

    `profile` itself when no range differs.
    """
    before = np.array(profile.low), np.array(profile.high)
    if np.array_equal(before[0], low) and np.array_equal(before[1], high):
        return profile
    moved = (low + high - before[0] - before[1]) / 2
    return profile.model_copy(
        update={
            "low": tuple(float(value) for value in low),
            "high": tuple(float(value) for value in high),
            "joints": tuple(
                joint.model_copy(
                    update={"mean": tuple(float(v) for v in np.array(joint.mean) + moved[list(joint.channels)])}
                )
                for joint in profile.joints
            ),
        }
    )


def sound_channels(profile: CalibrationProfile, joint: JointMap, movements: Sequence[Movement]) -> list[int]:
    """Return the joint's channels that have a weight in the map and were neither flat nor railed nor missing."""
    sound = {channel for channel, weight in zip(joint.channels, joint.pca.rates[0], strict=True) if weight != 0.0}
    groups = [profile.layout.channels_of_joint[joint.name]]
    for movement in movements:
        if len(movement.values):
            quality = channel_quality(np.asarray(movement.values, dtype=np.float64), groups, movement.sample_rate)
            sound -= {channel for channel in sound if quality[channel].condition not in SOUND_CONDITIONS}
    return sorted(sound)


def agreement(joint: JointMap, channel: int, values: Numbers) -> float:
    """Return the multiple correlation (0..1) of a channel with the joint's other channels, 1 when there are none.

    The map's score is no reference for this: a sound channel may measure a second movement of the joint, to which the
    map gives hardly any weight.
    """
    others = [other for other in joint.channels if other != channel]
    if not others:
        return 1.0
    signal, neighbours = (
        values[:, channel] - values[:, channel].mean(),
        values[:, others] - values[:, others].mean(axis=0),
    )
    total = float(signal @ signal)
    if not 0.0 < total < np.inf or not np.isfinite(neighbours).all():
        return 0.0
    shared = neighbours.T @ signal
    explained = float(shared @ np.linalg.pinv(neighbours.T @ neighbours, hermitian=True) @ shared)
    return float(np.sqrt(min(1.0, max(0.0, explained / total))))


def _shift(profile: CalibrationProfile, origin: CalibrationProfile, channel: int, signal: Numbers) -> float:
    """Return the smallest shift (signal units) after which the range holds `signal` (n,), limited by LARGEST_SHIFT."""
    low, high = profile.low[channel], profile.high[channel]
    bottom, top = (float(value) for value in np.percentile(signal, RANGE_PERCENTILES))
    if top - bottom > high - low:
        wanted = (top + bottom - high - low) / 2  # the signal is wider than the range: align their middles
    else:
        wanted = max(0.0, top - high) + min(0.0, bottom - low)
        if abs(wanted) <= SLACK * (high - low):
            return 0.0
    reach = LARGEST_SHIFT * (high - low)
    return min(max(wanted, origin.low[channel] - reach - low), origin.low[channel] + reach - low)
