"""Trend of a measure over trials: the Mann-Kendall test, and the Theil-Sen slope."""

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np

SIGNIFICANCE = 0.05


class Trend(NamedTuple):
    """The result of a Mann-Kendall test."""

    s: int  # pairs that rise minus pairs that fall
    tau: float  # Kendall's tau-b, -1 to 1
    p: float  # two-sided

    @property
    def direction(self) -> Literal["falls", "rises", "none"]:
        """Whether the measure falls or rises, at a significance level of 0.05."""
        if self.p >= SIGNIFICANCE or self.s == 0:
            return "none"
        return "falls" if self.s < 0 else "rises"


def mann_kendall(values: Sequence[float]) -> Trend:
    """Test `values` (n,), in the order of the trials, for a monotonic trend.

    Mann-Kendall's S is Kendall's S between the values and their order. The p-value therefore is that of Kendall's tau:
    exact when no two values are equal and n <= 33, otherwise by the normal approximation, with the variance corrected
    for ties.

    Sources: Mann, Econometrica 13 (1945); Kendall, Rank Correlation Methods (1975).
    """
    from scipy.stats import kendalltau

    series = np.asarray(values, dtype=np.float64)
    if len(series) < 2 or np.all(series == series[0]):
        return Trend(0, 0.0, 1.0)
    s = int(np.sum(np.triu(np.sign(series[np.newaxis, :] - series[:, np.newaxis]), 1)))
    outcome = kendalltau(np.arange(len(series)), series, method="auto")
    return Trend(s, float(outcome.statistic), float(outcome.pvalue))


def theil_sen(n: Sequence[float], values: Sequence[float]) -> float:
    """Return the median of the slopes between all pairs of `values` (n,) over rising trial numbers `n` (n,).

    Source: Sen, Journal of the American Statistical Association 63 (1968).
    """
    from scipy.stats import theilslopes

    return float(theilslopes(values, n).slope)
