"""Two sessions of a person in one task, side by side: the median of each measure with its spread, and the verdict."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from app.quantities import Document
from app.scoring.verdict.measure_comparison import COMPARISONS, from_scale
from app.scoring.verdict.measure_verdict import ClinicSpreads, Rows, Verdict, compare, series_of


class Quartiles(Document):
    """The trials of a session in one measure."""

    median: float
    low: float  # the first quartile
    high: float  # the third quartile
    trials: int


class MeasureOfSessions(Document):
    """One measure in two sessions; a session without a trial that is compared has no summary."""

    earlier: Quartiles | None
    later: Quartiles | None
    verdict: Verdict | None  # None: neither way is better, or a session has nothing to compare


def compare_sessions(rows: Rows, clinic: ClinicSpreads, earlier: int, later: int) -> dict[str, MeasureOfSessions]:
    """Compare the trials of the sessions with these numbers, measure by measure.

    `rows` and `clinic` as for `trial_verdicts`. Trials for getting used to the task are in no
    summary, as in no verdict.
    """
    found = {}
    for name in COMPARISONS:
        series, _ = series_of(rows, name)
        first, second = series.session == earlier, series.session == later
        if first.any() or second.any():
            found[name] = MeasureOfSessions(
                earlier=_summary(name, series.value[first]),
                later=_summary(name, series.value[second]),
                verdict=compare(name, series, first, second, clinic.get(name)),
            )
    return found


def compare_tasks(
    tasks: Sequence[tuple[Rows, ClinicSpreads]], earlier: int, later: int
) -> list[dict[str, MeasureOfSessions]]:
    """Compare the trials of two sessions in each of these tasks: the person's rows in it, and the clinic's spreads."""
    return [compare_sessions(rows, clinic, earlier, later) for rows, clinic in tasks]


def _summary(name: str, values: Any) -> Quartiles | None:
    """Return the quartiles of values on the measure's scale, in the unit of the measure; None where there are none."""
    if not len(values):
        return None
    low, median, high = (from_scale(name, float(one)) for one in np.percentile(values, (25, 50, 75)))
    return Quartiles(median=median, low=low, high=high, trials=len(values))
