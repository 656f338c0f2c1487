"""The calibration of simulated people: with the script and the fit of the application, and with a prior of others."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Repetition, Stretch, repetitions_of_run, stretch_of_run
from app.calibration.guided.guided_map import with_guided_maps
from app.calibration.prior.documents import OwnPrior
from app.calibration.prior.entry import person_entry
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import with_prior_maps
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step, calibration_script
from app.cues import cue_index
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import NOVICE, PRACTISED
from app.layout import ShirtLayout
from app.messages import NO_CUE
from app.study.choices import StudyMap
from app.study.participant import Participant

GARMENT = 1  # seed of the simulated shirt that a control process starts with
SAMPLE_RATE = 100.0  # Hz

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
    joints = tuple(joint.model_copy(update={"map": "guided"}) if joint.guided else joint for joint in fitted.joints)
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
        shown_cue = None if cue[i] == NO_CUE else step.cues[cue[i]]
        values[i] = participant.follow(shown_cue, run_t - shown_cue.start if shown_cue else 0.0).values
    return values, cue


def wearer(layout: ShirtLayout, seed: int) -> Participant:
    """Return a simulated person in a simulated shirt of this layout that others wear as well.

    `seed` determines the body, its practice (from none to twenty-five trials) and how the shirt sits.
    """
    practice = float(np.random.default_rng(seed).uniform(0.0, PRACTISED.practice))
    participant = Participant(SimulatedPerson(replace(NOVICE, practice=practice), seed), layout, SAMPLE_RATE, GARMENT)
    participant.wear(seed)
    return participant


def recording_of(participant: Participant, recorded: Sequence[StepRecording]) -> CleanRecording:
    """Return what a prior reads of the steps of a calibration: the whole step of free movement, and the prompts."""
    free = next(values for step, values, _ in recorded if step.kind == "free")
    all_stretches = [stretch_of_run(values, cue, step.cues) for step, values, cue in recorded if step.kind == "prompt"]
    stretches = [stretch for stretch in all_stretches if stretch is not None]
    return CleanRecording.of(participant.layout, participant.sample_rate, free, stretches=stretches)


def prior_of_wearers(layout: ShirtLayout, seeds: Sequence[int]) -> OwnPrior:
    """Return the prior of simulated people, each calibrated once as the application does it."""
    people = {}
    for seed in seeds:
        participant = wearer(layout, seed)
        people[f"simulated-{seed}"] = person_entry([recording_of(participant, record_calibration(participant))])
    return OwnPrior(layout=layout, people=people)


def calibrate_with_prior(participant: Participant, prior: MapPrior) -> CalibrationProfile:
    """Calibrate with the whole script; what is learnt from other people and the own prompts decodes where it can be.

    Raises
    ------
    ValueError
        When no joint can be mapped.
    """
    recorded = record_calibration(participant)
    profile = fit_recorded(participant.layout, participant.sample_rate, recorded)
    fitted = with_prior_maps(profile, prior, recording_of(participant, recorded)).profile
    joints = tuple(joint.model_copy(update={"map": "prior"}) if joint.prior else joint for joint in fitted.joints)
    return fitted.model_copy(update={"joints": joints})
