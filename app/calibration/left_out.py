"""Decides which channels a calibration leaves out of the map, and says why."""

from collections.abc import Collection, Sequence

import numpy as np

from app.calibration.pieces import Frames
from app.calibration.quality import ChannelQuality, channel_quality, worst
from app.calibration.repetitions import Repetition
from app.layout import ShirtLayout

# What the short stretches of the prompts can show; noise is judged on the long free movement.
SEEN_IN_PROMPTS = {"near", "railed", "flat", "nan"}


def channels_left_out(
    layout: ShirtLayout,
    sample_rate: float,
    free: Frames,
    rest: Frames | None,
    repetitions: Sequence[Repetition],
    unused: Collection[str],
    full_scale: float | None,
) -> dict[str, str]:
    """Return why channels are left out of the map; one near its rails only where the joint keeps a better one."""
    groups = layout.channels_of_joint
    quality = channel_quality(free, list(groups.values()), sample_rate, full_scale)
    if rest is not None:
        at_rest = channel_quality(rest, list(groups.values()), sample_rate, full_scale, moving=False)
        quality = [worst(one, other) for one, other in zip(quality, at_rest, strict=True)]
    for joint, indices in groups.items():
        own = [one.values for one in repetitions if one.joint == joint]
        if own:
            prompted = channel_quality(np.concatenate(own), [indices], sample_rate, full_scale)
            findings = {i: prompted[i] for i in indices if prompted[i].condition in SEEN_IN_PROMPTS}
            if len(findings) < len(indices):  # all of them: the joint stood still, which is no channel's fault
                for i, finding in findings.items():
                    quality[i] = worst(quality[i], finding)
    left_out: dict[str, str] = {}
    for indices in groups.values():
        best_left = any(quality[i].condition == "good" and layout.channels[i].name not in unused for i in indices)
        for i in indices:
            name = layout.channels[i].name
            if name in unused:
                left_out[name] = "marked as unused"
            elif _is_bad(quality[i], best_left):
                left_out[name] = quality[i].words
    return left_out


def _is_bad(quality: ChannelQuality, near_too: bool) -> bool:
    return quality.condition not in {"good", "near"} or (quality.condition == "near" and near_too)
