"""Learning curves over trials, and what was kept from session to session, with the sentences that describe them."""

import math
from collections.abc import Iterable, Sequence
from itertools import groupby, pairwise
from typing import Any, NamedTuple

import numpy as np

from app.number_format import amount, with_minus
from app.scoring.learning_fit import (
    MIN_TRIALS,
    MIN_TRIALS_FOR_CONSTANT,
    Curve,
    LearningCurve,
    Numbers,
    fit_learning_curve,
)
from app.scoring.measures import TRIAL_MEASURES, VERDICT_WORDS, Measure
from app.scoring.trend import theil_sen
from app.scoring.verdict.change_over_sessions import CourseChange, course_change
from app.scoring.verdict.leading_measures import leading_of_task
from app.scoring.verdict.measure_comparison import Row, Rows
from app.scoring.verdict.measure_verdict import ClinicSpreads

LARGEST = 1e100  # larger values are left out: sums of squares would overflow
EDGE = 3  # trials at either end whose medians are compared
SESSION_EDGE = 2  # trials at either end of a session whose mean is its start and its end
MIN_SESSION_TRIALS = 2 * SESSION_EDGE  # of a session; with fewer, its start and its end would share trials
CONFIDENCE = 0.99  # six intervals of three measures stand side by side: together 5 % are wrong
MIN_SESSIONS = 4  # with fewer, the interval of the mean change between sessions is too wide

CurveDocument = dict[str, Any]
"""A learning curve with its sentences, as `learning_curves` describes it, ready for JSON."""


class MeanChange(NamedTuple):
    """A mean change over sessions with its 99 % interval."""

    mean: float
    low: float
    high: float
    sessions: int

    @property
    def is_noise(self) -> bool:
        """Return whether the interval contains 0."""
        return self.low <= 0 <= self.high


class Retention(NamedTuple):
    """How a measure changed within sessions, and from the end of one to the start of the next."""

    within: MeanChange
    between: MeanChange


def retention(sessions: Sequence[int], values: Sequence[float]) -> Retention | None:
    """Compare the changes within sessions with those between them; None with fewer than 4 sessions of 4 trials.

    `sessions` (n,) are the numbers of the sessions, rising, and `values` (n,) the measure, in the order of the trials.
    The change between two sessions is from the last two trials of one to the first two of the next in which the path
    was driven; a session of fewer than 4 trials is left out with the changes before and after it.
    """
    ends: list[tuple[float, float] | None] = []  # start and end of each session; None with too few trials
    for _session, rows in groupby(zip(sessions, values, strict=True), key=lambda row: row[0]):
        series = [value for _, value in rows]
        enough = len(series) >= MIN_SESSION_TRIALS
        ends.append((float(np.mean(series[:SESSION_EDGE])), float(np.mean(series[-SESSION_EDGE:]))) if enough else None)
    if sum(end is not None for end in ends) < MIN_SESSIONS:
        return None
    within = [end[1] - end[0] for end in ends if end]
    between = [after[0] - before[1] for before, after in pairwise(ends) if before and after]
    return Retention(_mean_change(within), _mean_change(between)) if len(between) >= MIN_SESSIONS - 1 else None


def _mean_change(changes: Sequence[float]) -> MeanChange:
    from scipy.special import stdtrit

    mean, count = float(np.mean(changes)), len(changes)
    half = float(stdtrit(count - 1, (1 + CONFIDENCE) / 2) * np.std(changes, ddof=1)) / math.sqrt(count)
    return MeanChange(mean, mean - half, mean + half, count)


