"""Simulated people who wear one and the same simulated shirt: what each adds to a prior, and what a prior gives one."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.repetitions import stretch_of_run
from app.calibration.prior.documents import OwnPrior
from app.calibration.prior.entry import person_entry
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import with_prior_maps
from app.calibration.profile import CalibrationProfile
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import NOVICE, PRACTISED
from app.layout import ShirtLayout
from app.study.participant import Participant
from app.study.simulated_calibration import StepRecording, fit_recorded, record_calibration

GARMENT = 1  # seed of the simulated shirt that a control process starts with
SAMPLE_RATE = 100.0  # Hz


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
    found = [stretch_of_run(values, cue, step.cues) for step, values, cue in recorded if step.kind == "prompt"]
    stretches = [stretch for stretch in found if stretch is not None]
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
    joints = tuple(one.model_copy(update={"map": "prior"}) if one.prior else one for one in fitted.joints)
    return fitted.model_copy(update={"joints": joints})
