"""The cumulative sum (CUSUM): whether small deviations in one direction add up to a change."""

import math
from collections.abc import Sequence

from app.scoring.verdict.spread import Variance

ALLOWANCE = 0.5  # standard deviations of each value that are not counted
LIMIT = 3.0  # standard deviations, added up: beyond it there is a change
MOST_OF_ONE = 3.0  # standard deviations that one value adds at most: one outlier is no change


def next_sum(total: float, surprise: float) -> float:
    """Return the sum after one more value: max(0, total + min(surprise, MOST_OF_ONE) - ALLOWANCE).

    `surprise` is the value's deviation in the tested direction, in standard deviations. Source: Page,
    Biometrika 41 (1954); the bound of a single value is ours.
    """
    return max(0.0, total + min(surprise, MOST_OF_ONE) - ALLOWANCE)


def cumulative_sum(surprises: Sequence[float]) -> float:
    """Return the sum after all `surprises`, oldest first; a sum beyond LIMIT is a change."""
    total = 0.0
    for surprise in surprises:
        total = next_sum(total, surprise)
    return total


def normal_score(difference: float, variance: Variance) -> float | None:
    """Return a difference over its standard deviation, as Student's t, and expressed as a standard normal one.

    None where the variance has no degrees of freedom or is zero.
    """
    from scipy.special import ndtri, stdtr

    if variance.df <= 0 or variance.value <= 0:
        return None
    return float(ndtri(stdtr(variance.df, difference / math.sqrt(variance.value))))
