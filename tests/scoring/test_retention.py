"""Changes within sessions and between them: compared, and only with enough sessions."""

import numpy as np
import pytest

from app.scoring.learning import learning_curves
from app.scoring.retention import describe_retention, retention


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


def test_what_is_lost_between_sessions_rises_and_noise_is_called_chance() -> None:
    kept = retention(*sawtooth(6, 8, -3.0, 3.0, noise=0.2))
    assert kept is not None
    sentence = describe_retention(kept, "m²")
    assert "In the mean of 6 sessions it fell by" in sentence
    assert "and rose by" in sentence
    assert sentence.count(" m²") == 2
    kept = retention(*sawtooth(6, 8, 0.0, 0.0, noise=1.0))
    assert kept is not None
    assert describe_retention(kept, "m²").count("may be chance") == 2


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


def test_equal_values_are_no_change_and_the_sentence_stands_with_the_curve() -> None:
    numbers, _ = sawtooth(5, 4, 0.0, 0.0)
    rows = [{"session": session, "stops": 2.0} for session in numbers]
    assert "changed by 0 (may be chance)" in learning_curves(rows)["stops"]["sessions"]
    assert learning_curves([{"stops": 2.0} for _ in numbers])["stops"]["sessions"] is None
