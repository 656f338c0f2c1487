"""Two sessions of a person in one task, side by side: the median of each measure with its spread, and the verdict."""

from collections.abc import Sequence

import numpy as np

from app.quantities import Document
from app.scoring.measures import REACHED, TRIAL_MEASURES
from app.scoring.verdict.measure_scales import Rows, from_scale, to_scale, value_of
from app.scoring.verdict.measure_verdict import ClinicSpreads, Verdict, series_of
from app.scoring.verdict.verdicts import session_verdicts


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
    all_series = {name: series_of(rows, name)[0] for name in TRIAL_MEASURES}
    with_trials = {row["session"] for row in rows if not row["familiarisation"]}
    verdicts = session_verdicts(rows, all_series, clinic, earlier, later) if {earlier, later} <= with_trials else {}
    comparison = {}
    for name in TRIAL_MEASURES:
        first, second = (_summary(name, rows, session) for session in (earlier, later))
        if first is not None or second is not None or name in verdicts:
            comparison[name] = MeasureOfSessions(earlier=first, later=second, verdict=verdicts.get(name))
    if REACHED in verdicts:
        comparison = {REACHED: MeasureOfSessions(earlier=None, later=None, verdict=verdicts[REACHED])} | comparison
    return comparison


def compare_tasks(
    tasks: Sequence[tuple[Rows, ClinicSpreads]], earlier: int, later: int
) -> list[dict[str, MeasureOfSessions]]:
    """Compare the trials of two sessions in each of these tasks: the person's rows in it, and the clinic's spreads."""
    return [compare_sessions(rows, clinic, earlier, later) for rows, clinic in tasks]


def _summary(name: str, rows: Rows, session: int) -> Quartiles | None:
    """Return the quartiles of a session's compared trials that reached the goal; None where there are none."""
    compared = [row for row in rows if row["session"] == session and not row["familiarisation"]]
    values = np.array([value for row in compared if (value := value_of(row, name)) is not None], dtype=np.float64)
    if not len(values):
        return None
    quartiles = np.percentile(to_scale(name, values), (25, 50, 75))
    low, median, high = (from_scale(name, float(quartile)) for quartile in quartiles)
    return Quartiles(median=median, low=low, high=high, trials=len(values))
