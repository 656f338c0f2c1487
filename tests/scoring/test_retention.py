"""Changes within sessions and between them: compared, and only with enough sessions."""

import numpy as np
import pytest

from app.scoring.learning import learning_curves, retention, session_sentences, session_statistics
from bench.learning.simulated_trials import LEADING, Course, trials


def sawtooth(
    sessions: int, trials: int, within: float, back: float, noise: float = 0.0
) -> tuple[list[int], list[float]]:
    """Return sessions with a change by `within` from the first two trials to the last two, then one by `back`."""
    rng = np.random.default_rng(1)
    numbers, values, start = [], [], 10.0
    for session in range(1, sessions + 1):
        series = start + within * np.linspace(0, 1, trials)
        numbers += [session] * trials
        values += (series + rng.normal(0, noise, trials)).tolist()
        start = float(series[-1]) + back
    return numbers, values


def test_changes_within_and_between_sessions_are_separated() -> None:
    numbers, values = sawtooth(6, 4, -3.0, 1.0)
    kept = retention(numbers, values)
    assert kept is not None
    # Means of two trials at either end: two thirds of the way of four.
    assert (kept.within.mean, kept.within.sessions) == (pytest.approx(-2.0), 6)
    assert (kept.between.mean, kept.between.sessions) == (pytest.approx(0.0), 5)
    assert kept.within.low <= kept.within.mean <= kept.within.high


def test_the_intervals_are_those_of_statsmodels() -> None:
    # As statsmodels 0.15.0 has them: DescrStatsW(changes).tconfint_mean(alpha=0.01).
    numbers = [1] * 4 + [2] * 5 + [3] * 4 + [4] * 4 + [5] * 5
    values = [
        *(6.1, 5.2, 4.9, 4.1, 5.0, 4.4, 4.6, 3.9, 3.7, 4.2, 4.5),
        *(3.6, 3.3, 3.9, 3.1, 3.4, 2.9, 3.3, 3.0, 2.8, 2.9, 2.5),
    ]
    kept = retention(numbers, values)
    assert kept is not None
    assert kept.within == pytest.approx((-0.75, -1.4444403776026435, -0.055559622397356456, 5), rel=1e-9)
    assert kept.between == pytest.approx((0.2, -0.5252299054689487, 0.9252299054689486, 4), rel=1e-9)


def test_what_is_lost_between_sessions_is_told_and_how_much_was_kept() -> None:
    # Without noise, means of two trials at either end: within -2.57, over the pause 1.57, 39 % kept.
    kept = retention(*sawtooth(6, 8, -3.0, 2.0, noise=0.1))
    assert kept is not None
    said = str(session_sentences("e_diff", kept))
    assert said.startswith("Within a session it fell by about 2.")
    assert " over the pause to the next one it rose by about 1.49 m²" in said
    assert said.endswith("(on average of 6 sessions): about 41 % of what was gained was kept.")
    assert str(session_statistics("e_diff", kept)).count(" m² (99 %: ") == 2


@pytest.mark.parametrize(
    ("measure", "within", "back", "end"),
    [
        ("e_diff", -3.0, 4.0, ": nothing of what was gained was kept."),
        ("e_diff", -3.0, -1.0, ": what was gained was kept."),
        ("e_diff", -3.0, 0.45, "noise (on average of 6 sessions): what was gained was kept, as far as can be told."),
        ("e_diff", 3.0, -2.0, "(on average of 6 sessions)."),
        ("gap_clearance", 3.0, -4.0, ": nothing of what was gained was kept."),
        ("mean_speed", 3.0, -2.0, "(on average of 6 sessions)."),
    ],
)
def test_what_was_kept_depends_on_what_is_better(measure: str, within: float, back: float, end: str) -> None:
    kept = retention(*sawtooth(6, 8, within, back, noise=0.2))
    assert kept is not None
    assert str(session_sentences(measure, kept)).endswith(end)


def test_noise_is_called_noise_with_a_real_minus() -> None:
    kept = retention(*sawtooth(6, 8, 0.0, 0.0, noise=1.0))
    assert kept is not None
    assert str(session_sentences("e_diff", kept)) == (
        "Neither the change within a session nor the one over the pause to the next is more than noise "
        "(on average of 6 sessions)."
    )
    statistics = str(session_statistics("e_diff", kept))
    assert statistics.count("within noise") == 2
    assert "by \u2212" in statistics
    assert "-" not in statistics


@pytest.mark.parametrize(("sessions", "trials"), [(3, 8), (8, 3), (1, 30)])
def test_too_few_sessions_or_trials_say_nothing(sessions: int, trials: int) -> None:
    assert retention(*sawtooth(sessions, trials, -3.0, 1.0)) is None
    numbers, values = sawtooth(sessions, trials, -3.0, 1.0)
    rows = [{"session": session, "time": value} for session, value in zip(numbers, values, strict=True)]
    assert learning_curves(rows)["time"]["sessions"] is None


def test_a_short_session_is_left_out_with_the_changes_around_it() -> None:
    numbers, values = sawtooth(7, 6, -3.0, 1.0)
    without = [i for i, session in enumerate(numbers) if session != 4 or i % 6 < 2]
    kept = retention([numbers[i] for i in without], [values[i] for i in without])
    assert kept is not None
    assert (kept.within.sessions, kept.between.sessions) == (6, 4)


def test_only_of_measures_that_lead_and_seldom_without_a_change_is_there_a_sentence_on_sessions() -> None:
    """One of ten measures had a sentence by chance on most pages, one of three in 17 % (95 % intervals)."""
    from scipy.stats import binom

    rng, told = np.random.default_rng(3), 0
    for _ in range(100):
        rows = trials(rng, 0.25, 0.12, Course((5,) * 8), (*LEADING, "stops"))
        curves = learning_curves(rows, (*LEADING, "stops"))
        assert curves["stops"]["sessions"] is None
        told += any(not str(curves[name]["sessions"]).startswith("Neither") for name in LEADING)
    assert told <= binom.ppf(0.98, 100, 0.05)


def test_equal_values_are_no_change_and_the_sentence_stands_with_the_curve() -> None:
    numbers, _ = sawtooth(5, 4, 0.0, 0.0)
    rows = [{"session": session, "stops": 2.0} for session in numbers]
    curve = learning_curves(rows)["stops"]
    assert str(curve["sessions"]).startswith("Neither the change within a session nor ")
    assert "changed by 0 (within noise; 99 %: 0 to 0)" in str(curve["details"][1])
    assert learning_curves([{"stops": 2.0} for _ in numbers])["stops"]["sessions"] is None
