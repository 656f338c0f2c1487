"""The Mann-Kendall test: does a measure rise or fall from trial to trial?"""

from collections.abc import Sequence
from typing import Literal, NamedTuple

import numpy as np
from scipy.stats import kendalltau

SIGNIFICANCE = 0.05


class Trend(NamedTuple):
    """The outcome of a Mann-Kendall test."""

    s: int  # pairs that rise minus pairs that fall
    tau: float  # Kendall's tau-b, -1 to 1
    p: float  # two-sided

    @property
    def direction(self) -> Literal["falls", "rises", "none"]:
        """Which way the measure goes, at a significance of 0.05."""
        if self.p >= SIGNIFICANCE or self.s == 0:
            return "none"
        return "falls" if self.s < 0 else "rises"


def mann_kendall(values: Sequence[float]) -> Trend:
    """Test `values` (n,), in the order of the trials, for a monotonic trend.

    Mann-Kendall's S is Kendall's S between the values and their order, so the p-value is that of Kendall's tau:
    exact where no two values are equal and n <= 33, otherwise by the normal approximation, with the variance
    corrected for ties.

    Sources: Mann, Econometrica 13 (1945); Kendall, Rank Correlation Methods (1975).
    """
    series = np.asarray(values, dtype=np.float64)
    if len(series) < 2:
        return Trend(0, 0.0, 1.0)
    s = int(np.sum(np.triu(np.sign(series[np.newaxis, :] - series[:, np.newaxis]), 1)))
    if np.all(series == series[0]):
        return Trend(0, 0.0, 1.0)
    tied = len(np.unique(series)) < len(series)
    method: Literal["asymptotic", "exact"] = "asymptotic" if tied or len(series) > 33 else "exact"
    outcome = kendalltau(np.arange(len(series)), series, method=method)
    return Trend(s, float(outcome.statistic), float(outcome.pvalue))
