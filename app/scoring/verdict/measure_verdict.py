"""The verdict on a difference between two sets of trials: better than noise, within noise, or worse."""

import math
from collections.abc import Mapping, Sequence
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.quantities import Document
from app.scoring.measures import TRIAL_MEASURES, Word
from app.scoring.verdict.detectable_change import LEVEL_OF_TRIALS, detectable_change, variance_of
from app.scoring.verdict.measure_scales import (
    Rows,
    from_scale,
    least_spread,
    measure_of,
    measured_in,
    to_scale,
    value_of,
    with_missed,
)
from app.scoring.verdict.spread import (
    PersonVariances,
    Series,
    Spread,
    Variance,
    median_spread,
    own_spread,
    person_variances,
    pool_spreads,
)

FEWEST = 5  # trials up to and with the later ones

ClinicSpreads = Mapping[str, Spread]
PeopleVariances = dict[str, dict[int, PersonVariances]]


class Verdict(Document):
    """The verdict on one measure, with what it comes from; numbers in the unit of the measure."""

    word: Word  # better than noise, within noise, worse than noise, too few trials; number: does not lead, no word
    earlier: float | None  # mean of the earlier trials, on the measure's scale and back
    later: float | None
    low: float | None  # from here to `high`, a later mean is within noise; None: too few trials, or no word
    high: float | None
    trials: int  # up to and with the later ones that were compared


class Difference(NamedTuple):
    """The difference between two sets of a person's trials in one measure, on its scale."""

    earlier: float  # mean
    later: float
    trials: int  # up to and with the later ones that were compared
    variance: Variance | None  # of the difference without a change; None: too few trials

    @property
    def p_value(self) -> float | None:
        """The two-sided probability of such a difference without a change; None with too few trials."""
        from scipy.special import stdtr

        if self.variance is None:
            return None
        ratio = abs(self.later - self.earlier) / math.sqrt(max(self.variance.value, 1e-300))
        return float(2 * stdtr(self.variance.df, -ratio))


def series_of(rows: Rows, name: str) -> tuple[Series, NDArray[np.int64]]:
    """Return one measure of the trials that are compared, on its scale, and the trials' ids.

    `rows` are in the order driven; each has `id`, `number`, `session`, `familiarisation` and its measures by name.
    Trials for getting used to the task are left out. A trial that missed the goal is in a measure of the whole task
    with a bound (`with_missed`), and left out before the first trial that reached it.
    """
    needs_goal = TRIAL_MEASURES[name].needs_goal
    compared = [(row, value_of(row, name)) for row in rows if not row["familiarisation"]]
    is_missed = [needs_goal and not row.get("reached", True) for row, _ in compared]
    is_compared = [value is not None or missed for (_, value), missed in zip(compared, is_missed, strict=True)]
    compared_rows = [row for (row, _), included in zip(compared, is_compared, strict=True) if included]
    value = np.array([0.0 if value is None else value for _, value in compared], dtype=np.float64)[is_compared]
    scaled = with_missed(name, to_scale(name, value), np.array(is_missed, dtype=np.bool_)[is_compared])
    series = Series(
        np.array([row["number"] for row in compared_rows], dtype=np.float64),
        np.array([row["session"] for row in compared_rows], dtype=np.int64),
        scaled,
    )
    is_known = np.isfinite(scaled)
    return series.where(is_known), np.array([row["id"] for row in compared_rows], dtype=np.int64)[is_known]


def difference_of(
    name: str, series: Series, earlier: NDArray[np.bool_], later: NDArray[np.bool_], clinic: Spread | None
) -> Difference | None:
    """Return the difference between two sets of a person's trials; None where a set is empty or neither way is better.

    Parameters
    ----------
    name
        The measure.
    series
        All trials of the person in this task, in the order driven. What was driven after the later set is not used, so
        that a verdict stays what it was on its day.
    earlier, later
        (n,) the trials of the two sets, each of one session or of several, `later` after `earlier`.
    clinic
        The clinic's median spread in this task.
    """
    if TRIAL_MEASURES[name].better is None or not earlier.any() or not later.any():
        return None
    before = np.arange(len(later)) < np.flatnonzero(later)[0]
    first, second = series.where(earlier), series.where(later)
    count = int((before | later).sum())
    variance = None
    if count >= FEWEST:
        own_variances = own_spread(series.where(before), second, least_spread(name, series.value[before | later]))
        spread = pool_spreads(own_variances, clinic)
        sets = [np.unique(trials_of_set.session) for trials_of_set in (first, second)]
        same = len(sets[0]) == len(sets[1]) == 1 and sets[0][0] == sets[1][0]
        trials, sessions = (len(first.value), len(second.value)), (len(sets[0]), len(sets[1]))
        variance = variance_of(spread, trials, None if same else sessions)
    return Difference(float(first.value.mean()), float(second.value.mean()), count, variance)


