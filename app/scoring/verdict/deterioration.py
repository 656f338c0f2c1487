"""Whether a person's sessions have become worse than their learning curve foretells."""

import math
from collections.abc import Callable, Collection, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from app.scoring.measures import REACHED, TRIAL_MEASURES
from app.scoring.verdict.cusum import normal_score
from app.scoring.verdict.leading_measures import leading_of_task
from app.scoring.verdict.measure_scales import Rows, least_spread
from app.scoring.verdict.measure_verdict import series_of
from app.scoring.verdict.reaching import Counts, counts_of, fewer_than_foretold
from app.scoring.verdict.spread import Series, Spread, fit_curve, own_spread, pool_spreads
from app.texts import Text

EARLIER_SESSIONS = 2  # before the sessions that are judged
EARLIER_TRIALS = 5
LATER_SESSIONS = 2  # that are judged together at least: one bad day is no deterioration
# Standard deviations; chosen so that in three measures and in reaching together at most 8 % of steady people are called
# worse at any time within twenty sessions (docs/learning/verdicts.md).
LIMIT = 3.5
LIMIT_OF_REACHING = 3.6  # the dispersion of a person's counts is known less well than the spread of their measures


class Score(NamedTuple):
    """How much worse the sessions from one on are than those before."""

    normal: float  # a standard normal score
    fit: float  # as large as a change there fits best, whatever the spread that was estimated before it


def worse_since(series: Series, clinic: Spread | None, better: str, least: float = 0.0) -> int | None:
    """Return the session since which a measure is worse, up to the newest session; None: it is not.

    For every session from which on it may have become worse, the mean of the sessions from there is compared with the
    end of the learning curve of the sessions before. The difference is divided by its standard deviation, as Student's
    t, and expressed as a standard normal score. The largest score counts.
    """
    sign = 1.0 if better == "low" else -1.0

    def score(first: int) -> Score | None:
        before, later = series.where(series.session < first), series.where(series.session >= first)
        if len(before.value) < EARLIER_TRIALS:
            return None
        return _score(before, later, clinic, least, sign)

    return _since(np.unique(series.session).tolist(), score, LIMIT)


def missed_since(counts: Counts) -> int | None:
    """Return the same for how often the goal was reached, from the counts of sessions."""

    def score(first: int) -> Score | None:
        before, later = counts.where(counts.session < first), counts.where(counts.session >= first)
        if before.trials.sum() < EARLIER_TRIALS:
            return None
        fewer = fewer_than_foretold(before, int(later.trials.sum()), int(later.reached.sum()))
        return Score(fewer, fewer)

    return _since(counts.session.tolist(), score, LIMIT_OF_REACHING)


def _since(sessions: Sequence[int], score: Callable[[int], Score | None], limit: float) -> int | None:
    """Return the session with the best fit of "worse since then", when the largest score passes `limit`.

    That is the generalised likelihood ratio of a change at an unknown time (Siegmund and Venkatraman, The Annals of
    Statistics 23 (1995)).
    """
    all_scores = {first: score(first) for first in sessions[EARLIER_SESSIONS : len(sessions) - LATER_SESSIONS + 1]}
    scores = {first: session_score for first, session_score in all_scores.items() if session_score is not None}
    if max((session_score.normal for session_score in scores.values()), default=0.0) <= limit:
        return None
    return max(scores, key=lambda first: scores[first].fit)


def _score(before: Series, later: Series, clinic: Spread | None, least: float, sign: float) -> Score | None:
    """Return how far the mean of `later` lies above the end of the curve of `before`; below it with a sign of -1."""
    spread = pool_spreads(own_spread(before, later, least), clinic)
    foretold, parameters = fit_curve(before.number, before.value, before.number[-1:])
    earlier_sessions, later_sessions = (len(np.unique(series.session)) for series in (before, later))
    total = spread.of_difference(
        1 / later_sessions + parameters / earlier_sessions, 1 / len(later.value) + parameters / len(before.value)
    )
    difference = sign * float(later.value.mean() - foretold[0])
    normal = normal_score(difference, total)
    return None if normal is None else Score(normal, difference / math.sqrt(1 / earlier_sessions + 1 / later_sessions))


def deteriorations(
    rows: Rows, clinic: Mapping[str, Spread], names: Collection[str] = TRIAL_MEASURES
) -> dict[str, Text]:
    """Return, for each measure of `names` that has become worse, a sentence that says since when, and what to do.

    `rows` are a person's trials in one task, `clinic` the median spread of each measure.
    """
    starts: dict[str, int | None] = {}
    for name in leading_of_task(rows):
        better = TRIAL_MEASURES[name].better
        series, _ = series_of(rows, name)
        if name in names and better is not None and len(series.value):
            starts[name] = worse_since(series, clinic.get(name), better, least_spread(name, series.value))
    counts = counts_of(rows)
    starts[REACHED] = missed_since(counts)
    return {
        name: Text("verdict-goal-missed" if name == REACHED else "verdict-worse", session=since)
        for name, since in starts.items()
        if since is not None
    }