def learning_curves(
    trials: Rows,
    names: Iterable[str] = TRIAL_MEASURES,
    clinic: ClinicSpreads | None = None,
    *,
    every_model: bool = False,
) -> dict[str, CurveDocument]:
    """Return, for each measure that the trials have, sentences and the fitted curve, ready for JSON.

    Parameters
    ----------
    trials
        In the order driven; each has measures by name, and may have `number` (or `trial`), from 1, `session` (its
        number), `familiarisation` and `reached`. A trial that did not reach the goal is on no curve: its distance, area
        and time are those of a part of the path. Whether there is a change is told with it (`app.scoring.verdict`).
    names
        The measures that are asked for; each takes some 10 ms.
    clinic
        The clinic's median spreads in this task; without them more sessions are needed to tell a change from noise.
    every_model
        Whether to return the curves that were not chosen, too.

    Returns
    -------
    {measure: {"text": str, "sessions": str or None, "details": [str], "fit": None or {"n": [...], "value": [...],
    "low": [...], "high": [...]}}}; the band is the 95 % band of the curve, and there is no fit where a level line is
    best. `text` and `sessions` are plain sentences, `sessions` on the changes within and between sessions of a measure
    that leads in the task; `details` are the statistics behind them. With `every_model` also "form" ("exponential",
    "power", "level" or None) and "others": [{"form", "aicc_more", "n", "value", "low", "high"}], the better first.
    """
    curves: dict[str, CurveDocument] = {}
    leading = leading_of_task(trials)
    compared = [_row(index, trial) for index, trial in enumerate(trials, start=1)]
    for name in names:
        if not any(name in trial for trial in trials):
            continue
        rows = [
            (float(trial.get("number", trial.get("trial", index))), float(trial[name]), trial.get("session"))
            for index, trial in enumerate(trials, start=1)
            if trial.get("reached", True) and trial.get(name) is not None and abs(trial[name]) < LARGEST
        ]
        rows.sort(key=lambda row: row[0])
        numbers, values = [row[0] for row in rows], [row[1] for row in rows]
        sessions = [row[2] for row in rows if row[2] is not None]
        learning = fit_learning_curve(numbers, values)
        curve = curves[name] = {"text": _too_few_sentence(len(rows)), "sessions": None, "details": [], "fit": None}
        if learning is not None:
            are_known = len(sessions) == len(values)
            kept_change = retention(sessions, values) if are_known and name in leading else None
            change = course_change(name, compared, leading, clinic or {})
            curve["text"] = _change_sentences(name, learning, change, len(set(sessions)) if are_known else 0)
            curve["sessions"] = kept_change and session_sentences(name, kept_change)
            curve["details"] = [
                _change_statistics(name, learning, change),
                *([] if kept_change is None else [session_statistics(name, kept_change)]),
            ]
            curve["fit"] = None if learning.curve.form == "level" else _curve_document(learning.n, learning.curve)
        if every_model:
            curve["form"] = learning and learning.curve.form
            curve["others"] = [] if learning is None else _other_curves(learning)
    return curves


def _row(index: int, trial: Row) -> Row:
    """Return a trial as verdicts need it; without a number of its session, all are of one."""
    return {"id": index, "number": trial.get("trial", index), "session": 1, "familiarisation": False, **trial}


def _curve_document(n: Numbers, curve: Curve) -> dict[str, list[float]]:
    return {"n": n.tolist(), "value": curve.value.tolist(), "low": curve.low.tolist(), "high": curve.high.tolist()}


def _other_curves(learning: LearningCurve) -> list[CurveDocument]:
    best = learning.curve.aicc
    return [
        {"form": curve.form, "aicc_more": curve.aicc - best, **_curve_document(learning.n, curve)}
        for curve in learning.curves[1:]
    ]


def _too_few_sentence(count: int) -> str:
    """Say that there are not trials enough for a curve."""
    return f"Not enough trials for a learning curve: {count} of at least {MIN_TRIALS} that reached the goal."


def _change_sentences(name: str, learning: LearningCurve, change: CourseChange, sessions: int) -> str:
    """Say what became of a measure, by how much, and where it levels off.

    `sessions` is the number of sessions that the trials were driven in; 0 where that is not known.
    """
    measure, count = TRIAL_MEASURES[name], len(learning.n)
    over = f"over {count} trials" + (f" in {amount(sessions, 'session')}" if sessions else "")
    subject = f"{measure.as_subject[0].lower()}{measure.as_subject[1:]}"
    if change.word not in ("better", "worse"):
        begin = {"within": f"Within noise {over}", "too few": f"Too few sessions to tell a change from noise, {over}"}
        head = begin.get(change.word, over.capitalize())
        sentence = f"{head}: {subject} was about {measure.level(float(np.median(learning.values)))}."
    else:
        head = f"{VERDICT_WORDS[change.word].capitalize()} {over}"
        sentence = f"{head}: {subject} {_change(measure, learning, change)}.{_shape(measure, learning, change)}"
    caution = f" {count} trials are few: this may yet change." if count < MIN_TRIALS_FOR_CONSTANT else ""
    return f"{sentence}{caution}"


def session_sentences(name: str, kept_change: Retention) -> str:
    """Say what changed within a session, and how much of it was kept until the next one."""
    measure, (within, between) = TRIAL_MEASURES[name], kept_change
    if within.is_noise and between.is_noise:
        return (
            "Neither the change within a session nor the one over the pause to the next is more than noise "
            f"(on average of {within.sessions} sessions)."
        )
    sentence = (
        f"Within a session it {_step(measure, within)}, over the pause to the next one it {_step(measure, between)} "
        f"(on average of {within.sessions} sessions)"
    )
    if within.is_noise or not _is_better(name, within.mean):
        return f"{sentence}."
    if between.is_noise:
        return f"{sentence}: what was gained was kept, as far as can be told."
    if _is_better(name, between.mean):
        return f"{sentence}: what was gained was kept."
    share = 1 - abs(between.mean / within.mean)
    share_kept = f"about {100 * share:.0f} % of what was gained" if share >= 0.01 else "nothing of what was gained"
    return f"{sentence}: {share_kept} was kept."


