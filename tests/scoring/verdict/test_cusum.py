"""The cumulative sum tells a lasting deviation, and not a single one."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.scoring.verdict.cusum import ALLOWANCE, LIMIT, MOST_OF_ONE, cumulative_sum, next_sum, normal_score
from app.scoring.verdict.spread import Variance

surprises = st.lists(st.floats(-6.0, 6.0), max_size=30)


@given(surprises)
def test_the_sum_is_the_largest_of_all_stretches_up_to_now(values) -> None:
    counted = [min(value, MOST_OF_ONE) - ALLOWANCE for value in values]
    largest = max((sum(counted[start:]) for start in range(len(counted) + 1)), default=0.0)
    assert cumulative_sum(values) == pytest.approx(max(0.0, largest), abs=1e-9)


@given(surprises, st.floats(0.0, 2.0))
def test_larger_deviations_never_give_a_smaller_sum(values, more) -> None:
    assert cumulative_sum([value + more for value in values]) >= cumulative_sum(values) - 1e-9


@given(st.lists(st.floats(-6.0, ALLOWANCE), max_size=30))
def test_deviations_within_the_allowance_add_up_to_nothing(values) -> None:
    assert cumulative_sum(values) == 0.0


@given(surprises)
def test_a_long_calm_forgets_everything(values) -> None:
    assert cumulative_sum([*values, *[-3.0] * 30]) == 0.0


@given(st.floats(-1e6, 1e6), st.floats(0.0, 6.0))
def test_one_value_adds_a_bounded_part_and_nothing_is_negative(surprise, total) -> None:
    assert 0.0 <= next_sum(total, surprise) <= total + MOST_OF_ONE - ALLOWANCE


def test_one_outlier_is_no_change_and_two_are() -> None:
    assert cumulative_sum([math.inf]) <= LIMIT
    assert cumulative_sum([math.inf, math.inf]) > LIMIT
    assert cumulative_sum([-math.inf, 3.0]) == 2.5


@given(st.floats(-5.0, 5.0), st.floats(1.0, 100.0), st.floats(1.0, 1e4))
def test_a_score_grows_with_the_difference_and_shrinks_with_doubt(difference, variance, df) -> None:
    score = normal_score(difference, Variance(variance, df))
    opposite = normal_score(-difference, Variance(variance, df))
    assert score is not None
    assert opposite is not None
    assert score == pytest.approx(-opposite, rel=1e-3, abs=1e-9)
    assert abs(score) <= abs(difference) / math.sqrt(variance) + 1e-6


def test_where_nothing_is_known_of_the_noise_there_is_no_score() -> None:
    assert normal_score(1.0, Variance(1.0, 0.0)) is None
    assert normal_score(1.0, Variance(0.0, 5.0)) is None
