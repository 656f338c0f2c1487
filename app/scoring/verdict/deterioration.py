"""Whether a person's sessions have become worse than their learning curve foretells: a cumulative sum (CUSUM)."""

from collections.abc import Collection, Mapping

import numpy as np

from app.scoring.verdict.cusum import LIMIT, next_sum, normal_score
from app.scoring.verdict.measure_comparison import COMPARISONS, least_spread
from app.scoring.verdict.measure_verdict import Rows, series_of
from app.scoring.verdict.spread import Series, Spread, fit_curve, own_spread, pool_spreads, weighted_sum

EARLIER_SESSIONS = 2  # before the first session that is judged
EARLIER_TRIALS = 5

ADVICE = (
    "What to do: check the fit of the shirt and the warnings of control quality, ask about pain, sleep and medication, "
    "and calibrate again. If the next two sessions are as bad, talk to the physician."
)


def worse_since(series: Series, clinic: Spread | None, better: str, least: float = 0.0) -> list[int | None]:
    """Return, for each session, the first session of a deterioration that goes on in it; None when there is none.

    Each session's mean is compared with the end of the learning curve of the sessions before. The difference is divided
    by its standard deviation, as Student's t, and expressed as a standard normal one. These are added up (Page,
    Biometrika 41 (1954); self-starting: Hawkins, The Statistician 36 (1987)). From the session in which the sum passes
    the limit until it is 0 again, the sessions that made it rise do not count for the learning curve: a lasting
    deterioration does not become the person's normal level.
    """
    total, since, is_worse = 0.0, None, False
    found: list[int | None] = []
    for session in np.unique(series.session).tolist():
        before = series.where(series.session < (since if is_worse and since is not None else session))
        worse = _surprise(before, series.where(series.session == session), clinic, least)
        if worse is not None:
            worse = worse if better == "low" else -worse
            total = next_sum(total, worse, most=2 * LIMIT)
            since = None if total == 0.0 else since or session
            is_worse = total > LIMIT or (is_worse and total > 0.0)
        found.append(since if is_worse else None)
    return found


def _surprise(before: Series, session: Series, clinic: Spread | None, least: float) -> float | None:
    """Return how far a session lies above what was foretold, in standard deviations; None with too few trials."""
    earlier = len(np.unique(before.session))
    if earlier < EARLIER_SESSIONS or len(before.value) < EARLIER_TRIALS:
        return None
    own, share = own_spread(before, session, least)
    spread = pool_spreads(own, share, clinic)
    foretold, parameters = fit_curve(before.number, before.value, before.number[-1:])
    total = weighted_sum(
        (1 / len(session.value) + parameters / len(before.value), spread.trial),
        (1 + parameters / earlier, spread.session),
    )
    return normal_score(float(session.value.mean() - foretold[0]), total)


def deteriorations(rows: Rows, clinic: Mapping[str, Spread], names: Collection[str] = COMPARISONS) -> dict[str, str]:
    """Return, for each measure of `names` that has become worse, a sentence that says since when, and what to do.

    `rows` are a person's trials in one task, `clinic` the median spread of each measure.
    """
    found = {}
    for name, measure in COMPARISONS.items():
        if name not in names or measure.better is None:
            continue
        series, _ = series_of(rows, name)
        if not len(series.value):
            continue
        *_, since = worse_since(series, clinic.get(name), measure.better, least_spread(name, series.value))
        if since is not None:
            found[name] = f"Worse than this person's own noise since session {since}. {ADVICE}"
    return found
