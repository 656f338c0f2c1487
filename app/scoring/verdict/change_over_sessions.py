"""Whether a measure has changed over all of a person's sessions, slowly or in the newest of them."""

import math
from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from app.scoring.measures import TRIAL_MEASURES, Word
from app.scoring.verdict.detectable_change import LEVEL_OF_COURSE, variance_of
from app.scoring.verdict.measure_scales import Rows, least_spread
from app.scoring.verdict.measure_verdict import (
    FEWEST,
    ClinicSpreads,
    Difference,
    difference_of,
    series_of,
)
from app.scoring.verdict.spread import Series, Sessions, Spread, Variance, course_spread, pool_spreads

TESTS: Final = 2  # of each measure
INFLATION: Final = 3.0  # (1 + r) / (1 - r) of the variance of a mean, with r = 0.5 between successive trials
PARTS: Final = 3


def course_differences(name: str, series: Series, clinic: Spread | None) -> list[Difference]:
    """Return how a measure differs between parts of its course; nothing without two trials.

    The last third of the sessions against the first third finds a lasting change, the newest session against all before
    it a new one. Within one session the last and the first third of its trials are compared.
    """
    sessions = np.unique(series.session)
    if len(sessions) > 1:
        differences: list[Difference | None] = [_thirds(name, series, series.session, clinic)]
        if len(sessions) > 2:
            newest = series.session == sessions[-1]
            differences.append(difference_of(name, series, ~newest, newest, clinic))
        return [difference for difference in differences if difference is not None]
    return [_thirds(name, series, np.arange(len(series.value)), clinic)] if len(series.value) > 1 else []


def _thirds(name: str, series: Series, unit: Sessions, clinic: Spread | None) -> Difference:
    """Return the difference between the last and the first third of the units (n,): sessions, or trials of one session.

    Successive trials resemble each other, so within one session their variance assumes a correlation of 0.5.
    Source: Bayley and Hammersley, Supplement to the Journal of the Royal Statistical Society 8 (1946).
    """
    units = np.unique(unit)
    count = math.ceil(len(units) / PARTS)
    first, second = series.where(unit <= units[count - 1]), series.where(unit >= units[-count])
    count_of_trials, variance = len(series.value), None
    if count_of_trials >= FEWEST:
        spread = pool_spreads(course_spread(series, least_spread(name, series.value)), clinic)
        trials = len(first.value), len(second.value)
        if unit is series.session:
            variance = variance_of(spread, trials, (count, count))
        elif (within := variance_of(spread, trials, None)) is not None:
            variance = Variance(INFLATION * within.value, within.df)
    return Difference(float(first.value.mean()), float(second.value.mean()), count_of_trials, variance)


class CourseChange(NamedTuple):
    """What became of a measure over all sessions."""

    word: Word
    falls: bool  # in the difference that is clearest; without a meaning where the word is neither better nor worse
    p_value: float | None  # of that difference, doubled for two tests (Bonferroni)
    level: float = 0.0  # a change has a smaller p-value
    sessions: int = 0  # of the trials that were compared


def course_change(name: str, rows: Rows, leading: Sequence[str], clinic: ClinicSpreads) -> CourseChange:
    """Return whether a measure has changed over these trials; only of a leading measure there is a word.

    `rows` and `clinic` as for `series_of` and `difference_of`.
    """
    if name not in leading:
        return CourseChange("number", False, None)
    series = series_of(rows, name)[0]
    differences = course_differences(name, series, clinic.get(name))
    p_values = [
        (difference.p_value, difference.later < difference.earlier)
        for difference in differences
        if difference.p_value is not None
    ]
    if not p_values:
        return CourseChange("too few", False, None)
    smallest, falls = min(p_values)
    p_value, level = min(TESTS * smallest, 1.0), LEVEL_OF_COURSE / len(leading)
    word: Word = "within"
    if p_value <= level:
        word = "better" if falls == (TRIAL_MEASURES[name].better == "low") else "worse"
    return CourseChange(word, falls, p_value, level, len(np.unique(series.session)))
