"""The simulated person over several sessions: fatigue, range and tremor."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.calibration.vocabulary import standard_parameters
from app.cues import Cue
from app.geometry import Pose
from app.hardware.base import BodyView
from app.hardware.body.driver import Driver
from app.hardware.body.person import TREMOR_BAND, SimulatedPerson, Tremor
from app.hardware.body.person_parameters import (
    DETERIORATING,
    IMPROVING,
    LARGEST_RANGE,
    LARGEST_TREMOR,
    NOVICE,
    PARAMETERS,
    SMALLEST_RANGE,
    PersonParameters,
)
from app.study.experiment import shirt_layout
from app.study.interface_sessions import do_interface_test
from app.study.participant import Participant
from app.study.simulated_calibration import SAMPLE_RATE, calibrate
from app.world.cursor_task import CursorPlan
from app.world.floorplan import FloorPlan

LINE = {"name": "c", "title": "C", "points": ((0.0, 0.0), (6.0, 0.0)), "instruction": "Go."}
PLAN = FloorPlan(name="p", title="P", walls=(), paths=(LINE,))
CUE = Cue(start=0.0, end=1.0, kind="move", joint="right_elbow", repetition=1)


def largest_flexion(person: SimulatedPerson) -> float:
    """Return how far the right elbow moves at a prompt."""
    elbow = person.joints.index("right_elbow")
    return max(person.step(0.01, BodyView(cue=CUE))[elbow] for _ in range(150))


def shake(person: SimulatedPerson, seconds: float = 20.0) -> np.ndarray:
    """Return the postures of a person at rest (n, n_joints) at 100 Hz."""
    return np.array([person.step(0.01, BodyView()).copy() for _ in range(round(seconds * 100))])


def test_who_deteriorates_loses_two_percent_of_range_a_session_and_shakes_more() -> None:
    still = dataclasses.replace(DETERIORATING, tremor_per_session=0.0)
    first, tenth = SimulatedPerson(still, 3), SimulatedPerson(still, 3)
    tenth.begin_session(10)
    assert largest_flexion(tenth) == pytest.approx(0.98**9 * largest_flexion(first))
    shaking = []
    for session in (1, 5, 10):
        person = SimulatedPerson("deteriorating", 3)
        person.begin_session(session)
        shaking.append(float(np.std(shake(person))))
    assert shaking[0] < 0.004  # what every hand does
    assert shaking[1] == pytest.approx(0.012, rel=0.15)
    assert shaking[2] == pytest.approx(0.027, rel=0.15)


def test_the_tremor_is_there_in_movement_too() -> None:
    steady = dataclasses.replace(DETERIORATING, tremor_per_session=0.0)
    moved, shaken = SimulatedPerson(steady, 3), SimulatedPerson(DETERIORATING, 3)
    for person in (moved, shaken):
        person.begin_session(8)
    elbow = moved.joints.index("right_elbow")
    view = BodyView(cue=CUE)
    apart = [shaken.step(0.01, view)[elbow] - moved.step(0.01, view)[elbow] for _ in range(100)]
    assert np.std(apart) > 0.01


def test_who_improves_wins_range() -> None:
    person = SimulatedPerson("improving", 3)
    before = largest_flexion(person)
    person = SimulatedPerson("improving", 3)
    person.begin_session(6)
    assert largest_flexion(person) == pytest.approx(1.01**5 * before)


@given(st.integers(1, 1000), st.floats(-0.03, 0.03), st.floats(-0.01, 0.01))
def test_range_and_tremor_stay_human_in_any_session(session: int, change: float, growth: float) -> None:
    person = PersonParameters(range_per_session=change, tremor=0.01, tremor_per_session=growth)
    assert SMALLEST_RANGE <= person.range_in(session) <= LARGEST_RANGE
    assert 0.0 <= person.tremor_in(session) <= LARGEST_TREMOR
    assert person.range_in(1) == 1.0


def test_the_tremor_lies_between_four_and_eight_hertz_and_no_limb_shakes_like_another() -> None:
    tremor = Tremor(4, 7)
    tremor.size = 0.02
    moved = np.array([tremor.at(i / 100) for i in range(6000)])
    assert np.std(moved) == pytest.approx(0.02, rel=0.1)
    power = np.abs(np.fft.rfft(moved, axis=0)) ** 2
    frequency = np.fft.rfftfreq(len(moved), 0.01)
    within = (frequency >= TREMOR_BAND[0] - 0.1) & (frequency <= TREMOR_BAND[1] + 0.1)
    assert power[within].sum() > 0.97 * power.sum()
    assert np.max(np.abs(np.corrcoef(moved.T) - np.eye(4))) < 0.3
    other = Tremor(4, 8)
    other.size = 0.02
    assert not np.allclose(other.at(1.0), tremor.at(1.0))


def test_without_a_tremor_nothing_is_added() -> None:
    assert not Tremor(4, 7).at(1.0).any()
    assert SimulatedPerson("novice", 1).parameters.tremor_in(10) == 0.0


def tire(driver: Driver, seconds: float) -> None:
    """Let a driver try to start a chair that never moves."""
    for i in range(round(seconds * 100)):
        driver.drive(i / 100, Pose(0.0, 0.0, 1.0), 0.0, False)
    driver.rest()


def test_strokes_tire_and_a_pause_between_sessions_rests() -> None:
    person = SimulatedPerson("deteriorating", 1)
    person.show_task(PLAN, PLAN.paths[0])
    tire(person.driver, 60.0)
    strokes, practice = person.driver.strokes.session_strokes, person.driver.strokes.practice
    assert strokes > 10
    assert DETERIORATING.fatigue(DETERIORATING.fatigue_noise, strokes) > 1.0
    person.begin_session(2)
    assert person.driver.strokes.session_strokes == 0
    assert person.driver.strokes.practice == practice  # what was learnt is not slept away
    person.reset()
    assert person.session == 1


def test_who_is_worn_out_hesitates_longer_and_errs_more() -> None:
    """A driver with fatigue makes fewer strokes a minute, with larger errors of size."""
    slow = dataclasses.replace(NOVICE, fatigue_hesitation=0.5, learns=False)
    counts = []
    for already in (0, 10_000):
        driver = Driver(slow, 5)
        driver.show_task(PLAN, PLAN.paths[0])
        driver.strokes.session_strokes = already
        tire(driver, 120.0)
        counts.append(driver.strokes.session_strokes - already)
    assert counts[1] < 0.95 * counts[0]
    assert NOVICE.fatigue(0.2, 0) == 1.0
    assert NOVICE.fatigue(0.2, 400) == pytest.approx(1.0 + 0.2 * (1 - np.exp(-1)))
    assert NOVICE.fatigue(0.2, 1e9) == pytest.approx(1.2)
    assert IMPROVING.fatigue(0.0, 1e9) == 1.0


def test_a_session_below_the_first_is_refused() -> None:
    with pytest.raises(ValueError, match="counted from 1"):
        SimulatedPerson("novice", 1).begin_session(0)


def test_every_named_person_can_be_asked_for_by_name() -> None:
    for name, parameters in PARAMETERS.items():
        assert SimulatedPerson(name, 1).parameters is parameters


CURSOR_PLAN = CursorPlan(seed=1, duration=60.0)


@pytest.fixture(scope="module")
def figures():
    def tested(skill, seed=3):
        participant = Participant(SimulatedPerson(skill, seed), shirt_layout(), SAMPLE_RATE, seed)
        return do_interface_test(participant, standard_parameters(calibrate(participant)), CURSOR_PLAN)

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
