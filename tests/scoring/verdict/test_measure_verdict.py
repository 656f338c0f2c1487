"""Verdicts on a person's trials: which of them count, what they are compared with, the word, how often it is right."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.scoring.measures import TRIAL_MEASURES
from app.scoring.verdict.cusum import ALLOWANCE, LIMIT, MOST_OF_ONE, cumulative_sum, next_sum, normal_score
from app.scoring.verdict.leading_measures import leading_measures, leading_of_task
from app.scoring.verdict.measure_scales import from_scale, to_scale, value_of
from app.scoring.verdict.measure_verdict import clinic_spreads, people_variances
from app.scoring.verdict.spread import Variance
from app.scoring.verdict.verdicts import task_verdicts, trial_verdicts
from bench.learning.verdicts import learners, outcomes

RNG = np.random.default_rng(4)
OTHERS = [
    [
        {"id": i, "number": i, "session": 1 + i // 4, "familiarisation": False, "reached": True}
        | {"e_diff": float(np.exp(RNG.normal(1.0, 0.1))), "sparc": float(RNG.normal(-2.4, 0.1)), "stops": int(i % 3)}
        for i in range(16)
    ]
    for _ in range(5)
]
CLINIC = clinic_spreads(people_variances(dict(enumerate(OTHERS))))


def rows_of(*sessions: list[float], measure: str = "e_diff", familiarisation: int = 0, **more: Any) -> list[Any]:
    """Return trials with this measure; in each session the first `familiarisation` ones are for getting used to it."""
    rows: list[Any] = []
    for session, values in enumerate(sessions, start=1):
        for place, value in enumerate(values):
            number = len(rows) + 1
            row = {"id": 100 + number, "number": number, "session": session, "reached": True, measure: value}
            rows.append(row | {"familiarisation": place < familiarisation} | more)
    return rows


def test_a_person_does_not_enter_the_median_that_their_own_verdict_is_drawn_towards() -> None:
    variances = people_variances(dict(enumerate(OTHERS)))
    without = clinic_spreads(people_variances(dict(enumerate(OTHERS[1:]))))
    assert clinic_spreads(variances, 0)["e_diff"] == without["e_diff"] != clinic_spreads(variances)["e_diff"]


def word(rows: list[Any], measure: str = "e_diff", clinic: Any = CLINIC) -> str:
    return task_verdicts(rows, clinic).sessions[0].verdicts[measure].word


def test_a_difference_below_what_the_eye_can_see_is_noise() -> None:
    """-2.42 after -2.40 was called worse."""
    rows = rows_of([-2.39, -2.41, -2.38, -2.40, -2.42], measure="sparc")
    verdict = trial_verdicts(rows, {}, 105, None).verdicts["sparc"]
    assert verdict.word == "within"
    assert (verdict.earlier, verdict.later) == pytest.approx((-2.40, -2.42))


@pytest.mark.parametrize(
    ("measure", "last", "expected"),
    [
        ("e_diff", [1.0, 1.1, 0.9], "better"),
        ("e_diff", [9.0, 9.5, 8.5], "worse"),
        ("e_diff", [3.2, 2.9, 3.0], "within"),
        ("sparc", [-1.0, -1.1, -1.05], "better"),
        ("sparc", [-5.0, -5.1, -4.9], "worse"),
    ],
)
def test_the_word_follows_the_direction_of_the_measure(measure: str, last: list[float], expected: str) -> None:
    usual = [3.0, 3.2, 2.8, 3.1] if measure == "e_diff" else [-2.4, -2.5, -2.3, -2.45]
    assert word(rows_of(usual, usual[::-1], last, measure=measure), measure) == expected


def test_below_five_trials_there_are_too_few() -> None:
    rows = rows_of([3.0, 3.2], [1.0, 1.1])
    verdict = task_verdicts(rows, CLINIC).sessions[0].verdicts["e_diff"]
    assert (verdict.word, verdict.trials, verdict.low, verdict.high) == ("too few", 4, None, None)
    assert word(rows_of([3.0, 3.2, 3.1], [1.0, 1.1])) != "too few"


def test_without_a_clinics_median_two_sessions_say_nothing_about_sessions() -> None:
    two = rows_of([3.0, 3.2, 3.1, 2.9, 3.0], [1.0, 1.1, 0.9])
    of_two = clinic_spreads(people_variances(dict(enumerate(OTHERS[:2]))))
    assert of_two == {}
    assert word(two, clinic=of_two) == "too few"
    many = rows_of(*[[3.0, 3.2, 3.1], [2.9, 3.1, 3.0]] * 3, [1.0, 1.1, 0.9])
    assert word(many, clinic={}) == "better"


@pytest.mark.parametrize("sizes", [(2, 5), (5, 2), (5, 5), (7, 7)])
def test_with_a_clinics_median_two_sessions_of_any_size_have_a_verdict(sizes: tuple[int, int]) -> None:
    usual = [3.0, 3.2, 3.1, 2.9, 3.0, 3.1, 2.8]
    assert word(rows_of(usual[: sizes[0]], usual[: sizes[1]])) == "within"


def test_trials_for_getting_used_to_the_task_are_not_compared() -> None:
    usual = [9.0, 9.0, 9.0, 3.0, 3.2, 2.8]
    rows = rows_of(usual, usual, [9.0, 9.0, 9.0, 3.1, 2.9], familiarisation=3)
    found = task_verdicts(rows, CLINIC).sessions[0]
    assert (found.earlier, found.later, found.trials) == (2, 3, (3, 2))
    assert found.verdicts["e_diff"].later == pytest.approx(math.sqrt(3.1 * 2.9))
    early = trial_verdicts(rows, CLINIC, rows[14]["id"], None)
    assert (early.earlier, early.familiarisation, early.verdicts) == (None, [rows[14]["id"]], {})
    # The trial before the fourth one of the day is the last of the day before, and the two can be compared.
    assert trial_verdicts(rows, CLINIC, rows[15]["id"], None).earlier == rows[11]["id"]
    chosen = trial_verdicts(rows, CLINIC, rows[15]["id"], rows[12]["id"])
    assert (chosen.familiarisation, chosen.verdicts) == ([rows[12]["id"]], {})


def test_the_best_so_far_is_of_the_trials_before_that_are_compared() -> None:
    lucky = [1.0, 9.0, 9.0, 3.0, 3.2, 2.8]
    rows = rows_of(lucky, lucky, familiarisation=3)
    rows[3]["reached"] = False
    assert trial_verdicts(rows, CLINIC, rows[-1]["id"], None).best == {"e_diff": 2.8}
    assert trial_verdicts(rows, CLINIC, rows[5]["id"], None).best == {"e_diff": 3.2}
    assert trial_verdicts(rows, CLINIC, rows[3]["id"], None).best == {}
    smooth = rows_of([-2.0, -4.0, -3.0, -1.0], measure="sparc", familiarisation=1)
    assert trial_verdicts(smooth, CLINIC, smooth[-1]["id"], None).best == {"sparc": -3.0}
    fast = rows_of([0.4, 0.5, 0.3], measure="mean_speed")
    assert trial_verdicts(fast, CLINIC, fast[-1]["id"], None).best == {}  # neither way is better


def test_neither_the_order_of_the_two_trials_nor_what_is_driven_later_changes_a_verdict() -> None:
    rows = rows_of([3.0, 3.2, 2.8], [3.1, 2.9, 3.3], [2.0, 2.1], [9.0, 0.1, 4.0])
    assert trial_verdicts(rows, CLINIC, 107, 106) == trial_verdicts(rows, CLINIC, 106, 107)
    assert trial_verdicts(rows, CLINIC, 107, 106) == trial_verdicts(rows[:8], CLINIC, 107, 106)


def test_a_trial_that_missed_the_goal_is_not_compared_in_its_area_but_in_its_stages() -> None:
    rows = rows_of([3.0, 3.2, 2.8, 3.1, 3.0], stages_done=3)
    rows[-1]["reached"] = False
    verdicts = trial_verdicts(rows, CLINIC, 105, None).verdicts
    assert "e_diff" not in verdicts
    assert verdicts["stages_done"].word == "within"
    assert value_of(rows[-1], "e_diff") is None


@pytest.mark.parametrize("measure", ["follow_error_rms", "follow_error_max", "follow_near"])
def test_whoever_stops_following_at_once_has_followed_no_better(measure: str) -> None:
    rows = rows_of([0.6, 0.61, 0.6, 0.62, 0.01], measure=measure)
    rows[-1]["reached"] = False
    assert value_of(rows[-1], measure) is None
    assert measure not in trial_verdicts(rows, CLINIC, 105, None).verdicts


def test_a_measure_without_a_direction_has_no_verdict() -> None:
    rows = rows_of([0.3, 0.31, 0.3], [0.6, 0.61, 0.6], measure="mean_speed")
    assert "mean_speed" not in task_verdicts(rows, {}).sessions[0].verdicts


def test_equal_counts_do_not_make_one_contact_a_change() -> None:
    rows = rows_of([0.0] * 5, [0.0] * 5, [0.0] * 5, [0.0] * 4 + [1.0], measure="collisions")
    assert word(rows, "collisions", {}) == "within"


@given(st.sampled_from(list(TRIAL_MEASURES)), st.floats(1e-6, 1e6))
def test_a_value_comes_back_from_its_scale(name: str, value: float) -> None:
    signed = -value if TRIAL_MEASURES[name].scale == "plain" else value
    assert from_scale(name, float(to_scale(name, np.array([signed]))[0])) == pytest.approx(signed, rel=1e-6, abs=1e-9)


@given(
    st.sampled_from([name for name, measure in TRIAL_MEASURES.items() if measure.better]),
    st.lists(st.lists(st.floats(-1e99, 1e99), min_size=1, max_size=4), min_size=1, max_size=5),
)
def test_any_numbers_have_a_finite_verdict(name: str, sessions: list[list[float]]) -> None:
    rows = rows_of(*sessions, measure=name)
    of_sessions = [found.verdicts for found in task_verdicts(rows, CLINIC).sessions]
    for verdicts in (*of_sessions, trial_verdicts(rows, CLINIC, rows[-1]["id"], None).verdicts):
        for verdict in verdicts.values():
            given_numbers = [verdict.earlier, verdict.later, verdict.low, verdict.high]
            assert all(math.isfinite(one) for one in given_numbers if one is not None)
            if verdict.low is not None and verdict.high is not None:
                assert verdict.low <= verdict.high


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


def test_the_measures_of_a_task_are_chosen_by_what_it_has():
    trial = {"e_diff": 1, "dist": 2, "time": 3, "sparc": -4, "collisions": 0}
    assert leading_measures(trial) == ("e_diff", "dist", "time")
    turn = {"heading_error_deg": 3, "turn_drift": 0.1, "time": 9, "collisions": 1}
    assert leading_measures(turn) == ("heading_error_deg", "turn_drift", "time")
    assert leading_measures({"sparc": -4, "mean_speed": 0.3}) == ("sparc",)
    assert leading_measures({}) == ()
    missed = {"gaps": 2, "gap_clearance": None, "e_diff": 1, "time": 3}
    assert leading_of_task([missed, missed | {"gap_clearance": 0.1}]) == ("gap_clearance", "e_diff", "time")


SESSIONS = 14
TRIALS = 6  # of each session, of which the first three are for getting used to the task
WORSE_FROM = 8


def rows() -> list[dict[str, object]]:
    """Return the trials of a person whose time and area double in session 8."""
    rng = np.random.default_rng(4)
    made: list[dict[str, object]] = []
    for session in range(1, SESSIONS + 1):
        level = 2.0 if session >= WORSE_FROM else 1.0
        for place in range(TRIALS):
            number = len(made) + 1
            values = {name: level * float(np.exp(rng.normal(0, 0.1))) for name in ("time", "e_diff")}
            facts = {"id": number, "number": number, "session": session, "reached": True, "familiarisation": place < 3}
            made.append({**facts, **values})
    return made


def test_a_deterioration_is_looked_for_in_the_named_measures_only() -> None:
    every = task_verdicts(rows(), {})
    assert set(every.deterioration) == {"time", "e_diff"}
    assert str(every.deterioration["time"]).startswith(
        f"Worse than this person's own noise since session {WORSE_FROM}."
    )
    for names in ((), ("time",), ("time", "sparc")):
        found = task_verdicts(rows(), {}, names)
        assert found.sessions == every.sessions
        assert found.deterioration == {name: every.deterioration[name] for name in names if name == "time"}


PEOPLE = 500


@pytest.mark.parametrize("layout", [(3, 2), (5, 5), (5, 5, 5, 5), (10,)], ids=str)
def test_noise_is_not_called_a_change_and_twice_the_mdc_is(layout: tuple[int, ...]) -> None:
    share = outcomes(layout, PEOPLE)
    assert share.false <= 0.05
    assert share.found >= 0.9
    assert share.found_true >= 0.9


def test_an_improving_person_is_called_better_than_at_first_and_never_worse() -> None:
    shares = dict(learners(100, seed=15))
    assert shares["the last session against the first: better"] >= 0.6
    assert max(share for words, share in shares.items() if "worse" in words) <= 0.05
