"""The minimal detectable change (MDC), the smallest difference between two means that is not noise, and its levels."""

import math
from typing import Final, NamedTuple

from app.scoring.verdict.spread import OwnSpread, Variance

# How probable one wrong word is for a person who does not change, over all words that are judged together. A page has
# two comparisons of sessions, the newest with the one before and with the first, and a sentence on all sessions:
# together 5 %. It has two such comparisons of two-minute tests.
LEVEL_OF_TRIALS: Final = 0.05  # of all words on two trials
LEVEL_OF_SESSIONS: Final = 0.015  # of all words on two sessions
LEVEL_OF_COURSE: Final = 0.04  # of the sentence, for all leading measures together (docs/learning/verdicts.md)
LEVEL_OF_TESTS: Final = 0.025  # of all words on two two-minute tests
LEAST_DF = 2.0  # degrees of freedom that a spread needs; without a clinic's median, one session has none


class Noise(NamedTuple):
    """The smallest difference that is not noise, on the measure's scale."""

    mdc: float
    df: float  # degrees of freedom of the variance behind it


def variance_of(spread: OwnSpread, trials: tuple[int, int], sessions: tuple[int, int] | None) -> Variance | None:
    """Return the variance of the difference between the means of two sets of trials; None with few degrees of freedom.

    `sessions` is None where both sets are of one session.
    """
    between = 0.0 if sessions is None else 1 / sessions[0] + 1 / sessions[1]
    total = spread.of_difference(between, 1 / trials[0] + 1 / trials[1])
    return None if total.df < LEAST_DF else total


def noise_of(spread: OwnSpread, earlier: int, later: int, *, same_session: bool) -> Noise | None:
    """Return the minimal detectable change (95 %) between means of `earlier` and of `later` trials of a session each.

    It is t sqrt(2 s_session^2 + s_trial^2 (1 / earlier + 1 / later)), without the first term within one session. t is
    the quantile of Student's t at the degrees of freedom of the sum. None where these are fewer than 2.
    """
    total = variance_of(spread, (earlier, later), None if same_session else (1, 1))
    return None if total is None else Noise(detectable_change(total, LEVEL_OF_TRIALS), total.df)


def detectable_change(variance: Variance, level: float) -> float:
    """Return the difference that noise of this variance exceeds with probability `level`."""
    from scipy.special import stdtrit

    return float(stdtrit(variance.df, 1 - level / 2)) * math.sqrt(variance.value)
