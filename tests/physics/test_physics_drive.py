"""A chair in MuJoCo: it carries its weight, holds on a slope, and goes, turns and stops as it is told."""

import math
from itertools import islice

import mujoco
import numpy as np
import pytest
from physics.chair_model import COLUMNS, GRAVITY, SAMPLE_WIDTH, Floor, PhysicalChair
from physics.commands import receiver_twists
from physics.drives import CELLS, castor_drift, physical_course, random_drive
from physics.measures import SAMPLES_PER_TICK, stop_of
from physics.simulation import Simulation
from pipeline.gates import DT

from app.geometry import STANDSTILL, Twist


def held(floor, seconds=0.5):
    """Return a simulation of a chair that stands for so long."""
    simulation = Simulation(PhysicalChair(), floor)
    for _ in range(round(seconds / DT)):
        simulation.advance(STANDSTILL)
    return simulation


@pytest.mark.parametrize("floor", [Floor(), CELLS["10 degrees, set off uphill"], CELLS["10 degrees, across"]])
def test_the_wheels_carry_the_weight_and_the_brakes_hold_the_chair(floor):
    simulation = held(floor)
    model, data, weight = simulation.model, simulation.data, 190.0 * GRAVITY * math.cos(floor.slope)
    assert model.nsensordata == SAMPLE_WIDTH
    assert model.body_mass.sum() == pytest.approx(190.0)
    assert simulation.rest.sum() == pytest.approx(weight, rel=0.02)
    assert simulation.rest.min() > 50.0
    force, normal = np.zeros(6), 0.0
    for contact in range(data.ncon):
        mujoco.mj_contactForce(model, data, contact, force)
        normal += force[0]
    assert normal == pytest.approx(weight, rel=0.02)
    place = simulation.samples[:, COLUMNS["place"]]
    assert np.linalg.norm(place[-1, :2] - place[0, :2]) < 0.002


def test_it_goes_and_turns_as_it_is_told():
    course = physical_course([Twist(0.5, 0.4)] * 200, PhysicalChair(), Floor())
    assert course[-1, 3] == pytest.approx(0.5, abs=0.05)
    assert course[-1, 4] == pytest.approx(0.4, abs=0.1)
    assert course[-1, 2] > 0.3, "to the left"
    assert course[-1, 1] > 0.0


def test_a_stop_takes_longer_than_the_receivers_own_and_not_for_ever():
    simulation = Simulation(PhysicalChair(), Floor())
    twists = [Twist(0.8, 0.0)] * 150
    for twist in islice(receiver_twists(twists), len(twists) + 150):
        simulation.advance(twist)
    stop = stop_of(simulation.samples[len(twists) * SAMPLES_PER_TICK :])
    assert 0.8**2 / (2 * 3.2) < stop.distance < 0.5
    assert 0.25 < stop.time < 1.2


def test_a_random_drive_has_its_figures():
    found = random_drive("level", "1")
    assert found == random_drive("level", "1")
    assert found.felt_driving > 0.0
    assert not found.is_tipped


def test_castors_that_turn_round_push_the_chair_aside_by_some_degrees():
    drift = castor_drift("1")
    assert all(0.0 <= each < 45.0 for each in drift)
