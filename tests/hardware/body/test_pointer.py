"""The simulated person in the interface test: practice shows, the seed decides, and driving is as before."""

import numpy as np
import pytest

from app.calibration.vocabulary import standard_parameters
from app.hardware.base import BodyView
from app.hardware.body.person import SimulatedPerson
from app.study.experiment import shirt_layout
from app.study.interface_sessions import do_interface_test
from app.study.participant import Participant
from app.study.simulated_calibration import SAMPLE_RATE, calibrate
from app.world.cursor_task import CursorPlan

PLAN = CursorPlan(seed=1, duration=60.0)


@pytest.fixture(scope="module")
def figures():
    def tested(skill, seed=3):
        participant = Participant(SimulatedPerson(skill, seed), shirt_layout(), SAMPLE_RATE, seed)
        return do_interface_test(participant, standard_parameters(calibrate(participant)), PLAN)

    return {"practised": tested("practised"), "again": tested("practised"), "novice": tested("novice")}


def test_practice_shows_in_the_measures(figures):
    practised, novice = figures["practised"], figures["novice"]
    assert practised.complete
    assert practised.acquisitions_per_minute > 1.2 * novice.acquisitions_per_minute > 6.0
    assert practised.throughput > novice.throughput
    assert practised.path_efficiency > novice.path_efficiency
    assert all(one.acquired for one in practised.directions.values())


def test_equal_seeds_give_equal_measures(figures):
    assert figures["practised"] == figures["again"]


def test_nobody_points_without_a_cursor():
    person = SimulatedPerson("practised", 1)
    for _ in range(300):
        posture = person.step(0.01, BodyView())
    assert person.pointer._open is None
    assert np.abs(posture).max() < 0.05
    assert person.driver.strokes.session_strokes == 0
