"""Learning curves: the right shape, the right trend, and no sentence that the trials do not support."""

import json
import math
import re
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic_core import to_jsonable_python

from app.scoring.learning import learning_curves
from app.scoring.learning_fit import fit_exponential, fit_learning_curve, fit_level, fit_power
from app.scoring.measures import TRIAL_MEASURES
from app.scoring.trend import mann_kendall, theil_sen

STATISTICS = re.compile(
    r"Mann|Kendall|\bp [<=]|95 %|exponential|power law|AICc|median|chance|constant|trend|-", re.IGNORECASE
)
FALLING = 1.5 + 4.0 * np.exp(-np.arange(1.0, 29.0) / 3.0) + np.random.default_rng(3).normal(0, 0.1, 28)


def trials_of(values: np.ndarray, measure: str = "e_diff") -> list[dict[str, object]]:
    return [{"number": i, measure: float(value), "reached": True} for i, value in enumerate(values, start=1)]


def test_mann_kendall_counts_pairs() -> None:
    assert mann_kendall([1.0, 2.0, 3.0, 4.0]).s == 6
    assert mann_kendall([4.0, 3.0, 2.0, 1.0]).s == -6
    # Of 5! orders only the two monotonic ones are this extreme.
    assert mann_kendall([5.0, 4.0, 3.0, 2.0, 1.0]).p == pytest.approx(2 / math.factorial(5))
    assert mann_kendall([5.0, 4.0, 3.0, 2.0, 1.0]).direction == "falls"


def test_mann_kendall_of_equal_values_is_no_trend() -> None:
    trend = mann_kendall([2.0] * 12)
    assert (trend.s, trend.p, trend.direction) == (0, 1.0, "none")
    assert mann_kendall([2.0]).p == 1.0


def test_mann_kendall_with_ties_uses_the_corrected_variance() -> None:
    values = [5.0, 5.0, 4.0, 3.0, 3.0, 3.0, 2.0, 1.0, 0.0, 0.0]
    count, ties = len(values), (2, 3, 2)
    variance = (count * (count - 1) * (2 * count + 5) - sum(t * (t - 1) * (2 * t + 5) for t in ties)) / 18
    trend = mann_kendall(values)
    assert trend.p == pytest.approx(math.erfc(abs(trend.s) / math.sqrt(2 * variance)))


@given(st.lists(st.floats(-1e6, 1e6), min_size=2, max_size=25))
def test_mann_kendall_changes_its_sign_with_the_series(values: list[float]) -> None:
    there, back = mann_kendall(values), mann_kendall(values[::-1])
    assert there.s == -back.s
    assert there.p == pytest.approx(back.p)
    assert 0 <= there.p <= 1


@pytest.mark.parametrize("tau", [1.5, 4.0, 9.0])
def test_an_exponential_is_found_again(tau: float) -> None:
    n = np.arange(1.0, 31.0)
    curve = fit_exponential(n, 1.5 + 4.0 * np.exp(-n / tau))
    assert (curve.a, curve.b, curve.c) == pytest.approx((1.5, 4.0, tau), rel=1e-3)


def test_a_power_law_is_found_again_and_preferred() -> None:
    n = np.arange(1.0, 31.0)
    values = 1.0 + 5.0 * n**-0.8
    assert fit_power(n, values).c == pytest.approx(0.8, rel=1e-3)
    learning = fit_learning_curve(list(n), list(values))
    assert learning is not None
    assert learning.curve.form == "power"


def test_the_interval_of_the_learning_constant_covers_the_truth() -> None:
    """Of 200 noisy series, the 95 % interval holds the true tau in about 95 %."""
    rng = np.random.default_rng(5)
    n = np.arange(1.0, 23.0)
    truth = 1.5 + 4.0 * np.exp(-n / 4.0)
    covered, in_band = 0, 0
    for _ in range(200):
        curve = fit_exponential(n, truth + rng.normal(0, 0.3, len(n)))
        low = 0.0 if math.isnan(curve.c_low) else curve.c_low
        high = math.inf if math.isnan(curve.c_high) else curve.c_high
        covered += low <= 4.0 <= high
        in_band += bool(curve.low[10] <= truth[10] <= curve.high[10])
    assert 180 <= covered <= 199
    assert 180 <= in_band <= 199


