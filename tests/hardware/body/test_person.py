"""The simulated person: strokes, estimates, steering, learning, and parameters within their ranges."""

import dataclasses
import itertools
import math
import subprocess
import sys

import numpy as np
import pytest
from hardware.body.wishes import wished
from hypothesis import given
from hypothesis import strategies as st

from app.cues import Cue
from app.geometry import Pose
from app.hardware.base import BodyView
from app.hardware.body.driver import Driver
from app.hardware.body.parameter_ranges import RANGES, numbers_of, out_of_range
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import NOVICE, PARAMETERS, PRACTISED, PersonParameters, PracticeEffect
from app.hardware.body.steering import DrivingLine, Steering
from app.hardware.body.stroke_estimate import StrokeEstimate
from app.hardware.body.stroke_maker import Limb
from app.world.floorplan import FloorPlan, PrescribedPath

CORNER = ((0.0, 0.0), (6.0, 0.0), (6.0, 6.0))


def along(points) -> tuple[FloorPlan, PrescribedPath]:
    """Return an open floor with one path, and the path."""
    plan = FloorPlan(
        name="p", title="P", walls=(), paths=({"name": "c", "title": "C", "points": points, "instruction": "Go."},)
    )
    return plan, plan.paths[0]


def course(points=CORNER):
    return DrivingLine(points, cruise=0.6, corner=0.2, goal=0.35, braking=0.15)


def test_a_limb_rises_to_its_size_and_returns_more_slowly() -> None:
    limb = Limb()
    assert limb.stroke(1.0, 0.6, 0.5, 0.8) == pytest.approx(0.6)
    assert limb.level(1.0) == 0.0
    assert limb.level(1.25) == pytest.approx(0.3)  # a minimum-jerk movement is symmetric
    assert limb.level(1.5) == pytest.approx(0.6)
    assert limb.is_rising(1.49)
    assert not limb.is_rising(1.5)
    assert limb.level(1.9) == pytest.approx(0.3)
    assert not limb.is_resting(2.2)
    assert limb.is_resting(2.31)
    assert limb.level(5.0) == 0.0


@given(st.floats(0.05, 1.0), st.floats(0.1, 2.0), st.floats(0.1, 3.0), st.floats(0.0, 5.0))
def test_a_limb_never_leaves_its_range_nor_jumps(size: float, rise: float, back: float, again: float) -> None:
    limb = Limb()
    limb.stroke(0.0, size, rise, back)
    before = limb.level(again)
    limb.stroke(again, size, rise, back)
    assert limb.level(again) == pytest.approx(before)
    levels = [limb.level(again + i * 0.01) for i in range(600)]
    assert all(0.0 <= level <= 1.0 for level in levels)
    assert max(abs(b - a) for a, b in itertools.pairwise(levels)) <= 1.9 * 0.01 / min(rise, back)


def test_a_belief_comes_to_the_truth() -> None:
    estimate = StrokeEstimate(gain=2.0, lost=0.02)
    sizes = [0.2 + 0.7 * ((i * 7) % 10) / 10 for i in range(400)]
    for size in sizes:
        estimate.learn(size, 0.8 * (size - 0.1), 0.2)
    for size in (0.3, 0.6, 0.9):
        assert estimate.effect_of(size) == pytest.approx(0.8 * (size - 0.1), abs=0.03)
        assert estimate.size_for(estimate.effect_of(size)) == pytest.approx(size)


@given(st.floats(0.1, 5.0), st.floats(0.0, 1.0), st.floats(-10, 10))
def test_one_freak_does_not_break_a_belief(gain: float, size: float, effect: float) -> None:
    estimate = StrokeEstimate(gain, 0.08)
    estimate.learn(size, effect, 0.08)
    assert 0.1 <= estimate.gain <= 5.0
    assert 0.0 <= estimate.lost <= 0.25


def test_practice_is_exponential() -> None:
    quantity = PracticeEffect(0.4, 0.1, 350.0)
    assert quantity.after(0) == pytest.approx(0.4)
    assert quantity.after(350) == pytest.approx(0.1 + 0.3 / math.e)
    assert quantity.after(1e6) == pytest.approx(0.1)


def test_the_course_is_slow_at_corners_and_at_the_goal() -> None:
    seen = course()
    assert seen.speed(3.0) == pytest.approx(0.6)
    assert seen.speed(6.0) == pytest.approx(0.2)
    assert seen.speed(5.2) < 0.6  # braking begins before the corner
    assert seen.speed(12.0) == pytest.approx(0.35)


