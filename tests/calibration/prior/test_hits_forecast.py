"""The expected hits of a map from other people: their strokes count beside what this person did."""

import numpy as np
import pytest

from app.calibration.prior.forecasts import expected_hits, share_of_others

WAVE = np.sin(np.linspace(0.0, 40.0, 4_000))  # free movement whose rate peaks at 1


def hits(free: np.ndarray, dead_zone: float) -> float:
    forecast = expected_hits(free, dead_zone, None, None)
    assert forecast is not None
    return forecast.value


def test_free_movement_that_is_slower_than_strokes_does_not_let_expect_that_nothing_is_answered() -> None:
    slow = hits(WAVE, 1.5)
    assert slow == pytest.approx(100 * share_of_others() / 1.5, abs=0.1)
    assert 40.0 < slow < hits(WAVE, 0.5) < hits(WAVE, 0.1)


def test_the_share_of_other_people_is_that_above_the_dead_zone_of_labelled_time() -> None:
    # 0.9 deviations below the mean of a normal distribution lie 18.4 % of it; a stroke's edges are not labelled
    assert share_of_others() == pytest.approx(0.88 * 0.816, abs=0.001)


def test_nothing_is_expected_of_a_gesture_that_nobody_has_seen_from_this_person() -> None:
    assert expected_hits(np.zeros(1_000), 0.5, None, None) is None
    assert expected_hits(-np.ones(1_000), 0.5, None, None) is None
