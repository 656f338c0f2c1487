"""Decimation: no peak is lost, no value is invented, the order stays."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from app.scoring.decimation import Decimation

lengths = st.integers(min_value=1, max_value=700)
limits = st.integers(min_value=1, max_value=50).map(lambda half: 2 * half)


@settings(max_examples=60, deadline=None)
@given(lengths, limits, st.integers(0, 1000))
def test_columns_are_short_and_keep_peaks_and_order(n, most, seed):
    rng = np.random.default_rng(seed)
    column = rng.normal(size=n)
    column[rng.random(n) < 0.2] = np.nan
    short = Decimation(n, most)
    peaks, sampled, touched = short.peaks(column), short.sampled(np.arange(n)), short.any(column > 1)
    assert len(peaks) == len(sampled) == len(touched) == len(short.rows) <= max(most, 2)
    assert (np.diff(short.rows) >= 0).all()
    assert ((short.rows >= 0) & (short.rows < n)).all()
    if np.isfinite(column).any():
        assert np.nanmin(peaks) == np.nanmin(column)
        assert np.nanmax(peaks) == np.nanmax(column)
    known = column[np.isfinite(column)]
    assert np.isin(peaks[np.isfinite(peaks)], known).all()
    assert touched.any() == (column > 1).any()


def test_a_short_column_stays_and_a_peak_stands_where_it_was():
    short = Decimation(5, 10)
    assert short.peaks(np.arange(5.0)).tolist() == [0, 1, 2, 3, 4]
    column = np.zeros(1000)
    column[437], column[431] = 3.0, -2.0
    peaks = Decimation(1000, 100).peaks(column)
    assert np.flatnonzero(peaks).tolist() == [42, 43]
    assert peaks[42:44].tolist() == [-2.0, 0.0] or peaks[42:44].tolist() == [-2.0, 3.0]


def test_unknown_values_stay_unknown():
    assert np.isnan(Decimation(100, 10).peaks(np.full(100, np.nan))).all()
