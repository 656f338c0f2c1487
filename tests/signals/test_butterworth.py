import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.signals.butterworth import low_pass
from app.signals.low_pass import smooth


@pytest.mark.parametrize(("cutoff", "sample_rate"), [(3, 100), (1, 50), (8, 100), (3, 1000), (8, 20)])
def test_coefficients_are_those_of_scipy(cutoff, sample_rate):
    from scipy.signal import butter

    numerator, denominator = butter(2, cutoff, fs=sample_rate)
    c = low_pass(cutoff, sample_rate)
    np.testing.assert_allclose([c.b0, c.b1, c.b2], numerator, rtol=1e-10)
    np.testing.assert_allclose([1, c.a1, c.a2], denominator, rtol=1e-10)


def test_the_cutoff_is_where_its_name_says():
    from scipy.signal import freqz

    c = low_pass(3.0, 100.0)
    _, response = freqz([c.b0, c.b1, c.b2], [1, c.a1, c.a2], worN=[3.0], fs=100.0)
    assert abs(response[0]) == pytest.approx(2**-0.5, rel=1e-9)


def test_a_cutoff_beyond_half_the_sample_rate_is_refused_in_words():
    with pytest.raises(ValueError, match="3 Hz needs a sample rate above 6 Hz"):
        low_pass(3.0, 5.0)


@given(st.floats(-1e6, 1e6))
def test_a_constant_passes_unchanged_from_the_first_sample_on(level):
    np.testing.assert_allclose(smooth(np.full(50, level), 3.0, 100.0), level, rtol=1e-9, atol=1e-9)
