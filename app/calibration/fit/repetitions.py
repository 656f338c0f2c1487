"""Cuts the repetitions of prompted movements out of recordings."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.cues import Cue

BEFORE = 0.5  # s kept before a movement, in which the low-pass settles
AFTER = 1.0  # s kept after a movement, because people lag behind the cue
AROUND = 3.0  # s kept before the first and after the last prompt of a stretch: the way back and some rest
LONGEST_PAUSE = 10.0  # s: prompts further apart belong to two stretches, as the movement between them is unknown


@dataclass(frozen=True, slots=True)
class Repetition:
    """One prompted movement: the frames around it, and the rows of the movement towards the gesture."""

    joint: str
    values: NDArray[np.float64]  # (n, n_channels)
    moving: slice


@dataclass(frozen=True, slots=True)
class Stretch:
    """A continuous recording of several prompted movements of one joint, with ways back and pauses."""

    joint: str
    values: NDArray[np.float64]  # (n, n_channels)
    moving: tuple[slice, ...]  # in order of time


@dataclass(frozen=True, slots=True)
class Prompt:
    """One row of a table of prompts: the joint moved towards the gesture from `start` to `end` (s)."""

    start: float
    end: float
    joint: str


def repetitions_of_run(
    values: NDArray[np.floating], cue: NDArray[np.integer], cues: Sequence[Cue], sample_rate: float
) -> list[Repetition]:
    """Return the repetitions of one recorded `prompt` step.

    Parameters
    ----------
    values : (n, n_channels) array
        The recorded frames.
    cue : (n,) array
        Index into `cues` for each frame, as the recording carries it.
    cues : sequence of Cue
        The cues of the step, to which `cue` refers.
    sample_rate : float
        Hz.
    """
    repetitions = []
    for index, prompt in enumerate(cues):
        rows = np.flatnonzero(cue == index)
        if prompt.kind == "move" and prompt.joint is not None and len(rows) > 1:
            repetitions.append(_cut(values, prompt.joint, int(rows[0]), int(rows[-1]) + 1, sample_rate))
    return repetitions


def stretch_of_run(values: NDArray[np.floating], cue: NDArray[np.integer], cues: Sequence[Cue]) -> Stretch | None:
    """Return one recorded `prompt` step as a stretch, None without a prompt; parameters as of `repetitions_of_run`."""
    moving = []
    for index, prompt in enumerate(cues):
        rows = np.flatnonzero(cue == index)
        if prompt.kind == "move" and prompt.joint is not None and len(rows) > 1:
            joint = prompt.joint
            moving.append(slice(int(rows[0]), int(rows[-1]) + 1))
    return Stretch(joint, np.asarray(values, np.float64), tuple(moving)) if moving else None


def stretches_of_prompts(
    t: NDArray[np.float64],
    values: NDArray[np.floating],
    prompts: Sequence[Prompt],
    sample_rate: float,
    until: float | None = None,
    longest_pause: float = LONGEST_PAUSE,
) -> list[Stretch]:
    """Return the stretches around the prompts of a table, those of a joint in order of time.

    A stretch ends at `until` (s) at the latest, but not before its last prompt. Prompts of a joint that are further
    apart than `longest_pause` (s) belong to two stretches.
    """
    merged = _merge_overlapping(prompts)
    stretches = []
    for joint in dict.fromkeys(prompt.joint for prompt in merged):
        groups: list[list[Prompt]] = []
        for prompt in (merged_prompt for merged_prompt in merged if merged_prompt.joint == joint):
            if groups and prompt.start - groups[-1][-1].end <= longest_pause:
                groups[-1].append(prompt)
            else:
                groups.append([prompt])
        stretches += [_stretch(t, values, group, sample_rate, until) for group in groups]
    return [stretch for stretch in stretches if stretch.moving]


def repetitions_of_prompts(
    t: NDArray[np.float64], values: NDArray[np.floating], prompts: Sequence[Prompt], sample_rate: float
) -> list[Repetition]:
    """Return the repetitions of a table of prompts from one long recording; overlapping prompts count as one."""
    repetitions = []
    for prompt in _merge_overlapping(prompts):
        first, last = np.searchsorted(t, (prompt.start, prompt.end))
        if last - first > 1:
            repetitions.append(_cut(values, prompt.joint, int(first), int(last), sample_rate))
    return repetitions


def _cut(values: NDArray[np.floating], joint: str, first: int, last: int, sample_rate: float) -> Repetition:
    start = max(0, first - round(BEFORE * sample_rate))
    end = min(len(values), last + round(AFTER * sample_rate))
    return Repetition(joint, np.asarray(values[start:end], np.float64), slice(first - start, last - start))


def _stretch(
    t: NDArray[np.float64],
    values: NDArray[np.floating],
    prompts: Sequence[Prompt],
    sample_rate: float,
    until: float | None,
) -> Stretch:
    rows = [np.searchsorted(t, (prompt.start, prompt.end)) for prompt in prompts]
    around = round(AROUND * sample_rate)
    first, last = max(0, int(rows[0][0]) - around), min(len(values), int(rows[-1][1]) + around)
    if until is not None:
        last = min(last, max(int(np.searchsorted(t, until)), int(rows[-1][1])))
    moving = tuple(slice(int(start) - first, int(end) - first) for start, end in rows if end - start > 1)
    return Stretch(prompts[0].joint, np.asarray(values[first:last], np.float64), moving)


def _merge_overlapping(prompts: Sequence[Prompt]) -> list[Prompt]:
    """Return the prompts in order of time, overlapping prompts of one joint merged into one."""
    merged: list[Prompt] = []
    newest: dict[str, int] = {}
    for prompt in sorted(prompts, key=lambda row: row.start):
        index = newest.get(prompt.joint)
        if index is not None and prompt.start < merged[index].end:
            merged[index] = Prompt(merged[index].start, max(merged[index].end, prompt.end), prompt.joint)
        else:
            newest[prompt.joint] = len(merged)
            merged.append(prompt)
    return merged