def _change_statistics(name: str, learning: LearningCurve, change: CourseChange) -> str:
    """Return the statistics of the change and of the curve of a measure."""
    measure, count = TRIAL_MEASURES[name], len(learning.n)
    first, last = _ends(learning)
    # A few unusual trials at an end may contradict the change; the sentence must not.
    went = {(True, True): "fell", (False, False): "rose"}.get((change.falls, last < first), "went")
    sentence = (
        f"{measure.as_subject} {went if _is_change(change) else 'went'} from {measure.level(first)} to "
        f"{measure.level(last)} (medians of the first and the last {EDGE} of {count} trials)."
    )
    if change.p_value is not None:
        p = "p < 0.001" if change.p_value < 0.001 else f"p = {change.p_value:.2g}"
        sentence += (
            " The last third of the sessions against the first, or the newest against those before, beside this "
            f"person's own noise: {p}; a change has p < {change.level:.2g}."
        )
    return f"{sentence}{_slope(measure, learning, change)} {_form(measure, learning)}"


def _is_change(change: CourseChange) -> bool:
    return change.word in ("better", "worse")


def session_statistics(name: str, kept_change: Retention) -> str:
    """Return the changes within and between sessions with their intervals."""
    measure = TRIAL_MEASURES[name]
    return (
        f"In the mean of {kept_change.within.sessions} sessions it {_interval(measure, kept_change.within)} within a "
        f"session, and {_interval(measure, kept_change.between)} from its last trials to the first of the next."
    )


def _ends(learning: LearningCurve) -> tuple[float, float]:
    """Return the medians of the first and of the last trials."""
    return float(np.median(learning.values[:EDGE])), float(np.median(learning.values[-EDGE:]))


def _is_better(name: str, change: float) -> bool:
    better = TRIAL_MEASURES[name].better
    return better is not None and (change < 0) == (better == "low")


def _change(measure: Measure, learning: LearningCurve, change: CourseChange) -> str:
    """Say by how much a measure fell or rose; not where a few unusual trials at an end contradict it."""
    first, last = _ends(learning)
    went = "fell" if change.falls else "rose"
    if first == last or (last < first) != change.falls:
        return went
    amount = measure.level(abs(last - first))
    return f"{went} by about {amount}, from {measure.figure(first)} to {measure.level(last)}"


def _shape(measure: Measure, learning: LearningCurve, change: CourseChange) -> str:
    """Say where a measure levels off; nothing where a level line is best, or the curve contradicts the change."""
    curve = learning.curve
    if curve.form == "level" or (curve.b > 0) != change.falls:
        return ""
    if curve.form == "power":
        return " It goes on changing, in ever smaller steps."
    if not learning.levels_off:
        return " It has not levelled off yet."
    level = max(curve.a, 0.0) if np.all(learning.values >= 0) else curve.a
    return f" It levels off at about {measure.level(level)}."


def _step(measure: Measure, change: MeanChange) -> str:
    if change.is_noise:
        return "stayed within noise"
    return f"{'fell' if change.mean < 0 else 'rose'} by about {measure.level(abs(change.mean))}"


def _interval(measure: Measure, change: MeanChange) -> str:
    low, high = (measure.figure(end) for end in (change.low, change.high))
    if change.is_noise:
        return f"changed by {measure.level(change.mean)} (within noise; 99 %: {low} to {high})"
    low, high = (measure.figure(end) for end in sorted((abs(change.low), abs(change.high))))
    return f"{'fell' if change.mean < 0 else 'rose'} by {measure.level(abs(change.mean))} (99 %: {low} to {high})"


def _slope(measure: Measure, learning: LearningCurve, change: CourseChange) -> str:
    """Say how steep the course is; nothing where there is no change, or the slope contradicts it."""
    slope = theil_sen(learning.n.tolist(), learning.values.tolist())
    if not _is_change(change) or slope == 0 or (slope < 0) != change.falls:
        return ""
    step = with_minus(f"{abs(slope) * measure.factor:.2g}")
    return f" From trial to trial it {'falls' if change.falls else 'rises'} by {measure.with_unit(step)} in the median."


def _form(measure: Measure, learning: LearningCurve) -> str:
    curve = learning.curve
    if curve.form == "level":
        return "No curve describes it better than a level line."
    if curve.form == "power":
        return "A power law describes it better than an exponential: large steps at first, then ever smaller ones."
    if not learning.levels_off:
        return "An exponential describes it best, and it has not levelled off within these trials."
    levels = f"An exponential describes it best, levelling off at {measure.level(curve.a)}"
    if learning.constant is not None:
        tau, low, high = learning.constant
        return f"{levels}, with a learning constant of {tau:.1f} trials (95 %: {low:.1f} to {high:.1f})."
    if len(learning.n) < MIN_TRIALS_FOR_CONSTANT:
        return f"{levels}; how fast is told from {MIN_TRIALS_FOR_CONSTANT} trials on."
    return f"{levels} within the first trials."
