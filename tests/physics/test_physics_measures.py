"""The mathematics beside MuJoCo: the model's text, what is felt, the way to standstill, loads, courses, the tables."""

import math
from dataclasses import replace
from itertools import islice
from xml.etree import ElementTree

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from physics.built_in import FITTED, UNICYCLE, built_in, difference, fit, lag
from physics.chair_model import COLUMNS, GRAVITY, LOADS, SAMPLE_WIDTH, TIME_STEP, Floor, PhysicalChair, mjcf
from physics.commands import ENDINGS, Wish, gate_twists, receiver_twists
from physics.measures import WINDOW, felt, outcome, running_mean
from physics.page import page

from app.geometry import STANDSTILL, Twist
from app.speed_limits import HIGHEST_SPEEDS, Speeds
from app.world.dynamics import Wheelchair

REST = np.full(4, 400.0)
COURSE = [*[Twist(0.8, 0.0)] * 300, *[Twist(0.5, 1.0)] * 300, *[STANDSTILL] * 100, *[Twist(-0.3, 0.2)] * 300]


def samples_of(speeds):
    """Return samples of an upright chair that drives straight with these speeds (n,) in m/s."""
    samples = np.zeros((len(speeds), SAMPLE_WIDTH))
    samples[:, COLUMNS["place"].start] = np.cumsum(speeds) * TIME_STEP
    samples[:, COLUMNS["ahead"].start] = 1.0
    samples[:, COLUMNS["up"].stop - 1] = 1.0
    samples[:, COLUMNS["axle"].start] = samples[:, COLUMNS["chest"].start] = speeds
    samples[:, LOADS] = REST
    return samples


def braked(speed, deceleration, seconds=4.0):
    """Return samples of 1 s at a speed, then of a stop."""
    braking = np.maximum(0.0, speed - deceleration * np.arange(round(seconds / TIME_STEP)) * TIME_STEP)
    return samples_of(np.concatenate([np.full(1000, speed), braking]))


@given(st.floats(0.0, 0.3), st.floats(-math.pi, math.pi))
def test_a_slope_turns_gravity_and_changes_nothing_else_of_the_model(slope, uphill):
    floor = Floor(slope=slope, uphill=uphill)
    assert math.hypot(*floor.gravity) == pytest.approx(GRAVITY)
    document = ElementTree.fromstring(mjcf(PhysicalChair(), floor))
    assert sum(float(part.attrib["mass"]) for part in document.iter("inertial")) == pytest.approx(190.0)
    assert len(document.findall("sensor/*")) == len(COLUMNS)
    assert [part.attrib["joint"] for part in document.findall("actuator/general")] == ["left", "right"]


def test_a_kerb_is_as_high_as_it_is_said():
    kerb = ElementTree.fromstring(mjcf(PhysicalChair(), Floor(kerb=0.02))).find(".//geom[@name='kerb']")
    place, size = ([float(number) for number in kerb.attrib[name].split()] for name in ("pos", "size"))
    assert place[2] + size[2] == pytest.approx(0.02)
    assert place[0] - size[0] == pytest.approx(1.0)


def test_a_steady_acceleration_is_felt_as_it_is_and_its_jerk_as_none():
    velocity = np.outer(np.arange(2000) * TIME_STEP, (1.2, -0.9, 0.0))
    acceleration, jerk = felt(velocity)
    assert acceleration[-1] == pytest.approx(1.5, rel=1e-3)
    assert jerk[-1] == pytest.approx(0.0, abs=1e-3)
    assert jerk.max() > 20.0, "its sudden beginning is felt"


@given(st.floats(0.2, 1.5), st.floats(1.0, 6.0))
def test_the_way_to_standstill_is_that_of_the_deceleration(speed, deceleration):
    found = outcome("level", Speeds(), braked(speed, deceleration), 1000, REST, is_tipped=False)
    assert found.stop.distance == pytest.approx(speed**2 / (2 * deceleration), abs=0.003)
    assert found.stop.time == pytest.approx((speed - 0.02) / deceleration, abs=0.002)
    assert found.stop.roll_back < 0.001
    assert found.speed == pytest.approx(speed)
    assert not found.lifted_driving
    assert not found.lifted_stopping
    assert found.least_load == pytest.approx(1.0)


