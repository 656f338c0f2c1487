"""Fits the ranges of the channels to the shirt as it sits today, from ten seconds of any movement.

Putting a shirt on again changes how strongly each channel answers and where its level lies. Free movement shows both,
without cues: the extent of each channel is compared with the extents of the other channels of its joint. Their common
extent depends on how large the movements were, and not on how the shirt sits, so that it changes nothing. The maps do
not change either: over the channels of a joint the changes cancel (docs/learning/adapting.md, "Does it help?").
"""

from typing import NamedTuple

import numpy as np

from app.calibration.adaptation.channel_range import (
    LARGEST_SHIFT,
    LEAST_AGREEMENT,
    agreement,
    sound_channels,
    with_ranges,
)
from app.calibration.adaptation.movement import Movement, Numbers
from app.calibration.gaps import fill_forward
from app.calibration.profile import CalibrationProfile, JointMap

RANGE = (5.0, 95.0)  # percentiles of the movement that the answer of a channel is taken from
LEVELS = (0.5, 99.5)  # percentiles whose middle becomes the middle of the range
LARGEST_RATIO = 2.0  # between a channel's answer today and at the calibration
FEWEST = 2  # channels of a joint that can be compared with each other


class ChannelSeat(NamedTuple):
    """How a channel answers today, in comparison with its calibration and the other channels of its joint."""

    channel: int  # index into a frame
    ratio: float  # of its answer today to that at the calibration, the joint's mean taken away
    middle: float  # signal units, between its present levels


def fit_ranges(profile: CalibrationProfile, free: Movement, calibrated: CalibrationProfile) -> CalibrationProfile:
    """Return the profile with the ranges that safety rule S5 checks, for the shirt as it sits in the movement `free`.

    A range is that of `calibrated`, centred on the present levels, moved by at most its width, and widened by as much
    as the channel answers more strongly than at the calibration, at most twice. A channel that the joint's other
    channels do not predict keeps its calibrated range, by which a loose one is detected.
    """
    values = fill_forward(np.asarray(free.values, dtype=np.float64))
    if not len(values):
        return profile
    low, high = np.array(profile.low), np.array(profile.high)
    for joint in calibrated.joints:
        for seat in channel_seats(calibrated, joint, free, values):
            first, last = calibrated.low[seat.channel], calibrated.high[seat.channel]
            middle, reach = (first + last) / 2, LARGEST_SHIFT * (last - first)
            middle = min(max(seat.middle, middle - reach), middle + reach)
            half = max(1.0, seat.ratio) * (last - first) / 2
            low[seat.channel], high[seat.channel] = middle - half, middle + half
    return with_ranges(profile, low, high)


def channel_seats(profile: CalibrationProfile, joint: JointMap, free: Movement, values: Numbers) -> list[ChannelSeat]:
    """Return how the joint's sound channels answer in `values` (n, n_channels), those of `free` without holes."""
    width = np.array(profile.high) - np.array(profile.low)
    sound = [
        channel
        for channel in sound_channels(profile, joint, [free])
        if width[channel] > 0.0 and agreement(joint, channel, values) >= LEAST_AGREEMENT
    ]
    moved = np.ptp(np.percentile(values[:, sound], RANGE, axis=0), axis=0) if sound else np.empty(0)
    if len(sound) < FEWEST or not (moved > 0.0).all():
        return []
    ratio = np.log(moved / width[sound])
    ratio = np.exp(np.minimum(ratio - ratio.mean(), np.log(LARGEST_RATIO)))
    middle = np.percentile(values[:, sound], LEVELS, axis=0).mean(axis=0)
    return [ChannelSeat(*row) for row in zip(sound, ratio.tolist(), middle.tolist(), strict=True)]
