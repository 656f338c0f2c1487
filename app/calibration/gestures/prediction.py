"""Predicts how a gesture will behave, from few data: false activations at rest, and movements that are answered.

Both predictions carry what so few data leave open. A noise that is known from three seconds may be larger than it
looked, and a movement that was seen three times may once be smaller: the one is averaged over what the noise may be,
the other is a t distribution, so that less data predict more errors and never fewer.
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.stats import beta, chi2, t

SURE = 0.95  # of every bound that is said
HIT = 0.5  # of a full activation: from here on a movement counts as answered
MEMORY = 0.3  # s: over which the rate behind the low-pass remembers itself
PRIOR_FREEDOM = 4.0  # how many repetitions' worth the other gestures' spread counts
USUAL_SPREAD = 0.15  # of a peak, where no other gesture tells: able movements differ by about a tenth
LEAST_SPREAD = 0.03  # of a peak: nobody repeats a movement better than that


class Quiet(NamedTuple):
    """The rate of a joint at rest."""

    noise: float  # FS/s, root mean square
    crossings: float  # upward crossings of zero per s that a Gaussian rate of this roughness has
    seconds: float
    freedom: float  # degrees of freedom of `noise`


def quiet_of(pieces: Sequence[NDArray[np.float64]], sample_rate: float) -> Quiet | None:
    """Return what the pieces at rest (n,) of a rate in FS/s say together, None when there is nothing to say.

    The crossings are those of a Gaussian process, sigma of the derivative / sigma / 2 pi (Rice, Bell System Technical
    Journal 24, 1945). Samples that follow one another are not independent: n of them are worth n / (sum of the
    squared autocorrelations) for a variance (Bartlett, Journal of the Royal Statistical Society B 8, 1946).
    """
    pieces = [piece for piece in pieces if len(piece) > 2]
    if not pieces:
        return None
    count = sum(map(len, pieces))
    noise = math.sqrt(float(np.mean(np.concatenate(pieces) ** 2)))
    if noise == 0:
        return Quiet(0.0, 0.0, count / sample_rate, float(count))
    steps = np.concatenate([np.diff(piece) for piece in pieces]) * sample_rate
    crossings = math.sqrt(float(np.mean(steps**2))) / noise / (2.0 * math.pi)
    alike = 1.0
    for lag in range(1, max(2, round(MEMORY * sample_rate))):
        products = [piece[lag:] * piece[:-lag] for piece in pieces if len(piece) > lag]
        alike += 2.0 * (sum(float(one.sum()) for one in products) / count / noise**2) ** 2
    return Quiet(noise, crossings, count / sample_rate, max(1.0, count / alike))


def false_per_minute(quiet: Quiet, dead_zone: float) -> float:
    """Return how often per minute a rate at rest is expected to pass `dead_zone` (FS/s) upwards.

    Rice's formula, crossings exp(-z^2 / 2) with z = dead_zone / noise, averaged over what the noise may really be:
    with n degrees of freedom that is crossings (1 + z^2 / n)^(-n / 2).
    """
    if quiet.noise == 0:
        return 0.0
    z = dead_zone / quiet.noise
    return 60.0 * quiet.crossings * math.exp(-0.5 * quiet.freedom * math.log1p(z * z / quiet.freedom))


def passes(pieces: Sequence[NDArray[np.float64]], dead_zone: float) -> int:
    """Return how often the pieces of a rate pass `dead_zone` upwards; one that begins above it counts, too."""
    above = [np.concatenate(([False], piece > dead_zone)) for piece in pieces]
    return int(sum(np.count_nonzero(~one[:-1] & one[1:]) for one in above))


def at_most_per_minute(counted: int, seconds: float) -> float | None:
    """Return the largest rate per minute under which so few events in `seconds` still happen (95 %).

    Exact for a Poisson process (Garwood, Biometrika 28, 1936); three per time when nothing was counted.
    """
    return None if seconds <= 0 else float(chi2.ppf(SURE, 2 * counted + 2)) / 2.0 * 60.0 / seconds


def at_least_share(hits: int, of: int) -> float:
    """Return the smallest probability under which so many of so few succeed (Clopper and Pearson, one-sided 95 %)."""
    return float(beta.ppf(1.0 - SURE, hits, of - hits + 1)) if hits else 0.0


def hit_probability(peaks: Sequence[float], level: float, others: Sequence[Sequence[float]] = ()) -> float:
    """Return the probability that the next movement's peak reaches `level`.

    Peaks are taken as log-normal, for their noise grows with their size. Their spread is moderated: with few
    repetitions of a gesture, that of the person's `others` counts as much as four more (as Smyth, Statistical
    Applications in Genetics and Molecular Biology 3, 2004, does for genes). All in FS/s.
    """
    logs = np.log(np.maximum(peaks, 1e-3 * level))
    count = len(logs)
    own_freedom = count - 1
    own = float(logs.var(ddof=1)) if own_freedom else 0.0
    variance = (PRIOR_FREEDOM * _usual_variance(others) + own_freedom * own) / (PRIOR_FREEDOM + own_freedom)
    spread = math.sqrt(max(variance, LEAST_SPREAD**2) * (1.0 + 1.0 / count))
    return float(t.sf((math.log(level) - float(logs.mean())) / spread, PRIOR_FREEDOM + own_freedom))


def _usual_variance(others: Sequence[Sequence[float]]) -> float:
    """Return the variance of the logarithm of a peak within the other gestures' repetitions."""
    logs = [np.log(peaks) for peaks in others if len(peaks) > 1 and min(peaks) > 0]
    freedom = sum(len(one) - 1 for one in logs)
    if not freedom:
        return USUAL_SPREAD**2
    return sum(float(((one - one.mean()) ** 2).sum()) for one in logs) / freedom
