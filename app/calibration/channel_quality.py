"""The condition of each channel of a recording: good, near its rails, railed, flat, noisy, or without numbers."""

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.texts import Figure, Text

Condition = Literal["good", "near", "railed", "flat", "noisy", "nan"]

RAILED = 0.9  # of full scale
NEAR_RAILED = 0.75
CLIPPED_SHARE = 0.05  # of the samples at the extreme value, when the full scale is unknown
COARSE = 50  # distinct values: a channel with at most so many can stay at its extreme without being clipped
STILL_TIME = 0.2  # s without any change, after which a channel counts as still: fabric always trembles a little
STILL_SHARE = 0.5  # of the time in which the joint's other channels moved
NOISE_SHARE = 0.5  # of the channel's standard deviation: above it, the channel is mostly noise
NOISE_THAT_MATTERS = 0.1  # of the joint's strongest channel: PCA gives weaker channels hardly any weight
NOISE_RATE = 100.0  # Hz at which noise is measured: in oversampled signals, differences understate it


class ChannelQuality(NamedTuple):
    """The condition of one channel, also in words."""

    condition: Condition
    message: Text | None  # to stand behind the channel's name; None when it is good


GOOD = ChannelQuality("good", None)


def channel_quality(
    values: NDArray[np.float64],
    groups: Sequence[Sequence[int]],
    sample_rate: float,
    full_scale: float | None = None,
    moving: bool = True,
) -> list[ChannelQuality]:
    """Return the condition of every channel over one part of a recording.

    Parameters
    ----------
    values : (n, n_channels) array
        Signal units, NaN where a sample is missing. Frames without any number are lost frames and are not counted.
    groups : sequence of index lists
        The channels of each joint: a channel is flat or clipped only when other channels of its joint moved meanwhile.
    sample_rate : float
        Hz.
    full_scale : float or None
        Largest absolute value that the shirt's electronics can give, in signal units. When it is not known, a channel
        counts as railed if it is at its extreme value for more than 5 % of the time.
    moving : bool
        False for a recording at rest: then `flat` and `noisy` are not tested.
    """
    quality = [GOOD] * values.shape[1]
    missing = np.isnan(values)
    lost = missing.all(axis=1)
    if lost.all():
        return [ChannelQuality("nan", Text("calibration-channel-no-numbers"))] * values.shape[1]
    frames = values[~lost] if lost.any() else values
    gaps = missing.sum(axis=0) - lost.sum()
    thinned = frames[:: max(1, round(sample_rate / NOISE_RATE))]
    block = max(2, round(STILL_TIME * min(sample_rate, NOISE_RATE)))
    for channels in groups:
        whole = [i for i in channels if not gaps[i]]
        for i in channels:
            if gaps[i]:
                missed = Text("calibration-channel-nan", count=int(gaps[i]), samples=len(frames))
                quality[i] = ChannelQuality("nan", missed)
            else:
                quality[i] = _railed(frames[:, i], full_scale)
        if full_scale is None:
            _find_clipped(frames, whole, quality)
        if moving and whole:
            _find_flat(thinned, block, whole, quality)
            _find_noisy(thinned, [i for i in whole if quality[i].condition == "good"], quality)
    return quality


def worse_of(first: ChannelQuality, second: ChannelQuality) -> ChannelQuality:
    """Return the worse of two qualities of one channel; the first one when both are bad."""
    if first.condition == "good" or (first.condition == "near" and second.condition not in {"good", "near"}):
        return second
    return first


def _railed(signal: NDArray[np.float64], full_scale: float | None) -> ChannelQuality:
    if full_scale is None:
        return GOOD
    reached = max(abs(float(signal.min())), abs(float(signal.max()))) / full_scale
    if reached > RAILED:
        return ChannelQuality("railed", Text("calibration-channel-railed", percent=Figure(100 * reached)))
    if reached > NEAR_RAILED:
        return ChannelQuality("near", Text("calibration-channel-near", percent=Figure(100 * reached)))
    return GOOD


def _find_clipped(values: NDArray[np.float64], channels: list[int], quality: list[ChannelQuality]) -> None:
    """Mark channels that stay at their extreme value while other channels of the joint move."""
    if len(channels) < 2:
        return
    signals = values[:, channels].T.copy()
    changed = np.diff(signals, axis=1) != 0
    some_moved = changed.sum(axis=0)
    for row, i in enumerate(channels):
        signal = signals[row]
        for end, extreme in (("upper", signal.max()), ("lower", signal.min())):
            at_end = signal[1:] == extreme
            if at_end.mean() <= CLIPPED_SHARE:  # the usual case
                continue
            others_moved = some_moved - changed[row] > 0
            share = float((at_end & ~changed[row] & others_moved).mean())
            if CLIPPED_SHARE < share < STILL_SHARE and len(np.unique(signal)) > COARSE:
                clipped = Text("calibration-channel-clipped", end=end, percent=Figure(100 * share))
                quality[i] = ChannelQuality("railed", clipped)


def _find_flat(values: NDArray[np.float64], block: int, channels: list[int], quality: list[ChannelQuality]) -> None:
    """Mark channels that never change, or are still for most of the time in which other channels of the joint move."""
    signals = values[:, channels]
    for i in np.array(channels)[np.ptp(signals, axis=0) == 0]:
        quality[i] = ChannelQuality("flat", Text("calibration-channel-dead"))
    count = len(signals) // block
    if not count:
        return
    blocks = signals[: count * block].reshape(count, block, len(channels))
    still = np.ptp(blocks, axis=1) == 0
    moved = (~still).sum(axis=1)
    for column, i in enumerate(channels):
        others = moved - ~still[:, column] > 0
        share = float((still[:, column] & others).sum() / max(1, others.sum()))
        if quality[i].condition == "good" and share > STILL_SHARE:
            quality[i] = ChannelQuality("flat", Text("calibration-channel-still", percent=Figure(100 * share)))


def _find_noisy(values: NDArray[np.float64], channels: list[int], quality: list[ChannelQuality]) -> None:
    """Mark channels that are mostly noise; when all of them are, the joint did not move, and none is marked."""
    if len(values) < 3 or not channels:
        return
    signals = values[:, channels]
    noise = np.diff(signals, n=2, axis=0).std(axis=0) / np.sqrt(6.0)  # the standard deviation of white noise
    strength = signals.std(axis=0)
    noisy = (noise > NOISE_SHARE * strength) & (noise > NOISE_THAT_MATTERS * strength.max())
    if noisy.all():
        return
    for column in np.flatnonzero(noisy):
        share = min(float(noise[column] / strength[column]), 1.0)
        quality[channels[column]] = ChannelQuality(
            "noisy", Text("calibration-channel-noisy", percent=Figure(100 * share))
        )
