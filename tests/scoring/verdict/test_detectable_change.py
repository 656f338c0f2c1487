"""The minimal detectable change between the means of two sets of trials."""

import math

import pytest

from app.scoring.verdict.detectable_change import noise_of
from app.scoring.verdict.spread import OwnSpread, Variance


def test_the_mdc_is_the_formula_with_students_t() -> None:
    from scipy.stats import t

    spread = OwnSpread(Variance(0.04, 8.0), Variance(0.01 + 0.04 / 5, 4.0), 1 / 5)
    noise = noise_of(spread, 5, 5, same_session=False)
    assert noise is not None
    assert noise.df == pytest.approx(4)  # the means of sessions alone are what is independent
    assert noise.mdc == pytest.approx(t.ppf(0.975, 4) * math.sqrt(2 * (0.01 + 0.04 / 5)))
    fewer = noise_of(spread, 2, 5, same_session=False)
    assert fewer is not None
    parts = 2 * (0.01 + 0.04 / 5), 0.04 * (1 / 2 + 1 / 5 - 2 / 5)
    df = sum(parts) ** 2 / (parts[0] ** 2 / 4 + parts[1] ** 2 / 8)
    assert (fewer.df, fewer.mdc) == pytest.approx((df, t.ppf(0.975, df) * math.sqrt(sum(parts))))
    even = OwnSpread(Variance(0.04, 8.0), Variance(0.0, 4.0), 1 / 5)  # by chance less than the trials say
    least = noise_of(even, 5, 5, same_session=False)
    assert least is not None
    assert least.mdc >= math.sqrt(2 * 0.04 / 5)
    alone = noise_of(spread, 1, 1, same_session=True)
    assert alone is not None
    assert alone.mdc == pytest.approx(t.ppf(0.975, 8) * math.sqrt(2 * 0.04))
