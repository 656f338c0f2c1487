"""Gaps of single channels: short and rare ones are bridged for fitting, others are named."""

from functools import cache

import numpy as np
import pytest
from calibration.simulated_person import SimulatedPerson, calibrate, layout_of
from hypothesis import given, settings
from hypothesis import strategies as st

from app.calibration.gaps import bridge_gaps, why_missing
from bench.learning.guided_map import FOLDER, Knit

RATE = 100.0
SHIRT = layout_of()


@cache
def free_movement():
    """Return the values of a free movement without gaps."""
    return SimulatedPerson(SHIRT, seed=5).free()


@cache
def whole_profile():
    """Return what is fitted to it."""
    return calibrate(SimulatedPerson(SHIRT, seed=5), free=free_movement())


@given(st.lists(st.tuples(st.integers(0, 999), st.integers(1, 60)), max_size=8), st.floats(-5, 5), st.floats(-5, 5))
def test_short_gaps_become_straight_lines_and_long_ones_stay(gaps, offset, slope):
    line = offset + slope * np.arange(1000.0) / RATE
    values = np.stack([line, line], axis=1)
    for start, length in gaps:
        values[start : start + length, 0] = np.nan
    filled = bridge_gaps(values, RATE)
    missing = np.isnan(values[:, 0])
    edges = np.flatnonzero(np.diff(np.concatenate(([0], missing, [0]))))
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        inside = start > 0 and end < len(line)
        if end - start > 20:
            assert np.isnan(filled[start:end, 0]).all()
        elif inside:
            np.testing.assert_allclose(filled[start:end, 0], line[start:end], atol=1e-9)
        else:
            assert np.isfinite(filled[start:end, 0]).all()
    np.testing.assert_array_equal(filled[~missing], values[~missing])
    np.testing.assert_array_equal(filled[:, 1], line)


@settings(max_examples=20, deadline=None)
@given(st.data())
def test_a_short_gap_leaves_nothing_out_and_changes_the_weights_little(data):
    free = free_movement().copy()
    for channel in range(free.shape[1]):
        length = data.draw(st.integers(1, min(20, len(free) // 100)))
        start = data.draw(st.integers(0, len(free) - length))
        free[start : start + length, channel] = np.nan
    holed = calibrate(SimulatedPerson(SHIRT, seed=5), free=free)
    assert holed.left_out == {}
    for one, other in zip(whole_profile().joints, holed.joints, strict=True):
        np.testing.assert_allclose(other.direction, one.direction, atol=0.02)
        assert other.span == pytest.approx(one.span, rel=0.02)


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        (slice(300, 320), "None"),
        (slice(300, 321), "misses 0.21 s at once, and at most 0.2 s are bridged"),
        (slice(0, 3000, 50), "misses 2.0 % of its samples, and at most 1 % are bridged"),
        (slice(0, 3000, 100), "None"),
        (slice(None), "gives no numbers"),
    ],
)
def test_too_many_missing_samples_are_described(rows, words):
    values = np.zeros((3000, 2))
    values[rows, 0] = np.nan
    assert str(why_missing([values], 0, RATE)) == words
    assert why_missing([values], 1, RATE) is None


def test_only_missing_samples_in_fitted_pieces_count():
    whole, holed = np.zeros((1000, 2)), np.zeros((1000, 2))
    holed[::60, 0] = np.nan
    assert why_missing([holed], 0, RATE) is not None
    assert why_missing([holed, whole], 0, RATE) is None


@pytest.mark.skipif(not FOLDER.exists(), reason="the recordings of the knit are not on this machine")
def test_a_few_missing_cells_cost_the_knit_nothing():
    """0.02 % of each channel: before, one missing cell left the channel out."""
    knit = Knit()
    rows = knit.prompts(seed=1)
    within = np.flatnonzero(knit.t < 20.0)
    values = knit.values.copy()
    dice = np.random.default_rng(2)
    for channel in range(values.shape[1]):
        if channel % 5 == 0:
            continue  # of each joint one channel is whole: it alone was kept before
        missing = dice.choice(within, max(1, round(2e-4 * len(within))), replace=False)
        values[missing, channel] = np.nan
    whole, holed = knit.fit(rows), knit.fit(rows, values=values)
    assert holed.profile.left_out == {}
    for one, other in zip(whole.profile.joints, holed.profile.joints, strict=True):
        assert other.evr == pytest.approx(one.evr, abs=0.001)
    for kind in ("pca", "guided"):
        np.testing.assert_allclose(knit.measures(holed.profile, kind), knit.measures(whole.profile, kind), atol=0.005)
