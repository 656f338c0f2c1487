"""Predicts from few data how a gesture will behave: its false activations at rest, and its hit rate.

Both predictions include the uncertainty of their estimates, so that fewer data predict more errors. The noise, known
from a few seconds of rest, is averaged over its possible values; the next peak of a movement, known from three
repetitions, follows a t distribution.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

CONFIDENCE = 0.95  # of every bound
HIT_ACTIVATION = 0.5  # of a full activation: from here on a movement counts as a hit
CORRELATION_TIME = 0.3  # s: over longer times, samples of the filtered rate are taken as independent
PRIOR_FREEDOM = 4.0  # weight of the other gestures' spread, in repetitions
USUAL_SPREAD = 0.15  # relative, of a peak, where no other gesture gives one: repeated movements differ by about a tenth
LEAST_SPREAD = 0.03  # relative, of a peak: no person repeats a movement more exactly


class RestStatistics(NamedTuple):
    """Statistics of a joint's rate at rest."""

    noise: float  # FS/s, root mean square
    crossings: float  # expected upward crossings of zero per s, for a Gaussian process
    seconds: float  # duration of the rest
    freedom: float  # degrees of freedom of `noise`


def rest_statistics(pieces: Sequence[NDArray[np.float64]], sample_rate: float) -> RestStatistics | None:
    """Return the statistics over all pieces (n,) of a rate at rest in FS/s, None when every piece is too short.

    The crossings are those of a Gaussian process, sigma of the derivative / sigma / 2 pi (Rice, Bell System Technical
    Journal 24, 1945). Successive samples are not independent: for a variance, n samples count as n / (sum of the
    squared autocorrelations) (Bartlett, Journal of the Royal Statistical Society B 8, 1946).
    """
    pieces = [piece for piece in pieces if len(piece) > 2]
    if not pieces:
        return None
    count = sum(map(len, pieces))
    noise = math.sqrt(float(np.mean(np.concatenate(pieces) ** 2)))
    if noise == 0:
        return RestStatistics(0.0, 0.0, count / sample_rate, float(count))
    steps = np.concatenate([np.diff(piece) for piece in pieces]) * sample_rate
    crossings = math.sqrt(float(np.mean(steps**2))) / noise / (2.0 * math.pi)
    alike = 1.0
    for lag in range(1, max(2, round(CORRELATION_TIME * sample_rate))):
        products = [piece[lag:] * piece[:-lag] for piece in pieces if len(piece) > lag]
        alike += 2.0 * (sum(float(product.sum()) for product in products) / count / noise**2) ** 2
    return RestStatistics(noise, crossings, count / sample_rate, max(1.0, count / alike))


def false_per_minute(quiet: RestStatistics, dead_zone: float) -> float:
    """Return how often per minute a rate at rest is expected to cross `dead_zone` (FS/s) upwards.

    Rice's formula, crossings exp(-z^2 / 2) with z = dead_zone / noise, averaged over the possible values of the noise:
    with n degrees of freedom the average is crossings (1 + z^2 / n)^(-n / 2).
    """
    if quiet.noise == 0:
        return 0.0
    z = dead_zone / quiet.noise
    return 60.0 * quiet.crossings * math.exp(-0.5 * quiet.freedom * math.log1p(z * z / quiet.freedom))


def count_crossings(pieces: Sequence[NDArray[np.float64]], dead_zone: float) -> int:
    """Return how often the pieces (n,) of a rate cross `dead_zone` upwards; a piece that begins above it counts one."""
    above = [np.concatenate(([False], piece > dead_zone)) for piece in pieces]
    return int(sum(np.count_nonzero(~flags[:-1] & flags[1:]) for flags in above))


def at_most_per_minute(counted: int, seconds: float) -> float | None:
    """Return the upper 95 % bound of the rate per minute when `counted` events happened in `seconds`.

    Exact for a Poisson process (Garwood, Biometrika 28, 1936); about three events per `seconds` when none was counted.
    """
    from scipy.stats import chi2

    return None if seconds <= 0 else float(chi2.ppf(CONFIDENCE, 2 * counted + 2)) / 2.0 * 60.0 / seconds


def at_least_share(hits: int, of: int) -> float:
    """Return the lower 95 % bound of the probability of a hit (Clopper and Pearson, one-sided)."""
    from scipy.stats import beta

    return float(beta.ppf(1.0 - CONFIDENCE, hits, of - hits + 1)) if hits else 0.0


def hit_probability(peaks: Sequence[float], level: float, others: Sequence[Sequence[float]] = ()) -> float:
    """Return the probability that the next movement's peak reaches `level`.

    Peaks are taken as log-normal, because their noise grows with their size. Their variance is moderated by that of
    the person's other gestures (`others`: peaks of each), which counts as four repetitions (method: Smyth, Statistical
    Applications in Genetics and Molecular Biology 3, 2004). All peaks in FS/s.
    """
    from scipy.stats import t

    logs = np.log(np.maximum(peaks, 1e-3 * level))
    count = len(logs)
    own_freedom = count - 1
    own_variance = float(logs.var(ddof=1)) if own_freedom else 0.0
    variance = (PRIOR_FREEDOM * _usual_variance(others) + own_freedom * own_variance) / (PRIOR_FREEDOM + own_freedom)
    spread = math.sqrt(max(variance, LEAST_SPREAD**2) * (1.0 + 1.0 / count))
    return float(t.sf((math.log(level) - float(logs.mean())) / spread, PRIOR_FREEDOM + own_freedom))


def _usual_variance(others: Sequence[Sequence[float]]) -> float:
    """Return the variance of the logarithm of a peak within the other gestures' repetitions."""
    logs = [np.log(peaks) for peaks in others if len(peaks) > 1 and min(peaks) > 0]
    freedom = sum(len(peaks) - 1 for peaks in logs)
    if not freedom:
        return USUAL_SPREAD**2
    return sum(float(((peaks - peaks.mean()) ** 2).sum()) for peaks in logs) / freedom
