"""The parts of a fit: principal components, ridge regression, the least steps that count."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.calibration.fit.joint_fit import LARGEST_STEP, SMALLEST_STEPS, STEP_MARGIN, least_steps
from app.calibration.fit.repetitions import Repetition
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


RATE = 100.0


def noisy(n=1000, size=0.001, seed=1):
    return np.random.default_rng(seed).normal(0.0, size, (n, 3))


def with_step(size, rise, n=1000):
    """Return noise in which the first channel changes by `size` within `rise` s."""
    frames = noisy(n)
    frames[:, 0] += size * np.clip((np.arange(n) / RATE - 5.0) / rise, 0.0, 1.0)
    return frames


def test_a_quiet_fabric_has_the_smallest_steps_and_no_calibration_permits_steps_of_any_size():
    assert least_steps((0, 1, 2), 1.0, noisy(), noisy(300), [], RATE) == SMALLEST_STEPS
    assert least_steps((0, 1, 2), 1.0, with_step(2.0, 0.01), None, [], RATE).sudden == LARGEST_STEP


def test_noise_makes_sudden_steps_larger_and_tremor_at_rest_filtered_ones():
    assert least_steps((0, 1, 2), 1.0, noisy(size=0.01), None, [], RATE).sudden > 2 * SMALLEST_STEPS.sudden
    t = np.arange(300)[:, np.newaxis] / RATE
    tremor = 0.03 * np.sin(2 * np.pi * 6.0 * t) * np.ones(3)
    assert least_steps((0, 1, 2), 1.0, noisy(), tremor, [], RATE).filtered > 2 * SMALLEST_STEPS.filtered


@pytest.mark.parametrize(("rise", "kind"), [(0.01, "sudden"), (0.05, "filtered")])
@pytest.mark.parametrize("where", ["free movement", "prompts"])
def test_a_step_that_the_calibration_had_is_none(rise, kind, where):
    step = with_step(0.2, rise)
    own = [Repetition("elbow", step, slice(400, 600))] if where == "prompts" else []
    found = least_steps((0, 1, 2), 1.0, noisy() if own else step, noisy(300), own, RATE)
    assert getattr(found, kind) == pytest.approx(STEP_MARGIN * 0.2, rel=0.05)
