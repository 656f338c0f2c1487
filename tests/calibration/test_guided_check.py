"""In-phase share, hit rate and false activations of signals with known results."""

import numpy as np
import pytest

from app.calibration.guided.check import check, dead_zone_of

RATE = 100.0
# 2 s rest, 1 s there, 1 s back, 2 s rest
LABEL = np.repeat([0, 1, -1, 0], [200, 100, 100, 200]).astype(np.int8)
ONE = np.zeros(600, dtype=np.int_)


def measures(rate, dead_zone=0.2, full=1.0, label=LABEL, repetition=ONE):
    return check(rate, label, repetition, dead_zone, full, RATE)


def test_a_perfect_map():
    found = measures(np.where(LABEL > 0, 1.0, 0.0))
    assert (found.in_phase, found.hit_rate, found.false_per_minute, found.false_count) == (1.0, 1.0, 0.0, 0)


def test_half_of_the_activation_on_the_way_back_is_half_in_phase():
    rate = np.where(LABEL != 0, 0.6, 0.0)
    assert measures(rate).in_phase == pytest.approx(0.5)


def test_activation_counts_by_its_size_and_not_above_full():
    rate = np.where(LABEL > 0, 9.0, 0.0) + np.where(LABEL < 0, 0.6, 0.0)
    assert measures(rate).in_phase == pytest.approx(1.0 / 1.5)


def test_hits_are_counted_in_time():
    rate = np.zeros(600)
    rate[200:225] = 1.0
    assert measures(rate).hit_rate == 0.25


def test_false_activations_are_counted_once_each_and_not_beside_a_movement():
    rate = np.zeros(600)
    rate[[50, 51, 52, 100, 500]] = 1.0  # three at rest
    rate[[190, 420]] = 1.0  # within 0.3 s of a labelled movement
    found = measures(rate)
    assert found.false_count == 3
    assert found.false_per_minute == pytest.approx(60 * 3 / (4.0 - 0.6))


def test_the_edge_of_a_movement_is_neither_in_phase_nor_outside():
    rate = np.where(LABEL > 0, 1.0, 0.0)
    rate[190:200] = rate[400:410] = 1.0  # within 0.3 s of a labelled movement
    assert measures(rate).in_phase == 1.0
    rate[100:110] = 1.0
    assert measures(rate).in_phase == pytest.approx(100 / 110)


def test_without_any_activation_nothing_is_in_phase():
    found = measures(np.zeros(600))
    assert (found.in_phase, found.hit_rate) == (0.0, 0.0)


def test_the_end_of_one_repetition_is_not_the_beginning_of_the_next():
    rate = np.where(np.arange(1200) % 600 == 0, 1.0, 0.0)
    found = measures(rate, label=np.tile(LABEL, 2), repetition=np.repeat([0, 1], 600))
    assert found.false_count == 2


def test_the_dead_zone_lets_the_same_share_through():
    rate = np.random.default_rng(1).normal(size=600)
    for share in (0.1, 0.5, 0.9):
        dead_zone = dead_zone_of(rate, LABEL, share)
        assert (rate[LABEL > 0] > dead_zone).mean() == pytest.approx(share, abs=0.011)
