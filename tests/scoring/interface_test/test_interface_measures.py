"""The measures of an interface test: known values, bounds, and equality with what the task was while it ran."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.scoring.interface_test.interface_course import interface_course
from app.scoring.interface_test.interface_measures import (
    FEWEST_ENDS,
    Ways,
    effective_width,
    index_of_difficulty,
    interface_measures,
    path_efficiency,
    replay_task,
    throughput,
)
from app.scoring.interface_test.interface_verdicts import interface_verdicts
from app.world.cursor_task import Attempt, CursorPlan, CursorTask, Target

PLAN = CursorPlan(seed=1, ready=0.0, duration=20.0, time_limit=3.0, dwell=0.2)
POSITIVE = st.floats(1e-3, 1e3)


def test_known_values():
    assert index_of_difficulty(0.8, 0.2) == pytest.approx(math.log2(5))
    assert index_of_difficulty(0.0, 0.2) == 0.0
    ends = [-1.0, 1.0] * 5  # standard deviation sqrt(10 / 9)
    assert effective_width(ends) == pytest.approx(4.133 * math.sqrt(10 / 9))
    assert throughput([Ways(0.6, 2.0), Ways(1.4, 3.0)], 0.2) == pytest.approx((math.log2(4) / 2 + math.log2(8) / 3) / 2)


def test_without_a_known_spread_there_is_no_throughput():
    assert effective_width([0.1, -0.1] * (FEWEST_ENDS // 2 - 1)) is None
    assert effective_width([0.05] * 20) is None  # a spread of 0 would make any person infinitely exact
    assert throughput([], 0.2) is None


@given(POSITIVE, POSITIVE, POSITIVE)
def test_a_longer_way_is_more_difficult_and_a_wider_target_less(distance, more, width):
    here = index_of_difficulty(distance, width)
    assert here > 0.0
    assert index_of_difficulty(distance + more, width) >= here
    assert index_of_difficulty(distance, width + more) <= here
    assert index_of_difficulty(distance * more, width * more) == pytest.approx(here)  # the unit does not matter


@given(st.lists(st.floats(-1, 1), min_size=FEWEST_ENDS, max_size=60), st.floats(-5, 5), st.floats(0.1, 10))
def test_the_effective_width_knows_spread_only(ends, shift, scale):
    width = effective_width(ends)
    if width is None or width < 1e-6:
        return
    assert effective_width([shift + scale * end for end in ends]) == pytest.approx(scale * width, rel=1e-4)


@given(POSITIVE, POSITIVE, POSITIVE)
def test_who_takes_half_the_time_has_twice_the_throughput(distance, time, width):
    assert throughput([Ways(distance, time / 2)], width) == pytest.approx(2 * throughput([Ways(distance, time)], width))


def attempt(start, entry, way):
    target = Target(0.4, 0.0, 0.4, (1.0, 0.0))
    return Attempt(target, start, entry, True, 0.0, 1.0, 1.0, 1, way, entry)


@given(st.tuples(st.floats(-1, 1), st.floats(-1, 1)), st.tuples(st.floats(-1, 1), st.floats(-1, 1)), st.floats(1, 9))
def test_the_path_efficiency_is_a_share(start, end, detour):
    straight = math.dist(start, end)
    found = path_efficiency(attempt(start, end, straight * detour))
    assert 0.0 <= found <= 1.0
    if straight > 1e-6:
        assert found == pytest.approx(1.0 / detour)


def ticks(controls, dt=0.02):
    """Return the columns of a run, controls of 0.3 s each."""
    u = np.repeat(np.array(controls * 20, dtype=np.float64), 15, axis=0)
    t = np.arange(len(u)) * dt
    return t, u[:, 0], u[:, 1]


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(st.floats(-1, 1), st.floats(-1, 1)), min_size=1, max_size=30))
def test_the_recording_gives_the_figures_of_the_day(controls):
    run_t, u1, u2 = ticks(controls)
    live = CursorTask(PLAN)
    for row in zip(run_t.tolist(), u1.tolist(), u2.tolist(), strict=True):
        live.step(*row)
    assert replay_task(PLAN, run_t, u1, u2).attempts == live.attempts
    measures = interface_measures(live)
    assert interface_measures(replay_task(PLAN, run_t, u1, u2)) == measures
    assert measures.acquired + measures.missed == len(live.attempts)
    assert sum(one.acquired for one in measures.directions.values()) == measures.acquired
    assert sum(one.missed for one in measures.directions.values()) == measures.missed
    if measures.acquired:
        assert measures.dial_in >= 0.0
        assert measures.entries >= 1.0
        assert 0.0 <= measures.path_efficiency <= 1.0


def test_an_exact_and_a_trembling_hand_differ_in_throughput():
    def played(trembling):
        rng = np.random.default_rng(1)
        task = CursorTask(CursorPlan(seed=1))
        t = 0.0
        aim = (0.0, 0.0)
        shown = None
        while task.phase != "over":
            t += 0.02
            if task.target is not shown and task.target is not None:
                shown = task.target
                aim = np.array([shown.ahead, shown.left]) + rng.normal(0.0, trembling, 2)
            way = np.clip((aim - np.array([task.ahead, task.left])) / 0.02, -0.5, 0.5)
            task.step(t, *way.tolist())
        return interface_measures(task)

    exact, rough = played(0.01), played(0.035)
    assert exact.complete
    assert exact.missed == 0
    assert exact.acquisitions_per_minute == exact.acquired / 2
    assert exact.effective_width < rough.effective_width
    assert exact.throughput > 1.2 * rough.throughput


def test_a_missed_target_counts_with_its_time_in_the_throughput():
    """Of ten targets, of which two were missed, throughput was that of the eight alone."""

    def attempt(distance, acquired, place):
        target = Target(distance, 0.0, distance, (1.0, 0.0))
        end = (distance + 0.02 * (place % 3 - 1), 0.0)
        entry = 2.0 if acquired else None
        return Attempt(target, (0.0, 0.0), end, acquired, 0.0, entry, entry, int(acquired), distance, end)

    def measured(attempts):
        task = CursorTask(PLAN)
        task.attempts.extend(attempts)
        return interface_measures(task)

    eight = [attempt(0.8, True, place) for place in range(8)]
    alone = measured(eight)
    missed = measured([*eight, attempt(0.8, False, 8), attempt(0.8, False, 9)])
    assert missed.throughput == pytest.approx(alone.throughput * 2.0 / ((8 * 2.0 + 2 * PLAN.time_limit) / 10))
    assert (missed.effective_width, missed.first_entry) == (alone.effective_width, alone.first_entry)
    far = measured([*eight, attempt(0.4, False, 8)])  # of this distance no target was reached: its throughput is 0
    assert far.throughput == pytest.approx(alone.throughput / 2)


def test_an_early_end_is_no_complete_test():
    task = CursorTask(PLAN)
    assert interface_measures(task).acquisitions_per_minute is None  # it has not begun
    for number in range(11):
        task.step(0.5 * number, 0.0, 0.0)
    measures = interface_measures(task)
    assert (measures.complete, measures.duration, measures.acquired, measures.missed) == (False, 5.0, 0, 1)
    assert measures.acquisitions_per_minute == 0.0
    assert measures.throughput is measures.first_entry is measures.path_efficiency is None


MEASURE = "throughput"


def done(values):
    return [{"number": number, MEASURE: value} for number, value in enumerate(values, start=1)]


def words(values):
    return [one.verdicts[MEASURE].word for one in interface_verdicts(done(values))]


def test_a_change_beyond_the_own_noise_has_a_word_and_one_within_it_has_none():
    steady = [1.0, 1.04, 0.97, 1.02, 0.98, 1.01]
    assert words([*steady, 1.03]) == ["within", "within"]
    assert words([*steady, 1.6]) == ["better", "better"]
    assert words([*steady, 0.6]) == ["worse", "worse"]


def test_below_five_tests_nothing_is_said():
    assert interface_verdicts(done([1.0])) == []
    assert words([1.0, 1.6]) == ["too few"]  # the first one is the one before
    assert words([1.0, 1.0, 1.6]) == ["too few", "too few"]
    assert "too few" not in words([1.0, 1.02, 0.98, 1.01, 1.6])


def test_a_measure_that_a_test_does_not_have_is_left_out():
    tests = done([1.0, 1.1, 1.0, 1.1, 1.0, None])
    assert [one.verdicts for one in interface_verdicts(tests)] == [{}, {}]


@given(st.lists(st.floats(0.1, 5.0), min_size=5, max_size=12), st.floats(0.1, 10.0))
def test_the_unit_of_throughput_does_not_matter(values, scale):
    assert words(values) == words([scale * value for value in values])


def test_who_does_not_change_is_seldom_told_otherwise():
    rng = np.random.default_rng(1)
    found = [words(np.exp(0.1 * rng.standard_normal(8)))[0] for _ in range(400)]
    assert 1 - found.count("within") / len(found) < 0.09  # 5 % by construction, and chance


def test_the_course_has_a_curve_for_who_learns_and_none_for_who_does_not():
    rng = np.random.default_rng(2)
    number = np.arange(1, 16)
    learns = 1.5 - np.exp(-number / 3) + 0.02 * rng.standard_normal(15)
    course = interface_course(done(learns.tolist()))
    assert course.counted == number.tolist()
    band = course.curves[MEASURE]
    assert band.n == pytest.approx(number)
    assert all(low <= value <= high for low, value, high in zip(band.low, band.value, band.high, strict=True))
    assert interface_course(done((1 + 0.05 * rng.standard_normal(15)).tolist())).curves == {}
    assert interface_course([]).comparisons == []
