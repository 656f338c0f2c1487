"""The calibration of a study's participant, with the script and the fit of the application."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Repetition, Stretch, repetitions_of_run, stretch_of_run
from app.calibration.guided.guided_map import with_guided_maps
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step, calibration_script
from app.cues import cue_index
from app.layout import ShirtLayout
from app.messages import NO_CUE
from app.study.choices import StudyMap
from app.study.participant import Participant

StepRecording = tuple[Step, NDArray[np.float32], NDArray[np.int32]]
"""A step, its frames (n, n_channels), and the index of each frame's cue (n,)."""


def calibrate(participant: Participant, map_kind: StudyMap = "pca") -> CalibrationProfile:
    """Record rest, free movement and prompts of the participant, and fit the profile.

    With `guided`, what is learnt from the cues decodes each joint where it can be learnt.

    Raises
    ------
    ValueError
        When no joint can be mapped.
    """
    recorded = record_calibration(participant)
    recording = clean_recording(participant.layout, participant.sample_rate, recorded)
    profile = fit_profile(recording)
    if map_kind == "pca":
        return profile
    fitted = with_guided_maps(profile, recording).profile
    joints = tuple(one.model_copy(update={"map": "guided"}) if one.guided else one for one in fitted.joints)
    return fitted.model_copy(update={"joints": joints})


def record_calibration(participant: Participant) -> list[StepRecording]:
    """Record rest, free movement and prompts of the participant."""
    return [(step, *record_step(participant, step)) for step in calibration_script(participant.layout)]


def fit_recorded(layout: ShirtLayout, sample_rate: float, recorded: Sequence[StepRecording]) -> CalibrationProfile:
    """Fit the profile of recorded steps as the application does; ValueError when no joint can be mapped."""
    return fit_profile(clean_recording(layout, sample_rate, recorded))


def clean_recording(layout: ShirtLayout, sample_rate: float, recorded: Sequence[StepRecording]) -> CleanRecording:
    """Return recorded steps made ready for the fits; ValueError when they cannot be."""
    rest = free = None
    repetitions: list[Repetition] = []
    stretches: list[Stretch] = []
    for step, values, cue in recorded:
        within = np.array([index != NO_CUE and step.cues[index].kind == step.kind for index in cue])
        if step.kind == "rest":
            rest = values[within]
        elif step.kind == "free":
            free = values[within]
        else:
            repetitions += repetitions_of_run(values, cue, step.cues, sample_rate)
            stretch = stretch_of_run(values, cue, step.cues)
            stretches += [stretch] if stretch else []
    if free is None:
        raise ValueError("the calibration's script has no free movement: add one")
    return CleanRecording.of(layout, sample_rate, free, rest, repetitions, stretches)


def record_step(participant: Participant, step: Step) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """Return the frames of one step (n, n_channels), and the index of each frame's cue (n,)."""
    count = round(step.duration * participant.sample_rate)
    values = np.empty((count, len(participant.layout.channels)), dtype=np.float32)
    cue = np.empty(count, dtype=np.int32)
    for i in range(count):
        run_t = i / participant.sample_rate
        cue[i] = cue_index(step.cues, run_t)
        asked = None if cue[i] == NO_CUE else step.cues[cue[i]]
        values[i] = participant.follow(asked, run_t - asked.start if asked else 0.0).values
    return values, cue
