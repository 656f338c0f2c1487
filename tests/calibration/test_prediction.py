"""Predictions compared with simulated processes of known rates."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.gestures.prediction import (
    at_least_share,
    at_most_per_minute,
    count_crossings,
    false_per_minute,
    hit_probability,
    rest_statistics,
)
from app.signals.low_pass import smooth

RATE = 100.0


def rest(seconds, seed, noise=1.0):
    """Return the rate (FS/s) of white noise filtered by the chain's low-pass, as of a joint at rest."""
    place = smooth(noise * np.random.default_rng(seed).normal(size=round(seconds * RATE) + 100), 3.0, RATE)
    return (np.diff(place) * RATE)[100:]


def test_rices_formula_counts_what_long_noise_does():
    quiet = rest_statistics([rest(600, 1)], RATE)
    later = rest(6000, 2)
    for z in (2.0, 3.0, 3.5):
        counted = count_crossings([later], z * quiet.noise) / 100.0
        assert false_per_minute(quiet, z * quiet.noise) == pytest.approx(counted, rel=0.35)


def test_what_short_noise_predicts_is_right_on_average():
    """Rests of 3 s each, with a dead-zone of three times the measured noise."""
    predicted, counted = [], []
    for seed in range(150):
        quiet = rest_statistics([rest(3, seed)], RATE)
        predicted.append(false_per_minute(quiet, 3.0 * quiet.noise))
        counted.append(count_crossings([rest(60, 1000 + seed)], 3.0 * quiet.noise))
    assert np.mean(predicted) == pytest.approx(np.mean(counted), rel=0.35)


def test_less_data_predict_more_false_activations():
    short, long = rest_statistics([rest(3, 4)], RATE), rest_statistics([rest(3, 4)] * 20, RATE)
    assert short.noise == pytest.approx(long.noise)
    assert false_per_minute(short, 4 * short.noise) > false_per_minute(long, 4 * long.noise)


@settings(max_examples=30, deadline=None)
@given(st.floats(0.01, 10.0), st.floats(0.01, 10.0), st.floats(1e-3, 1e3))
def test_a_larger_dead_zone_is_never_worse_and_the_unit_does_not_matter(one, other, scale):
    quiet = rest_statistics([rest(3, 7)], RATE)
    low, high = sorted((one * quiet.noise, other * quiet.noise))
    assert false_per_minute(quiet, low) >= false_per_minute(quiet, high)
    scaled = rest_statistics([scale * rest(3, 7)], RATE)
    assert false_per_minute(scaled, scale * low) == pytest.approx(false_per_minute(quiet, low), rel=1e-6)


def test_no_rest_gives_no_statistics_and_a_silent_rest_no_false_activations():
    assert rest_statistics([], RATE) is None
    assert rest_statistics([np.zeros(2)], RATE) is None
    assert false_per_minute(rest_statistics([np.zeros(300)], RATE), 0.15) == 0.0
    assert at_most_per_minute(0, 0.0) is None


def test_each_crossing_is_counted_once():
    assert count_crossings([np.array([0, 2, 2, 0, 2]), np.array([2, 2]), np.array([0.0])], 1.0) == 3


def test_the_count_alone_proves_three_per_time():
    assert at_most_per_minute(0, 3.0) == pytest.approx(59.9, abs=0.1)  # 2.996 in 3 s
    assert at_most_per_minute(0, 9.0) == pytest.approx(20.0, abs=0.1)  # below 20 a minute it takes nine seconds
    assert at_most_per_minute(3, 60.0) == pytest.approx(7.75, abs=0.01)
    assert at_least_share(3, 3) == pytest.approx(0.05 ** (1 / 3))
    assert at_least_share(0, 3) == 0.0


def test_hits_are_right_on_average_for_few_repetitions():
    """Each person has another spread; three movements predict a hundred."""
    random = np.random.default_rng(3)
    predicted, made = [], []
    for _ in range(300):
        spread = random.uniform(0.05, 0.4)
        peaks = np.exp(random.normal(0.0, spread, 3))
        others = [np.exp(random.normal(0.0, spread, 3)) for _ in range(5)]
        level = 0.8 * np.median(peaks)  # a share of the median peak, like half of full
        predicted.append(hit_probability(peaks, level, others))
        made.append(np.mean(np.exp(random.normal(0.0, spread, 100)) >= level))
    assert np.mean(predicted) == pytest.approx(np.mean(made), abs=0.04)


@settings(max_examples=30, deadline=None)
@given(st.lists(st.floats(0.1, 10.0), min_size=1, max_size=5), st.floats(0.05, 20.0), st.floats(1.01, 3.0))
def test_a_hit_is_a_probability_that_falls_with_the_level(peaks, level, factor):
    low, high = hit_probability(peaks, level), hit_probability(peaks, factor * level)
    assert 0.0 <= high <= low <= 1.0
