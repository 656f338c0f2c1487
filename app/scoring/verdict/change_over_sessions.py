"""Whether a measure has changed over all of a person's sessions: the last third of them against the first third."""

import math
from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from app.scoring.verdict.leading_measures import MOST_LEADING
from app.scoring.verdict.measure_comparison import COMPARISONS, Rows, least_spread
from app.scoring.verdict.measure_verdict import (
    FEWEST,
    ClinicSpreads,
    Difference,
    Word,
    series_of,
    variance_of,
)
from app.scoring.verdict.spread import Series, Spread, Variance, course_spread, pool_spreads

LEVEL: Final = 0.02 / MOST_LEADING  # of each of the three measures that lead (Bonferroni)
INFLATION: Final = 3.0  # (1 + r) / (1 - r) of the variance of a mean, with r = 0.5 between successive trials
PARTS: Final = 3


def course_difference(name: str, series: Series, clinic: Spread | None) -> Difference | None:
    """Return the difference between the last and the first third of the sessions; None without trials.

    Successive trials resemble each other, so trials are not counted as independent: sessions are. Within one session
    the last and the first third of its trials are compared, with a variance for trials that are correlated by 0.5.
    Source: Bayley and Hammersley, Supplement to the Journal of the Royal Statistical Society 8 (1946).
    """
    sessions = np.unique(series.session)
    unit = series.session if len(sessions) > 1 else np.arange(len(series.value))
    units = np.unique(unit)
    count = math.ceil(len(units) / PARTS)
    if len(units) < 2:
        return None
    earlier, later = unit <= units[count - 1], unit >= units[-count]
    driven = len(series.value)
    first, second = series.where(earlier), series.where(later)
    variance = None
    if driven >= FEWEST:
        spread = pool_spreads(*course_spread(series, least_spread(name, series.value)), clinic)
        trials, part = (len(first.value), len(second.value)), (count, count)
        if len(sessions) > 1:
            variance = variance_of(spread, trials, part)
        elif (within := variance_of(spread, trials, None)) is not None:
            variance = Variance(INFLATION * within.value, within.df)
    return Difference(float(first.value.mean()), float(second.value.mean()), driven, variance)


class CourseChange(NamedTuple):
    """What became of a measure over all sessions."""

    word: Word
    falls: bool  # from the first third to the last; without a meaning where the word is neither better nor worse
    p_value: float | None


def course_change(name: str, rows: Rows, leading: Sequence[str], clinic: ClinicSpreads) -> CourseChange:
    """Return whether a measure has changed over these trials; only of a leading measure there is a word.

    `rows` and `clinic` as for `series_of` and `difference_of`.
    """
    if name not in leading:
        return CourseChange("number", False, None)
    found = course_difference(name, series_of(rows, name)[0], clinic.get(name))
    if found is None or found.p_value is None:
        return CourseChange("too few", False, None)
    falls = found.later < found.earlier
    word: Word = "within"
    if found.p_value <= LEVEL:
        word = "better" if falls == (COMPARISONS[name].better == "low") else "worse"
    return CourseChange(word, falls, found.p_value)
