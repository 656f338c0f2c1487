"""Takes a simulated participant through the steps of the calibration: recordings, cued runs and profile."""

from dataclasses import replace

from app.calibration.cued_runs import run_of_cues
from app.calibration.script import calibration_script
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import PRACTISED
from app.hardware.shirt.standard import standard_layout
from app.study.participant import Participant
from app.study.simulated_calibration import fit_recorded, record_step

RATE = 100.0


def simulated_participant(seed=1, tremor=0.0, layout=None):
    person = SimulatedPerson(replace(PRACTISED, tremor=tremor), seed)
    return Participant(person, layout or standard_layout(), RATE, seed)


def record_steps(participant):
    """Return (step, values, cue) of every step."""
    return [(step, *record_step(participant, step)) for step in calibration_script(participant.layout)]


def runs_of(steps):
    return [run_of_cues(values, cue, step.cues) for step, values, cue in steps]


def profile_of(layout, steps):
    return fit_recorded(layout, RATE, steps)
