"""Full and the expected hits of a map from other people: by the peaks of this person's own movements."""

import numpy as np
import pytest

from app.calibration.prior.forecasts import LEAST_FULL, expected_hits, own_full, own_peaks
from app.calibration.prior.solving import OwnFrames

WAVE = np.sin(np.linspace(0.0, 40.0, 4_000))  # free movement whose rate peaks at 1
OF_OTHERS = 3.0


def repetitions(*peaks):
    """Return the held-out rate and the frames of repetitions of 100 rows, each with its peak in the labelled part."""
    rate = np.concatenate([peak * np.sin(np.linspace(0.0, np.pi, 100)) for peak in peaks])
    label = np.tile(np.abs(np.arange(100) - 50) < 40, len(peaks)).astype(np.int8)
    number = np.repeat(np.arange(len(peaks)), 100)
    return rate, OwnFrames(np.zeros((len(rate), 1)), label, number, np.full(len(peaks), 100))


def test_full_is_the_median_peak_of_three_own_repetitions_and_nothing_else():
    peaks = own_peaks(10.0 * WAVE, 0.2, *repetitions(0.8, 1.4, 1.0))
    assert own_full(peaks, 0.2, OF_OTHERS) == pytest.approx(1.0, abs=0.01)


def test_the_free_movement_counts_as_one_repetition_before_there_are_three():
    peaks = own_peaks(WAVE, 0.2, *repetitions(0.6))
    assert own_full(peaks, 0.2, OF_OTHERS) == pytest.approx((0.6 + np.percentile(WAVE, 97)) / 2, abs=0.01)
    assert own_full(own_peaks(WAVE, 0.2, None, None), 0.2, OF_OTHERS) == pytest.approx(np.percentile(WAVE, 97))


def test_a_free_movement_that_never_went_this_way_leaves_other_people_s_full():
    for free in (np.zeros(1_000), -np.ones(1_000), 0.1 * WAVE):
        peaks = own_peaks(free, 0.5, None, None)
        assert own_full(peaks, 0.5, OF_OTHERS) == OF_OTHERS
        assert expected_hits(peaks, 0.5, OF_OTHERS, 0) is None


def test_full_is_clearly_above_the_dead_zone_however_slow_somebody_is():
    assert own_full([0.4, 0.5, 0.6], 0.6, OF_OTHERS) == pytest.approx(LEAST_FULL * 0.6)


def test_a_slow_person_is_expected_to_be_answered_with_the_own_full_and_not_with_that_of_others():
    peaks = [0.9, 1.0, 1.1]
    own, others = (expected_hits(peaks, 0.3, full, 3) for full in (own_full(peaks, 0.3, OF_OTHERS), OF_OTHERS))
    assert own.value > 95.0
    assert others.value < 5.0


def test_more_repetitions_make_the_forecast_surer():
    uncertainties = [expected_hits([1.0], 0.3, 1.0, count).uncertainty for count in range(4)]
    assert uncertainties == sorted(uncertainties, reverse=True)
    assert len(set(uncertainties)) == 4
