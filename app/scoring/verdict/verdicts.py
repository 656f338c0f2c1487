"""The verdicts of a person's trials in one task: one trial against an earlier one, a session against earlier ones."""

from collections.abc import Collection, Mapping

from app.quantities import Document
from app.scoring.measures import REACHED, TRIAL_MEASURES
from app.scoring.verdict.detectable_change import LEVEL_OF_SESSIONS
from app.scoring.verdict.deterioration import deteriorations
from app.scoring.verdict.leading_measures import leading_of_task
from app.scoring.verdict.measure_scales import Rows, measured_in, value_of
from app.scoring.verdict.measure_verdict import FEWEST, ClinicSpreads, Verdict, difference_of, series_of, verdicts_on
from app.scoring.verdict.reaching import counts_of, family_of, reaching_difference, reaching_verdict
from app.scoring.verdict.spread import Series
from app.texts import Text


class TrialVerdicts(Document):
    """The verdicts on one trial against an earlier one of the same person, task and source."""

    earlier: int | None  # id of the earlier trial; None: there is none that counts
    familiarisation: list[int]  # ids of those of the two in which the person got used to the task: not compared
    verdicts: dict[str, Verdict]  # measure -> verdict; without the measures that cannot be compared, words for three
    best: dict[str, float]  # measure -> the best before the trial, of the trials that are compared


class SessionVerdicts(Document):
    """The verdicts on the newest session against an earlier one."""

    earlier: int  # number of the session
    later: int
    trials: tuple[int, int]  # of the two sessions, that reached the goal and are compared
    verdicts: dict[str, Verdict]  # measure -> verdict; "reached": the share of trials that reached the goal


class TaskVerdicts(Document):
    """What a person's trials in one task say about change."""

    sessions: list[SessionVerdicts]  # the newest session against the one before, and against the first
    deterioration: dict[str, Text]  # measure -> sentence with what to do; only of measures that have become worse
    needed: int = FEWEST  # trials in all that a verdict needs


def trial_verdicts(rows: Rows, clinic: ClinicSpreads, later: int, earlier: int | None) -> TrialVerdicts:
    """Compare the trial with the id `later` with the trial `earlier`; None: the newest before it that is compared.

    `rows` are the person's trials of one task and source, in the order driven. Each has `id`, `number`, `session`,
    `familiarisation` and its measures by name. `clinic` are the median spreads of other people in this task. Two trials
    in the wrong order are compared in the order in which they were driven.
    """
    ids = [row["id"] for row in rows]
    if earlier is not None and earlier in ids and later in ids and ids.index(earlier) > ids.index(later):
        earlier, later = later, earlier
    warming = {row["id"] for row in rows if row["familiarisation"]}
    if earlier is None and later in ids:
        earlier_ids = [trial_id for trial_id in ids[: ids.index(later)] if trial_id not in warming]
        earlier = earlier_ids[-1] if earlier_ids and later not in warming else None
    pair_rows = [row for row in rows if row["id"] in (earlier, later)]
    differences = {}
    for name in TRIAL_MEASURES:
        if all(value_of(row, name) is not None for row in pair_rows):
            series, trial_ids = series_of(rows, name)
            difference = difference_of(name, series, trial_ids == earlier, trial_ids == later, clinic.get(name))
            if difference is not None:
                differences[name] = difference
    verdicts, _ = verdicts_on(differences, leading_of_task(rows))
    pair = [trial_id for trial_id in (earlier, later) if trial_id in warming]
    before_it = rows[: ids.index(later)] if later in ids else []
    return TrialVerdicts(earlier=earlier, familiarisation=pair, verdicts=verdicts, best=_best(before_it))


def _best(rows: Rows) -> dict[str, float]:
    """Return the best of each measure in these trials, without those in which the person got used to the task."""
    best = {}
    for name, measure in TRIAL_MEASURES.items():
        values = [value_of(row, name) for row in rows if not row["familiarisation"]]
        counted = [value for value in values if value is not None]
        if counted and measure.better is not None:
            best[name] = min(counted) if measure.better == "low" else max(counted)
    return best


def task_verdicts(rows: Rows, clinic: ClinicSpreads, names: Collection[str] = TRIAL_MEASURES) -> TaskVerdicts:
    """Compare the newest session with the one before and the first, and search `names` for a deterioration.

    `rows` and `clinic` as for `trial_verdicts`. Sessions without a trial that is compared do not count. The search
    takes ten times as long as the comparison: name the measures whose sentence is shown.
    """
    sessions = list(dict.fromkeys(row["session"] for row in rows if not row["familiarisation"]))
    if len(sessions) < 2:
        return TaskVerdicts(sessions=[], deterioration={})
    all_series = {name: series_of(rows, name)[0] for name in measured_in(rows)}
    compared = []
    for earlier in dict.fromkeys((sessions[-2], sessions[0])):
        pair = _count(rows, earlier), _count(rows, sessions[-1])
        verdicts = session_verdicts(rows, all_series, clinic, earlier, sessions[-1])
        compared.append(SessionVerdicts(earlier=earlier, later=sessions[-1], trials=pair, verdicts=verdicts))
    return TaskVerdicts(sessions=compared, deterioration=deteriorations(rows, clinic, names))


def session_verdicts(
    rows: Rows, all_series: Mapping[str, Series], clinic: ClinicSpreads, earlier: int, later: int
) -> dict[str, Verdict]:
    """Compare two sessions in every measure that both have, and in how often the goal was reached."""
    differences = {}
    for name, series in all_series.items():
        first, second = series.session == earlier, series.session == later
        difference = difference_of(name, series, first, second, clinic.get(name))
        if difference is not None:
            differences[name] = difference
    reaching = reaching_difference(counts_of(rows), earlier, later)
    verdicts, levels = verdicts_on(differences, leading_of_task(rows), family_of(reaching), LEVEL_OF_SESSIONS)
    return {REACHED: reaching_verdict(reaching, levels.get(REACHED)), **verdicts}


def _count(rows: Rows, session: int) -> int:
    """Return how many trials of a session reached the goal and were not for getting used to the task."""
    return sum(row["session"] == session and row.get("reached", True) and not row["familiarisation"] for row in rows)
