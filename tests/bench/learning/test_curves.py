"""The bench of the learning curve: what it counts as covered, and that its table holds roughly with few series."""

import numpy as np
import pytest

from bench.learning.curves import CASES, HEAD, LEVEL, SHORT, Truth, outcomes, row


@pytest.mark.parametrize(("truth", "noise"), [(SHORT, 0.3), (LEVEL, 0.5)])
def test_the_band_covers_about_as_often_as_it_says_and_the_shape_is_found(truth: Truth, noise: float) -> None:
    in_band, _, is_chosen = np.mean(list(outcomes(truth, noise, 22, 60)), axis=0)
    assert 0.90 <= in_band <= 0.99
    assert is_chosen >= 0.65


def test_without_noise_everything_is_found() -> None:
    (one,) = outcomes(SHORT, 1e-6, 22, 1)
    assert one.is_chosen
    assert one.in_band > 0.5


def test_the_table_has_a_line_of_equal_cells_for_each_case() -> None:
    lines = [row(truth, noise, trials, 2) for truth, noise, trials in CASES]
    assert {line.count("|") for line in lines} == {HEAD.splitlines()[0].count("|")}