@pytest.mark.parametrize(("lasting", "lifted"), [(WINDOW - 1, False), (WINDOW, True)])
@pytest.mark.parametrize("first", [100, 1500])
def test_a_wheel_has_left_the_floor_when_it_carries_nothing_for_the_whole_window(lasting, lifted, first):
    samples = braked(1.0, 3.0)
    samples[first : first + lasting, LOADS.start + 2] = 0.0
    found = outcome("level", Speeds(), samples, 1000, REST, is_tipped=False)
    assert (found.lifted_driving, found.lifted_stopping) == ((lifted, False) if first < 1000 else (False, lifted))


def test_a_chair_that_goes_on_or_tips_over_before_has_no_way_to_standstill():
    rolling = samples_of(np.full(3000, 0.5))
    for ended in (1000, 4000):
        found = outcome("level", Speeds(), rolling, ended, REST, is_tipped=ended > 3000)
        assert all(map(math.isnan, found.stop))


def test_a_running_mean_has_one_value_for_each_whole_window():
    values = np.arange(2.0 * WINDOW).reshape(-1, 1)
    assert running_mean(values)[:, 0] == pytest.approx(np.arange(WINDOW + 1) + (WINDOW - 1) / 2)


@settings(max_examples=10)
@given(st.lists(st.builds(Wish, st.floats(-1, 1), st.floats(-1, 1), st.floats(0.1, 1.0)), min_size=1, max_size=3))
@pytest.mark.parametrize("ending", ENDINGS)
def test_whatever_is_wished_the_receiver_keeps_the_limits_and_stands_after_the_ending(ending, wishes):
    twists = list(gate_twists(HIGHEST_SPEEDS, wishes))
    driven = list(islice(receiver_twists(twists, ending), len(twists) + 50))
    assert max(abs(twist.v) for twist in driven) <= HIGHEST_SPEEDS.forward
    assert max(abs(twist.omega) for twist in driven) <= HIGHEST_SPEEDS.turn
    assert driven[-1] == STANDSTILL


@pytest.mark.parametrize("ticks", [-12, 0, 25])
def test_a_lag_is_found(ticks):
    signal = np.sin(np.arange(400) / 20.0)
    assert lag(signal, np.sin((np.arange(400) - ticks) / 20.0)) == pytest.approx(ticks / 100)


def test_a_chair_differs_from_itself_by_nothing_and_from_a_slower_one_by_its_lag():
    own = built_in(COURSE, UNICYCLE)
    assert difference(own, own) == (0.0, 0.0, 0.0, 0.0, 0.0)
    slower = difference(own, built_in(COURSE, replace(UNICYCLE, speed_lag=0.2)))
    assert slower.speed_lag > 0.05
    assert slower.turn_lag == 0.0
    assert slower.distance > slower.soon > 0.0


def test_the_fit_finds_the_parameters_that_made_a_course():
    made = Wheelchair(speed_lag=0.3, turn_lag=0.2, castor_push=0.25, turn_slip=0.1, speed_slip=0.05)
    found = fit([(COURSE, built_in(COURSE, made))])
    for name in FITTED:
        assert getattr(found, name) == pytest.approx(getattr(made, name), abs=0.01), name


def test_the_page_has_the_worst_and_the_median_of_each_floor():
    outcomes = [outcome("10 degrees", Speeds(), braked(v, 3.0), 1000, REST, is_tipped=False) for v in (0.2, 0.6, 1.0)]
    differences = {"wheelchair": difference(built_in(COURSE, UNICYCLE), built_in(COURSE, Wheelchair()))}
    text = page(outcomes, {"10 degrees"}, [(1.0, 2.0, 3.0, 4.0)], differences, {0.14: Wheelchair()}, "4")
    assert "| 10 degrees | 3 | 0.17 (0.06) | 0.33 (0.19) |" in text
    assert "| speed when it was stopped, m/s | 0.3 to 0.5 | 0 | 0 | 0 |" in text
    assert "| built-in wheelchair | 3.0 (3.0) | 4.0 (4.0) |" in text
    assert "| `speed_lag` | 0.2 | 0.2 |" in text
