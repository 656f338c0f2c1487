"""Verdicts of interface tests: from the person's own noise, with one test a session."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.scoring.interface_test.interface_course import interface_course
from app.scoring.interface_test.interface_verdicts import interface_verdicts

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


@settings(max_examples=60, deadline=None)
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
