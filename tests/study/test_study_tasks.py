"""Each kind of task, driven to its end by the simulated person through shirt, map and gate."""

from typing import Any

import pytest

from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import PRACTISED
from app.study.experiment import shirt_layout
from app.study.participant import Participant
from app.study.simulated_calibration import SAMPLE_RATE, calibrate
from app.study.simulated_trial import drive_trial, score_trial
from app.world.scene import bundled_scenes, load_scene


@pytest.fixture(scope="module")
def calibrated_participant() -> tuple[Participant, DriveParameters]:
    """A participant, and the standard parameters of its calibration."""
    participant = Participant(SimulatedPerson(PRACTISED, 1), shirt_layout(), SAMPLE_RATE, 2)
    return participant, standard_parameters(calibrate(participant))


@pytest.fixture
def drive(calibrated_participant):
    """Return a function that drives a task of a bundled scene and returns the trial."""
    participant, parameters = calibrated_participant

    def measured(scene: str, level: Any, task: str):
        plan = load_scene(bundled_scenes()[scene]).plans[level]
        path = plan.path_named(task)
        return score_trial(plan, path, drive_trial(1, participant, parameters, plan, path))

    return measured


def test_backing(drive) -> None:
    trial = drive("backing", "medium", "back")
    assert trial.measures["reached"] is True
    assert trial.v.min() < -0.1
    assert trial.measures["collisions"] == 0


def test_turning_in_place(drive) -> None:
    trial = drive("turning", "hard", "about")
    assert trial.measures["reached"] is True
    assert trial.measures["turn_drift"] < 0.3


def test_passing_a_door(drive) -> None:
    assert drive("door", "medium", "aside").measures["reached"] is True


def test_following_somebody(drive) -> None:
    measures = drive("follow_me", "easy", "person").measures
    assert measures["reached"] is True
    assert measures["follow_error_rms"] < 0.5
    assert measures["follow_near"] > 0.8


def test_a_course_stage_after_stage(drive) -> None:
    measures = drive("skills", "easy", "course").measures
    assert measures["reached"] is True
    assert measures["stages_done"] == measures["stages"] == 7