def holm_levels(p_values: Sequence[float], together: float) -> list[float]:
    """Return the level that each of several tests is held against, so that all err with probability `together` at most.

    The smallest of m p-values is held against together / m, the next one against together / (m - 1), until one is above
    its level: that level holds for the remaining ones. Source: Holm, Scandinavian Journal of Statistics 6 (1979).
    """
    levels = [0.0] * len(p_values)
    level, passed = 0.0, True
    for rank, place in enumerate(sorted(range(len(p_values)), key=lambda test: p_values[test])):
        if passed:
            level = together / (len(p_values) - rank)
            passed = p_values[place] <= level
        levels[place] = level
    return levels


def verdicts_on(
    differences: Mapping[str, Difference],
    leading: Sequence[str],
    others: Mapping[str, float] | None = None,
    together: float = LEVEL_OF_TRIALS,
) -> tuple[dict[str, Verdict], dict[str, float]]:
    """Return the verdicts on differences, and the levels of `others`, p-values that are judged together with them.

    The measures of `leading` have a word, and one of them is wrong with probability `together` at most; the remaining
    ones are numbers only.
    """
    p_values = {name: differences[name].p_value for name in leading if name in differences}
    tests = {name: p_value for name, p_value in p_values.items() if p_value is not None} | dict(others or {})
    levels = dict(zip(tests, holm_levels(list(tests.values()), together), strict=True))
    verdicts = {
        name: _verdict(name, difference, levels.get(name), name in leading) for name, difference in differences.items()
    }
    return verdicts, levels


def _verdict(name: str, difference: Difference, level: float | None, is_leading: bool) -> Verdict:
    figures = {"earlier": from_scale(name, difference.earlier), "later": from_scale(name, difference.later)}
    if level is None or difference.variance is None:
        word: Word = "too few" if is_leading else "number"
        return Verdict(word=word, low=None, high=None, trials=difference.trials, **figures)
    direction = measure_of(name).better
    assert direction is not None
    mdc = detectable_change(difference.variance, level)
    low, high = from_scale(name, difference.earlier - mdc), from_scale(name, difference.earlier + mdc)
    word = verdict_word(difference.later - difference.earlier, mdc, direction)
    return Verdict(word=word, low=low, high=high, trials=difference.trials, **figures)


def compare(
    name: str, series: Series, earlier: NDArray[np.bool_], later: NDArray[np.bool_], clinic: Spread | None
) -> Verdict | None:
    """Compare two sets of a person's trials in one measure alone; parameters as for `difference_of`."""
    difference = difference_of(name, series, earlier, later, clinic)
    return None if difference is None else verdicts_on({name: difference}, [name])[0][name]


def verdict_word(change: float, mdc: float, better: Literal["low", "high"]) -> Word:
    """Return the word for a change beside the smallest one that is not noise, both on the measure's scale."""
    if abs(change) <= mdc:
        return "within"
    return "better" if (change < 0) == (better == "low") else "worse"


def people_variances(people: Mapping[int, Rows]) -> PeopleVariances:
    """Return the variances of each person in one task: {measure: {id of the person: variances}}.

    `people` are the rows of each person, as for `series_of`; who has too few trials is left out.
    """
    by_measure: PeopleVariances = {}
    measured = {person: measured_in(rows) for person, rows in people.items()}
    for name in TRIAL_MEASURES:
        series = {person: series_of(people[person], name)[0] for person, names in measured.items() if name in names}
        series = {person: trials for person, trials in series.items() if len(trials.value)}
        if not series:
            continue
        least = least_spread(name, np.concatenate([trials.value for trials in series.values()]))
        variances = {person: person_variances(trials, least) for person, trials in series.items()}
        by_measure[name] = {person: variance for person, variance in variances.items() if variance is not None}
    return by_measure


def clinic_spreads(variances: PeopleVariances, person: int | None = None) -> dict[str, Spread]:
    """Return the median spread of everybody but `person`, for each measure that enough people have."""
    medians = {
        name: median_spread([variance for other, variance in people.items() if other != person])
        for name, people in variances.items()
    }
    return {name: spread for name, spread in medians.items() if spread is not None}
