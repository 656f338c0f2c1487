"""Makes what one person adds to a prior, from recordings of free and of prompted movement."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from app.calibration.clean_recording import CleanRecording
from app.calibration.prior.arrangement import RingMoments, ring_movement, total
from app.calibration.prior.documents import JointEntry, MomentsDocument, PersonEntry, RingDocument, rounded
from app.calibration.prior.frames import prompted_frames
from app.calibration.prior.moments import Moments, mean_of
from app.calibration.prior.scale import MOVEMENT, first_movement, log_ranges, scales
from app.texts import Figure, Text

Array = NDArray[np.float64]


def person_entry(recordings: Sequence[CleanRecording]) -> PersonEntry:
    """Return what a person adds to a prior: the mean over recordings in one shirt.

    Raises
    ------
    ValueError
        One sentence: a recording is too short, or no joint was prompted and has a channel that can be used.
    """
    layout = recordings[0].layout
    started = [first_movement(recording.free, recording.sample_rate) for recording in recordings]
    for recording, free in zip(recordings, started, strict=True):
        if free is None:
            seconds = Figure(len(recording.free) / recording.sample_rate, 1)
            raise ValueError(Text("calibration-prior-short", seconds=seconds, least=MOVEMENT))
    moved = [free for free in started if free is not None]
    out = {name for recording in recordings for name in recording.left_out}
    joints = {}
    for joint, channels in layout.channels_of_joint.items():
        alive = np.array([layout.channels[i].name not in out for i in channels])
        entry = _joint_entry(joint, channels, alive, recordings, moved) if alive.any() else None
        if entry is not None:
            joints[joint] = entry
    if not joints:
        raise ValueError(Text("calibration-prior-no-joint"))
    rings = {}
    for ring, sensors in layout.rings.items():
        if not any(layout.channels[i].name in out for i in sensors):
            moments = [
                RingMoments.of(ring_movement(free[:, sensors], recording.sample_rate))
                for recording, free in zip(recordings, moved, strict=True)
            ]
            names = [layout.channels[i].name for i in sensors]
            rings[ring] = RingDocument.of(total(moments) * (1.0 / len(moments)), names)
    return PersonEntry(recordings=len(recordings), joints=joints, rings=rings)


def _joint_entry(
    joint: str,
    channels: Sequence[int],
    alive: NDArray[np.bool_],
    recordings: Sequence[CleanRecording],
    moved: Sequence[Array],
) -> JointEntry | None:
    """Return what the recordings add to one joint; None when none of them prompts it."""
    used = [i for i, is_alive in zip(channels, alive, strict=True) if is_alive]
    logs, moments, seconds, strokes = [], [], 0.0, 0
    for recording, free in zip(recordings, moved, strict=True):
        ranges = log_ranges(free[:, used], recording.sample_rate)
        if not np.isfinite(ranges).all():
            continue
        frames = prompted_frames(
            recording.stretches_of(joint), used, scales(ranges, np.ones(len(used), np.bool_)), recording.sample_rate
        )
        if frames is not None:
            logs.append(ranges)
            moments.append(Moments.of(frames.features, frames.label))
            seconds += len(frames.label) / recording.sample_rate
            strokes += frames.repetitions
    if not moments:
        return None
    everywhere = np.zeros(len(channels))
    everywhere[alive] = np.mean(logs, axis=0)
    return JointEntry(
        alive=tuple(alive.tolist()),
        logs=rounded(everywhere),
        seconds=round(seconds, 2),
        strokes=float(strokes),
        moments=MomentsDocument.of(mean_of(moments).at_places(np.flatnonzero(alive), len(channels))),
    )
