"""Whether a person reaches the goal as often as before: a share of trials, with a verdict of its own."""

import math
from typing import Final, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.scoring.measures import REACHED, Word
from app.scoring.verdict.measure_scales import Rows
from app.scoring.verdict.measure_verdict import FEWEST, Verdict

USUAL_DISPERSION: Final = 1.5  # variance of a session's count over the binomial one, where nothing is known of a person
USUAL_WEIGHT: Final = 4.0  # sessions that this counts for
LEAST_EXCESS: Final = 1.001  # of the variance of a count over the binomial one
MOST_EXCESS: Final = 0.999  # of the same, as a share of the number of trials


class Counts(NamedTuple):
    """In how many trials of each session the goal was reached."""

    session: NDArray[np.int64]  # (m,) rising
    trials: NDArray[np.int64]  # (m,)
    reached: NDArray[np.int64]  # (m,)

    def where(self, chosen: NDArray[np.bool_]) -> "Counts":
        """Return the chosen sessions (m,)."""
        return Counts(self.session[chosen], self.trials[chosen], self.reached[chosen])

    @property
    def rate(self) -> float:
        """The estimated probability of reaching the goal; half a trial of each kind is added (Jeffreys' prior)."""
        return (float(self.reached.sum()) + 0.5) / (float(self.trials.sum()) + 1.0)

    @property
    def dispersion(self) -> float:
        """Pearson's chi-squared over its degrees of freedom, drawn towards the usual one, at least 1.

        Good and bad days make the goal be missed together: the counts of sessions differ by more than binomial ones.
        """
        expected = self.trials * self.rate
        chi_squared = float((((self.reached - expected) ** 2) / (expected * (1 - self.rate))).sum())
        df = max(len(self.trials) - 1, 0)
        return max(1.0, (chi_squared + USUAL_WEIGHT * USUAL_DISPERSION) / (df + USUAL_WEIGHT))


def counts_of(rows: Rows) -> Counts:
    """Return the counts of each session, without the trials for getting used to the task."""
    compared = [row for row in rows if not row["familiarisation"]]
    session, place = np.unique(np.array([row["session"] for row in compared], dtype=np.int64), return_inverse=True)
    reached = np.array([bool(row.get("reached", True)) for row in compared], dtype=np.float64)
    size = len(session)
    return Counts(
        session,
        np.bincount(place, minlength=size).astype(np.int64),
        np.bincount(place, reached, minlength=size).astype(np.int64),
    )


class ReachingDifference(NamedTuple):
    """How often the goal was reached in two sessions."""

    earlier: float  # share of the trials
    later: float
    trials: int  # up to and with the later session
    p_value: float | None  # two-sided, of such a difference without a change; None: too few trials


def reaching_difference(counts: Counts, earlier: int, later: int) -> ReachingDifference:
    """Return the difference between two sessions of `counts`, which both have trials.

    Its p-value is the larger one of Fisher's exact test (The Design of Experiments (1935)) and of a test that allows
    for the dispersion between the sessions before the later one: the difference of the shares over
    sqrt(dispersion r (1 - r) (1 / n1 + 1 / n2)), as a standard normal score, with the rate r of the two sessions.
    """
    from scipy.special import ndtr
    from scipy.stats import fisher_exact

    upto = counts.where(counts.session <= later)
    pair = upto.where(np.isin(upto.session, (earlier, later)))
    shares = pair.reached / pair.trials
    trials = int(upto.trials.sum())
    if trials < FEWEST:
        return ReachingDifference(float(shares[0]), float(shares[1]), trials, None)
    dispersion = upto.where(upto.session != later).dispersion
    score = abs(shares[1] - shares[0]) / math.sqrt(dispersion * pair.rate * (1 - pair.rate) * (1 / pair.trials).sum())
    exact = fisher_exact([pair.reached, pair.trials - pair.reached]).pvalue
    return ReachingDifference(float(shares[0]), float(shares[1]), trials, max(float(exact), float(2 * ndtr(-score))))


def family_of(difference: ReachingDifference) -> dict[str, float]:
    """Return the p-value that is judged together with those of the measures.

    It is left out where the goal was reached always or never in both sessions: then no verdict is possible, and the
    other tests need not allow for it. Source: Tarone, Biometrics 46 (1990).
    """
    if difference.p_value is None or difference.earlier == difference.later in (0.0, 1.0):
        return {}
    return {REACHED: difference.p_value}


def reaching_verdict(difference: ReachingDifference, level: float | None) -> Verdict:
    """Return the verdict on how often the goal was reached, at this level; None: no difference is possible."""
    word: Word = "too few" if difference.p_value is None else "within"
    if level is not None and difference.p_value is not None and difference.p_value <= level:
        word = "better" if difference.later > difference.earlier else "worse"
    return Verdict(
        word=word, earlier=difference.earlier, later=difference.later, low=None, high=None, trials=difference.trials
    )


def fewer_than_foretold(before: Counts, trials: int, reached: int) -> float:
    """Return how far a count of at least two trials lies below what those before foretell, as a standard normal score.

    The count is beta-binomial: its mean is `trials` times the person's rate r, its variance
    trials r (1 - r) (dispersion (1 + trials / N)) with N earlier trials, so that it has the dispersion between sessions
    and the error of the rate. The score is that of the probability of fewer, and half of that of as many (mid-p:
    Lancaster, Journal of the American Statistical Association 56 (1961)).
    """
    from scipy.special import betaln, gammaln, ndtri

    rate = before.rate
    excess = before.dispersion * (1 + trials / float(before.trials.sum()))
    excess = min(max(excess, LEAST_EXCESS), trials * MOST_EXCESS)
    both = (trials - excess) / (excess - 1)  # a + b of the beta distribution with this excess over the binomial
    a, b = both * rate, both * (1 - rate)
    count = np.arange(reached + 1)
    choices = gammaln(trials + 1) - gammaln(count + 1) - gammaln(trials - count + 1)
    chances = np.exp(choices + betaln(count + a, trials - count + b) - betaln(a, b))
    return float(-ndtri(min(float(chances.sum()) - float(chances[-1]) / 2, 1.0)))