def test_noise_alone_is_a_level_line() -> None:
    rng = np.random.default_rng(2)
    level = sum(
        learning is not None and learning.curve.form == "level"
        for learning in (fit_learning_curve(range(1, 23), list(rng.normal(5, 1, 22))) for _ in range(50))
    )
    assert level >= 35
    assert fit_level(np.full(9, 3.0)).low == pytest.approx(3.0)


def test_below_eight_trials_nothing_is_fitted() -> None:
    curves = learning_curves(trials_of(np.linspace(5, 2, 7)))
    assert curves["e_diff"]["fit"] is None
    assert str(curves["e_diff"]["text"]).startswith("Not enough trials")


def test_the_learning_constant_is_given_from_twenty_trials_on() -> None:
    rng = np.random.default_rng(3)
    n = np.arange(1.0, 23.0)
    values = 1.5 + 6.0 * np.exp(-n / 3.0) + rng.normal(0, 0.15, len(n))
    long = learning_curves(trials_of(values))["e_diff"]
    short = learning_curves(trials_of(values[:19]))["e_diff"]
    assert "learning constant of" in str(long["details"][0])
    assert "learning constant" not in str(short["details"][0])
    assert set(long["fit"]) == {"n", "value", "low", "high"}
    assert len(long["fit"]["n"]) == 22
    assert all(low <= high for low, high in zip(long["fit"]["low"], long["fit"]["high"], strict=True))


def test_trials_that_missed_the_goal_do_not_count() -> None:
    trials = trials_of(np.linspace(5, 2, 10))
    for trial in trials[:3]:
        trial["reached"] = False
    assert "7 of at least 8" in str(learning_curves(trials)["e_diff"]["text"])


def test_numbers_that_are_missing_are_left_out_and_the_answer_is_json() -> None:
    trials = trials_of(np.linspace(5, 2, 12), "time")
    trials[4]["time"] = None
    trials[5]["time"] = math.nan
    curves = learning_curves(trials)
    assert set(curves) == {"time"}
    assert curves["time"]["fit"] is not None
    assert 5.0 not in curves["time"]["fit"]["n"]
    json.dumps(to_jsonable_python(curves), allow_nan=False)


def test_a_share_is_said_in_percent_and_fitted_as_it_is_stored() -> None:
    shares = 0.9 - 0.5 * np.exp(-np.arange(22) / 4)
    curve = learning_curves(trials_of(shares, "follow_near"))["follow_near"]
    assert " rose by about 39 percentage points, from 51 to 90 %." in str(curve["text"])
    assert "levels off at about 90 %" in str(curve["text"])
    assert " rose from 51 % to 90 %." in str(curve["details"][0])
    assert "percentage point" in str(curve["details"][0])
    assert max(curve["fit"]["value"]) < 1


def test_within_one_session_its_trials_are_compared() -> None:
    details = learning_curves(trials_of(np.linspace(5, 2, 22)))["e_diff"]["details"]
    assert "The last third of the trials against the first, beside" in str(details[0])


def test_equal_values_are_level() -> None:
    curve = learning_curves(trials_of(np.zeros(22), "collisions"))["collisions"]
    assert curve["fit"] is None
    assert str(curve["text"]).startswith("Within noise over 22 trials: ")


def test_few_trials_are_called_few() -> None:
    rng = np.random.default_rng(4)
    values = 1.5 + 6.0 * np.exp(-np.arange(1.0, 23.0) / 3.0) + rng.normal(0, 0.15, 22)
    assert "12 trials are few" in str(learning_curves(trials_of(values[:12]))["e_diff"]["text"])
    assert "are few" not in str(learning_curves(trials_of(values))["e_diff"]["text"])


def test_the_curves_that_were_not_chosen_cost_more_and_come_on_demand() -> None:
    values = 1.0 + 5.0 * np.arange(1.0, 31.0) ** -0.8 + np.random.default_rng(6).normal(0, 0.05, 30)
    curve = learning_curves(trials_of(values), every_model=True)["e_diff"]
    assert curve["form"] == "power"
    assert [other["form"] for other in curve["others"]] == ["exponential", "level"]
    assert 0 < curve["others"][0]["aicc_more"] < curve["others"][1]["aicc_more"]
    assert "others" not in learning_curves(trials_of(values))["e_diff"]
    few = learning_curves(trials_of(values[:7]), every_model=True)["e_diff"]
    assert (few["form"], few["others"]) == (None, [])


