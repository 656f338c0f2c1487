"""The verdict on a difference between two sets of trials: better than noise, within noise, or worse."""

import math
from collections.abc import Mapping, Sequence
from typing import Any, Final, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.quantities import Document
from app.scoring.verdict.measure_comparison import COMPARISONS, from_scale, least_spread, to_scale, value_of
from app.scoring.verdict.spread import (
    PersonVariances,
    Series,
    Spread,
    median_spread,
    own_spread,
    person_variances,
    pool_spreads,
    weighted_sum,
)

FEWEST = 5  # trials up to and with the later ones
LEAST_DF = 2.0  # degrees of freedom that a spread needs; without a clinic's median, one session has none
CONFIDENCE = 0.95

Word = Literal["better", "within", "worse", "too few"]
VERDICT_WORDS: Final[dict[Word, str]] = {
    "better": "better than noise",
    "within": "within noise",
    "worse": "worse than noise",
    "too few": "too few trials",
}
Rows = Sequence[Mapping[str, Any]]
ClinicSpreads = Mapping[str, Spread]
PeopleVariances = dict[str, dict[int, PersonVariances]]


class Verdict(Document):
    """The verdict on one measure, with what it comes from; numbers in the unit of the measure."""

    word: Word  # better than noise, within noise, worse than noise, too few trials
    earlier: float | None  # mean of the earlier trials, on the measure's scale and back
    later: float | None
    low: float | None  # from here to `high`, a later mean is within noise; None: too few trials
    high: float | None
    trials: int  # up to and with the later ones that were compared


class Noise(NamedTuple):
    """The smallest difference that is not noise, on the measure's scale."""

    mdc: float
    df: float  # degrees of freedom of the variance behind it


def noise_of(spread: Spread, earlier: int, later: int, *, same_session: bool) -> Noise | None:
    """Return the minimal detectable change (95 %) between means of `earlier` and of `later` trials.

    It is t sqrt(2 s_session^2 + s_trial^2 (1 / earlier + 1 / later)), without the first term within one session. t is
    the quantile of Student's t at the degrees of freedom of the sum. None where these are fewer than 2.
    """
    from scipy.special import stdtrit

    parts = [(1 / earlier + 1 / later, spread.trial)]
    if not same_session:
        parts.append((2.0, spread.session))
    total = weighted_sum(*parts)
    if total.df < LEAST_DF:
        return None
    return Noise(float(stdtrit(total.df, (1 + CONFIDENCE) / 2)) * math.sqrt(total.value), total.df)


def series_of(rows: Rows, name: str) -> tuple[Series, NDArray[np.int64]]:
    """Return one measure of the trials that are compared, on its scale, and the trials' ids.

    `rows` are in the order driven; each has `id`, `number`, `session`, `familiarisation` and its measures by name.
    Trials for getting used to the task are left out.
    """
    compared = [(row, value_of(row, name)) for row in rows if not row["familiarisation"]]
    found = [(row, value) for row, value in compared if value is not None]
    value = np.array([value for _, value in found], dtype=np.float64)
    series = Series(
        np.array([row["number"] for row, _ in found], dtype=np.float64),
        np.array([row["session"] for row, _ in found], dtype=np.int64),
        to_scale(name, value),
    )
    return series, np.array([row["id"] for row, _ in found], dtype=np.int64)


def compare(
    name: str, series: Series, earlier: NDArray[np.bool_], later: NDArray[np.bool_], clinic: Spread | None
) -> Verdict | None:
    """Compare two sets of a person's trials in one measure; None where a set is empty or neither way is better.

    Parameters
    ----------
    name
        The measure.
    series
        All trials of the person in this task, in the order driven. What was driven after the later set is not used, so
        that a verdict stays what it was on its day.
    earlier, later
        (n,) the trials of the two sets; each set is of one session, and `later` after `earlier`.
    clinic
        The clinic's median spread in this task.
    """
    direction = COMPARISONS[name].better
    if direction is None or not earlier.any() or not later.any():
        return None
    before = np.arange(len(later)) < np.flatnonzero(later)[0]
    first, second = series.where(earlier), series.where(later)
    then, now = float(first.value.mean()), float(second.value.mean())
    count = int((before | later).sum())
    figures = {"earlier": from_scale(name, then), "later": from_scale(name, now), "trials": count}
    noise = None
    if count >= FEWEST:
        own, share = own_spread(series.where(before), second, least_spread(name, series.value[before | later]))
        spread = pool_spreads(own, share, clinic)
        same = first.session[0] == second.session[0]
        noise = noise_of(spread, len(first.value), len(second.value), same_session=bool(same))
    if noise is None:
        return Verdict(word="too few", low=None, high=None, **figures)
    low, high = from_scale(name, then - noise.mdc), from_scale(name, then + noise.mdc)
    return Verdict(word=verdict_word(now - then, noise.mdc, direction), low=low, high=high, **figures)


def verdict_word(change: float, mdc: float, better: Literal["low", "high"]) -> Word:
    """Return the word for a change beside the smallest one that is not noise, both on the measure's scale."""
    if abs(change) <= mdc:
        return "within"
    return "better" if (change < 0) == (better == "low") else "worse"


def people_variances(people: Mapping[int, Rows]) -> PeopleVariances:
    """Return the variances of each person in one task: {measure: {id of the person: variances}}.

    `people` are the rows of each person, as for `series_of`; who has too few trials is left out.
    """
    found: PeopleVariances = {}
    for name in COMPARISONS:
        series = {person: one for person, rows in people.items() if len((one := series_of(rows, name)[0]).value)}
        if not series:
            continue
        least = least_spread(name, np.concatenate([one.value for one in series.values()]))
        variances = {person: person_variances(one, least) for person, one in series.items()}
        found[name] = {person: one for person, one in variances.items() if one is not None}
    return found


def clinic_spreads(variances: PeopleVariances, person: int | None = None) -> dict[str, Spread]:
    """Return the median spread of everybody but `person`, for each measure that enough people have."""
    medians = {
        name: median_spread([one for other, one in people.items() if other != person])
        for name, people in variances.items()
    }
    return {name: spread for name, spread in medians.items() if spread is not None}
