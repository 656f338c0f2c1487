"""The least steps that count follow from what the calibration saw."""

import numpy as np
import pytest

from app.calibration.fit.joint_fit import LARGEST_STEP, SMALLEST_STEPS, STEP_MARGIN, least_steps
from app.calibration.fit.repetitions import Repetition

RATE = 100.0


def noisy(n=1000, size=0.001, seed=1):
    return np.random.default_rng(seed).normal(0.0, size, (n, 3))


def with_step(size, rise, n=1000):
    """Return noise in which the first channel changes by `size` within `rise` s."""
    frames = noisy(n)
    frames[:, 0] += size * np.clip((np.arange(n) / RATE - 5.0) / rise, 0.0, 1.0)
    return frames


def test_a_quiet_fabric_has_the_smallest_steps():
    assert least_steps((0, 1, 2), 1.0, noisy(), noisy(300), [], RATE) == SMALLEST_STEPS


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


def test_no_calibration_permits_steps_of_any_size():
    assert least_steps((0, 1, 2), 1.0, with_step(2.0, 0.01), None, [], RATE).sudden == LARGEST_STEP