def test_one_unusual_trial_at_the_end_does_not_contradict_the_trend() -> None:
    values = np.linspace(6, 2, 60)
    values[-1] = 7.0
    curve = learning_curves(trials_of(values))["e_diff"]
    assert "fell from 5.93 m² to 2.14 m²" in str(curve["details"][0])
    assert "falls by 0.068 m² in the median" in str(curve["details"][0])
    values[-3:] = 7.0
    assert ": the area off the path fell." in str(learning_curves(trials_of(values))["e_diff"]["text"])


def test_a_curve_that_is_still_falling_is_not_said_to_level_off() -> None:
    n = np.arange(1.0, 23.0)
    values = 8.0 * np.exp(-n / 40.0) + np.random.default_rng(7).normal(0, 0.05, len(n))
    learning = fit_learning_curve(list(n), list(values))
    assert learning is not None
    assert (learning.curve.form, learning.constant) == ("exponential", None)
    curve = learning_curves(trials_of(values))["e_diff"]
    assert str(curve["text"]).endswith(" It has not levelled off yet.")
    assert "not levelled off" in str(curve["details"][0])


NUMBERS = st.floats(-1e90, 1e90) | st.sampled_from([0.0, 1.0, -1.0, 5e-324, 1e-200, 1e90, 3.0000000000000004])


@given(st.lists(NUMBERS, min_size=8, max_size=30), st.sampled_from([1, 7, 900]))
def test_no_series_raises_warns_or_gives_a_number_that_is_not_finite(values: list[float], first: int) -> None:
    trials = [{"number": first + i, "time": value} for i, value in enumerate(values)]
    curve = learning_curves(trials, every_model=True)["time"]
    json.dumps(to_jsonable_python(curve), allow_nan=False)
    for drawn in [curve["fit"], *curve["others"]]:
        assert drawn is None or all(
            low <= value <= high for low, value, high in zip(drawn["low"], drawn["value"], drawn["high"], strict=True)
        )


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 1000), st.sampled_from([1e-12, 1e-3, 1e9]), st.floats(-100, 100))
def test_the_unit_of_a_measure_makes_no_difference(seed: int, unit: float, offset: float) -> None:
    n = np.arange(1.0, 16.0)
    values = 1.0 + 4.0 * np.exp(-n / 3.0) + np.random.default_rng(seed).normal(0, 0.3, len(n))
    plain, other = fit_exponential(n, values), fit_exponential(n, unit * (values + offset))
    assert other.c == pytest.approx(plain.c, rel=1e-2)
    assert other.value == pytest.approx(unit * (plain.value + offset), abs=1e-3 * unit)
    assert other.aicc == pytest.approx(plain.aicc, abs=1e-3)


@pytest.mark.parametrize(
    ("place", "form", "aicc", "c_low", "c_high", "first_low", "sixth_high"),
    [
        (2, "level", -16.345475573766667, math.nan, math.nan, 2.7983407187180696, 4.384992614615263),
        (
            0,
            "exponential",
            -41.1440904364792,
            2.419312430368448,
            10.480607826991175,
            5.367547147283152,
            3.7147224090446,
        ),
        (1, "power", -39.32613521870738, math.nan, math.nan, 5.520662455427096, 3.6716042859719553),
    ],
)
def test_bands_intervals_and_aicc_are_those_of_statsmodels(
    place: int, form: str, aicc: float, c_low: float, c_high: float, first_low: float, sixth_high: float
) -> None:
    # Computed with statsmodels 0.15.0: OLS(...).get_prediction().conf_int(), OLS(...).conf_int() and aicc_sigma.
    values = [6.1, 4.9, 5.2, 3.8, 4.1, 3.0, 3.3, 2.9, 2.4, 2.7, 2.2, 2.5]
    learning = fit_learning_curve(range(1, 13), values)
    assert learning is not None
    curve = learning.curves[place]
    assert curve.form == form
    found = (curve.aicc, curve.c_low, curve.c_high, curve.low[0], curve.high[5])
    assert found == pytest.approx((aicc, c_low, c_high, first_low, sixth_high), rel=1e-9, nan_ok=True)