def test_the_bearing_leads_to_the_path_and_round_the_corner() -> None:
    seen = course()
    assert seen.bearing(0.0, 0.5, 1.0) < 0
    for i in range(60):
        seen.follow(i * 0.1, 0.0)
    assert seen.bearing(5.9, 0.0, 1.0) > 0.8


def test_who_is_lost_goes_back_the_way_he_came() -> None:
    """Lost behind a wall, the driver returns through the door and does not steer straight at the path."""
    seen = course(((0.0, 0.0), (20.0, 0.0)))
    way = [(0.1 * i, 0.0) for i in range(30)]
    way += [(2.9, 0.1 * i) for i in range(30)]
    way += [(2.9 + 0.1 * i, 2.9) for i in range(30)]
    for x, y in way:
        seen.follow(x, y)
    assert seen.is_lost
    assert abs(math.remainder(seen.bearing(*way[-1], 1.0) - math.pi, math.tau)) < 0.2
    for x, y in reversed(way):
        seen.follow(x, y)
    assert not seen.is_lost


def test_steering_wishes() -> None:
    steering = Steering(CORNER, PRACTISED)
    start = steering.want(0.0, Pose(0.0, 0.0, 0.0), 0.0, False, 0.0)
    assert start is not None
    assert start.wish == "faster"
    assert wished(steering.want(0.1, Pose(0.5, 0.0, 0.4), 0.6, False, 0.0)) == "right"
    assert wished(steering.want(0.2, Pose(0.5, 0.0, -0.4), 0.6, False, 0.0)) == "left"
    assert steering.want(0.3, Pose(1.0, 0.0, 0.0), 0.6, False, 0.0) is None
    assert wished(steering.want(0.4, Pose(1.0, 0.0, 0.0), -0.2, False, 0.0)) == "faster"
    for x in (2.0, 3.0, 4.0, 5.0):
        steering.want(1.0, Pose(x, 0.0, 0.0), 0.6, False, 0.0)
    assert wished(steering.want(9.0, Pose(5.5, 0.0, 0.0), 0.7, False, 0.0)) == "slower"


def test_who_is_stuck_backs_away_and_then_drives_on() -> None:
    steering = Steering(((0.0, 0.0), (9.0, 0.0)), PRACTISED)
    wishes = [steering.want(0.1 * i, Pose(0.6, 0.0, 0.0), 0.5, False, 0.0) for i in range(30)]
    assert wishes[5] is None or wishes[5].wish == "faster"
    assert wishes[-1] is not None
    assert wishes[-1].wish == "slower"
    assert steering.want(3.5, Pose(0.5, 0.0, 0.0), -0.15, False, 0.0) is None
    assert wished(steering.want(4.5, Pose(0.25, 0.0, 0.0), -0.15, False, 0.0)) == "faster"


def at_corner(person: PersonParameters, seed: int) -> Driver:
    """Return a driver who is asked to drive round the corner."""
    driver = Driver(person, seed)
    driver.show_task(*along(CORNER))
    return driver


def drive(driver: Driver, seconds: float, t: float = 0.0) -> list[dict[str, float]]:
    """Let a driver make strokes for a chair that never moves."""
    levels = []
    for i in range(round(seconds * 100)):
        now = t + i / 100
        driver.drive(now, Pose(0.0, 0.0, 1.0), 0.0, False)
        levels.append({name: limb.level(now) for name, limb in driver.strokes.limbs.items()})
    return levels


def test_nothing_moves_before_the_reaction_time() -> None:
    driver = at_corner(NOVICE, 1)
    levels = drive(driver, 10.0)
    moving = [i for i, level in enumerate(levels) if any(level.values())]
    assert moving[0] / 100 >= NOVICE.reaction_time


def test_both_elbows_are_never_away_from_rest_together() -> None:
    for seed in range(5):
        driver = at_corner(NOVICE, seed)
        for level in drive(driver, 120.0):
            assert not (level["right_elbow"] > 0 and level["left_elbow"] > 0)


def test_one_seed_moves_one_way() -> None:
    first, second, other = (at_corner(NOVICE, seed) for seed in (3, 3, 4))
    assert drive(first, 20.0) == drive(second, 20.0)
    assert drive(Driver(NOVICE, 3), 1.0) != drive(other, 20.0)


def test_who_does_not_learn_gains_no_practice() -> None:
    driver = at_corner(dataclasses.replace(NOVICE, learns=False), 1)
    before = [(estimate.gain, estimate.lost) for estimate in driver.estimates.values()]
    drive(driver, 60.0)
    assert driver.strokes.practice == 0
    assert [(estimate.gain, estimate.lost) for estimate in driver.estimates.values()] == before
    keen = at_corner(NOVICE, 1)
    drive(keen, 60.0)
    assert keen.strokes.practice > 10


