"""Decides which channels a calibration leaves out of the map, and says why."""

from collections.abc import Collection, Mapping, Sequence

import numpy as np

from app.calibration.channel_quality import ChannelQuality, channel_quality, worse_of
from app.calibration.fit.repetitions import Repetition
from app.calibration.gaps import Frames, bridge_gaps, fill_forward, why_missing
from app.layout import ShirtLayout
from app.texts import Text

# Conditions that the short prompts can show; noise is measured in the longer free movement.
PROMPT_CONDITIONS = {"near", "railed", "flat", "nan"}
FEW_MISSING = 0.05  # share of a channel's samples that may be filled forward where a joint has no better channel


def channels_left_out(
    layout: ShirtLayout,
    sample_rate: float,
    free: Frames,
    rest: Frames | None,
    repetitions: Sequence[Repetition],
    unused: Collection[str],
    full_scale: float | None,
) -> dict[str, Text]:
    """Return the names of the channels to leave out of the map, each with the reason in words.

    A channel is kept with gaps of at most 0.2 s and at most 1 % of missing samples in the data that its joint is fitted
    to. A channel near its rails, or with at most 5 % missing, is left out only where the joint keeps a better channel.
    """
    groups = layout.channels_of_joint
    pieces = [free] if rest is None else [free, rest]
    missing = {
        i: reason
        for joint, indices in groups.items()
        for i in indices
        if (reason := why_missing([*pieces, *_values_of(joint, repetitions)], i, sample_rate))
    }
    quality = _quality(
        groups,
        sample_rate,
        bridge_gaps(free, sample_rate),
        None if rest is None else bridge_gaps(rest, sample_rate),
        [
            Repetition(repetition.joint, bridge_gaps(repetition.values, sample_rate), repetition.moving)
            for repetition in repetitions
        ],
        full_scale,
    )
    for i, reason in missing.items():
        quality[i] = ChannelQuality("nan", reason)
    names = layout.channel_names
    good = {i for i, channel in enumerate(quality) if channel.condition == "good" and names[i] not in unused}
    poor = [i for group in groups.values() if not good.intersection(group) for i in group]
    if any(quality[i].condition == "nan" for i in poor):
        moving = [
            Repetition(repetition.joint, _hold_few_missing(repetition.values), repetition.moving)
            for repetition in repetitions
        ]
        resting = None if rest is None else _hold_few_missing(rest)
        second = _quality(groups, sample_rate, _hold_few_missing(free), resting, moving, full_scale)
        for i in poor:
            if second[i].condition != "nan":
                quality[i] = second[i]
    left_out: dict[str, Text] = {}
    for indices in groups.values():
        best_left = any(quality[i].condition == "good" and names[i] not in unused for i in indices)
        for i in indices:
            name = names[i]
            if name in unused:
                left_out[name] = Text("calibration-channel-unused")
            elif (message := quality[i].message) is not None and _is_bad(quality[i], best_left):
                left_out[name] = message
    return left_out


def _quality(
    groups: Mapping[str, list[int]],
    sample_rate: float,
    free: Frames,
    rest: Frames | None,
    repetitions: Sequence[Repetition],
    full_scale: float | None,
) -> list[ChannelQuality]:
    """Return the worst condition of each channel over all pieces of a calibration."""
    quality = channel_quality(free, list(groups.values()), sample_rate, full_scale)
    if rest is not None:
        at_rest = channel_quality(rest, list(groups.values()), sample_rate, full_scale, moving=False)
        quality = [worse_of(first, second) for first, second in zip(quality, at_rest, strict=True)]
    for joint, indices in groups.items():
        joint_values = _values_of(joint, repetitions)
        if joint_values:
            prompted = channel_quality(np.concatenate(joint_values), [indices], sample_rate, full_scale)
            findings = {i: prompted[i] for i in indices if prompted[i].condition in PROMPT_CONDITIONS}
            if len(findings) < len(indices):  # when all channels are affected, the joint stood still
                for i, finding in findings.items():
                    quality[i] = worse_of(quality[i], finding)
    return quality


def _values_of(joint: str, repetitions: Sequence[Repetition]) -> list[Frames]:
    return [repetition.values for repetition in repetitions if repetition.joint == joint]


def _hold_few_missing(values: Frames) -> Frames:
    """Return frames (n, n_channels) with the channels that miss few samples filled forward; lost frames stay NaN."""
    missing = np.isnan(values)
    lost = missing.all(axis=1, keepdims=True)
    few = (missing & ~lost).sum(axis=0) <= FEW_MISSING * (~lost).sum()
    return np.where(few & ~lost, fill_forward(values), values)


def _is_bad(quality: ChannelQuality, near_too: bool) -> bool:
    return quality.condition not in {"good", "near"} or (quality.condition == "near" and near_too)