def test_values_beyond_any_measure_are_left_out() -> None:
    trials = trials_of(np.linspace(5, 2, 12))
    trials[3]["e_diff"] = 1e300
    fit = learning_curves(trials)["e_diff"]["fit"]
    assert fit is not None
    assert 4.0 not in fit["n"]


def test_the_robust_slope_tolerates_a_third_of_outliers() -> None:
    values = np.arange(1.0, 22.0) * -0.5
    values[::4] += 30.0
    slope = theil_sen(list(range(1, 22)), list(values))
    assert slope == pytest.approx(-0.5)


def test_a_count_that_is_mostly_the_same_has_a_trend_but_no_step() -> None:
    trials = trials_of(np.array([3.0] * 12 + [0.0] * 20), "collisions")
    curve = learning_curves([{**one, "session": 1 + place // 4} for place, one in enumerate(trials)])["collisions"]
    assert "fell by about 3, from 3 to 0." in str(curve["text"])
    assert "From trial to trial" not in str(curve["details"][0])


def curve_of(name: str, values: np.ndarray, sessions: int = 0) -> dict[str, object]:
    """Return the curve of a measure over trials in so many sessions; 0: not known."""
    each = -(-len(values) // sessions) if sessions else 0
    rows = [
        {"number": i + 1, name: float(value)} | ({"session": i // each + 1} if sessions else {})
        for i, value in enumerate(values)
    ]
    return learning_curves(rows)[name]


def test_what_became_better_is_said_with_its_amount_and_its_level() -> None:
    assert str(curve_of("e_diff", FALLING, sessions=4)["text"]) == (
        "Better than noise over 28 trials in 4 sessions: the area off the path fell by about 1.74 m², "
        "from 3.30 to 1.55 m². It levels off at about 1.53 m²."
    )


def test_noise_has_neither_an_amount_nor_a_direction() -> None:
    noise = 3.0 + np.random.default_rng(8).normal(0, 0.3, 22)
    text = curve_of("e_diff", noise)["text"]
    assert re.fullmatch(r"Within noise over 22 trials: the area off the path was about \d\.\d\d m²\.", str(text))


@pytest.mark.parametrize(
    ("name", "values", "begin"),
    [
        ("e_diff", -FALLING + 8, "Worse than noise over 28 trials: the area off the path rose by about "),
        ("gap_clearance", FALLING, "Worse than noise over 28 trials: the narrowest clearance in a gap fell by about "),
        ("gap_clearance", -FALLING + 8, "Better than noise over 28 trials: "),
        ("mean_speed", FALLING, "Over 28 trials: the mean speed was about "),
    ],
)
def test_the_word_is_that_of_the_verdicts(name: str, values: np.ndarray, begin: str) -> None:
    assert str(curve_of(name, values)["text"]).startswith(begin)


def test_numbers_are_written_as_everywhere_on_the_pages() -> None:
    rising = curve_of("sparc", -FALLING)
    assert "from \u22123.30 to \u22121.55." in str(rising["text"])
    assert "-" not in str(rising["text"]) + "".join(map(str, rising["details"]))  # type: ignore[call-overload]


def test_the_level_of_a_count_is_never_below_none() -> None:
    counts = np.round(6 * np.exp(-np.arange(28) / 5))
    text = str(curve_of("collisions", counts, sessions=7)["text"])
    assert "fell by about 5, from 5 to 0." in text
    assert "\u2212" not in text


def test_no_plain_sentence_has_a_statistic_and_all_of_them_are_in_the_details() -> None:
    for case in product(TRIAL_MEASURES, (5, 8, 12, 28), (1.0, -1.0, 0.0)):
        name, count, sign = case
        curve = curve_of(name, sign * FALLING[:count], sessions=4 if count == 28 else 1)
        assert STATISTICS.findall(f"{curve['text']} {curve['sessions'] or ''}") == [], case
        details = curve["details"]
        assert isinstance(details, list), case
        of_sessions = count == 28 and name != "mean_speed"  # which leads in no task
        assert len(details) == (0 if count == 5 else 2 if of_sessions else 1), case
        assert all("99 %" in str(one) or "medians of" in str(one) for one in details), case