def practise(driver: Driver, seconds: float) -> tuple[float, float]:
    """Let a driver drive on an open floor, where a full stroke changes 0.3 m/s or 0.45 rad; return the final place."""
    worth = {"right_elbow": 0.3, "left_elbow": -0.3, "right_shoulder": 0.45, "left_shoulder": -0.45}
    x = y = theta = v = 0.0
    before = dict.fromkeys(worth, 0.0)
    for i in range(round(seconds * 100)):
        driver.drive(i / 100, Pose(x, y, theta), v, False)
        for name, limb in driver.strokes.limbs.items():
            rise = max(0.0, limb.level(i / 100) - before[name])
            before[name] = limb.level(i / 100)
            if name.endswith("elbow"):
                v = min(0.8, max(-0.3, v + worth[name] * rise))
            else:
                theta = math.remainder(theta + worth[name] * rise, math.tau)
        x += v * math.cos(theta) / 100
        y += v * math.sin(theta) / 100
    return x, y


def test_practice_moves_beliefs_towards_the_truth_and_the_driver_along_the_path() -> None:
    def error(driver: Driver) -> float:
        truth = {"right_elbow": 0.3, "left_elbow": 0.3, "right_shoulder": 0.45, "left_shoulder": 0.45}
        return sum(abs(math.log(driver.estimates[name].effect_of(0.6) / (0.6 * truth[name]))) for name in truth)

    before = after = 0.0
    for seed in range(4):
        driver = Driver(NOVICE, seed)
        driver.show_task(*along(((0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0))))
        before += error(driver)
        x, y = practise(driver, 300.0)
        after += error(driver)
        assert isinstance(driver.steering, Steering)
        assert driver.steering.course.s > 60.0
        assert abs(driver.steering.course.cross_track) < 1.5
        assert math.hypot(x, y) > 20.0
    assert after < 0.6 * before


def test_the_person_follows_cues_drives_when_permitted_and_rests_otherwise() -> None:
    person = SimulatedPerson("practised", 1)
    person.show_task(*along(CORNER))
    elbow = person.joints.index("right_elbow")
    move = Cue(start=0.0, end=1.0, kind="move", joint="right_elbow", repetition=1)
    asked = [person.step(0.01, BodyView(cue=move))[elbow] for _ in range(150)]
    assert max(asked) > 0.7
    for _ in range(300):
        person.step(0.01, BodyView())
    calm = [np.abs(person.step(0.01, BodyView())).max() for _ in range(300)]
    assert max(calm) < 0.03  # tremor
    driving = [person.step(0.01, BodyView(driving=True))[elbow] for _ in range(300)]
    assert max(driving) > 0.2  # off he goes
    for _ in range(300):
        person.step(0.01, BodyView(driving=False))
    assert np.abs(person.step(0.01, BodyView())).max() < 0.03
    practised = person.driver.strokes.practice
    assert practised > PRACTISED.practice
    person.reset()
    assert person.driver.strokes.practice == PRACTISED.practice
    assert person.driver.steering is not None


def test_the_person_needs_no_scientific_library() -> None:
    code = "import sys, app.hardware.body.person; print([m for m in ('scipy', 'sklearn') if m in sys.modules])"
    seen = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert seen.stdout.strip() == "[]"


NOT_MEASURED = {"learns", "practice"}  # a switch, and where the person stands in his learning


def test_every_parameter_has_a_range_and_every_range_a_parameter() -> None:
    names = {field.name for field in dataclasses.fields(PersonParameters)} - NOT_MEASURED
    assert {name.partition(".")[0] for name in RANGES} == names
    assert list(numbers_of(NOVICE)) == list(RANGES)


def test_ranges_are_finite_and_say_their_unit_and_source() -> None:
    for name, known in RANGES.items():
        assert math.isfinite(known.low), name
        assert math.isfinite(known.high), name
        assert known.low < known.high, name
        assert known.unit, name
        assert known.source, name


@pytest.mark.parametrize("name", PARAMETERS)
def test_every_named_person_lies_within(name) -> None:
    assert out_of_range(PARAMETERS[name]) == ()


def test_a_number_outside_is_named_with_its_range() -> None:
    odd = dataclasses.replace(NOVICE, reaction_time=0.05, wrong_limb=PracticeEffect(0.9, 0.01, math.nan))
    said = out_of_range(odd)
    assert said[0] == "reaction_time is 0.05 s: choose 0.18 to 0.5"
    assert [sentence.split(" is ")[0] for sentence in said[1:]] == ["wrong_limb.first", "wrong_limb.strokes"]
