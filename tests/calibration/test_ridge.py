"""The ridge regression finds the least sum of squares, in whatever unit, and reads no feature of infinite penalty."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from app.calibration.ridge import ridge


@given(seed=st.integers(0, 10_000), left_out=st.sets(st.integers(0, 3), max_size=3), unit=st.floats(1e-6, 1e6))
def test_the_weights_are_those_of_least_squares_with_the_penalty_as_further_rows(seed, left_out, unit):
    rng = np.random.default_rng(seed)
    features, labels = rng.normal(size=(20, 4)) * [1.0, 1.0, 1.0, unit], rng.normal(size=20)
    penalty = rng.uniform(0.1, 10.0, size=4) * [1.0, 1.0, 1.0, unit**2]
    read = [i for i in range(4) if i not in left_out]
    penalty[sorted(left_out)] = np.inf
    rows = np.concatenate((features[:, read], np.diag(np.sqrt(penalty[read]))))
    expected = np.zeros(4)
    expected[read] = np.linalg.lstsq(rows, np.concatenate((labels, np.zeros(len(read)))))[0]
    weights = ridge(features.T @ features, features.T @ labels, penalty)
    np.testing.assert_allclose(weights * [1.0, 1.0, 1.0, unit], expected * [1.0, 1.0, 1.0, unit], atol=1e-9)
