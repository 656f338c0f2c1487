"""Learning curves over trials, and what was kept from session to session, with the sentences that describe them."""

import math
from collections.abc import Iterable, Sequence
from itertools import groupby, pairwise
from typing import Any, Literal, NamedTuple

import numpy as np

from app.scoring.learning_fit import (
    MIN_TRIALS,
    MIN_TRIALS_FOR_CONSTANT,
    Curve,
    LearningCurve,
    Numbers,
    fit_learning_curve,
)
from app.scoring.measures import TRIAL_MEASURES, Measure
from app.scoring.trend import theil_sen
from app.scoring.verdict.change_over_sessions import CourseChange, course_change
from app.scoring.verdict.leading_measures import leading_of_task
from app.scoring.verdict.measure_scales import Row, Rows
from app.scoring.verdict.measure_verdict import ClinicSpreads
from app.texts import Figure, Text, Value, in_sequence

LARGEST = 1e100  # larger values are left out: sums of squares would overflow
EDGE = 3  # trials at either end whose medians are compared
SESSION_EDGE = 2  # trials at either end of a session whose mean is its start and its end
MIN_SESSION_TRIALS = 2 * SESSION_EDGE  # of a session; with fewer, its start and its end would share trials
CONFIDENCE = 0.99  # six intervals of three measures stand side by side: together 5 % are wrong
MIN_SESSIONS = 4  # with fewer, the interval of the mean change between sessions is too wide

CurveDocument = dict[str, Any]
"""A learning curve with its sentences, as `learning_curves` describes it."""


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

    @property
    def how(self) -> Literal["noise", "fell", "rose"]:
        """What became of the measure."""
        return "noise" if self.is_noise else "fell" if self.mean < 0 else "rose"


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
    """Return, for each measure that the trials have, sentences and the fitted curve.

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
    {measure: {"text": Text, "sessions": Text or None, "details": [Text], "fit": None or {"n": [...], "value": [...],
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


def _too_few_sentence(count: int) -> Text:
    """Say that there are not trials enough for a curve."""
    return Text("learning-few", count=count, least=MIN_TRIALS)


def _change_sentences(name: str, learning: LearningCurve, change: CourseChange, sessions: int) -> Text:
    """Say what became of a measure, by how much, and where it levels off.

    `sessions` is the number of sessions that the trials were driven in; 0 where that is not known.
    """
    measure, count = TRIAL_MEASURES[name], len(learning.n)
    word = "few" if change.word == "too few" else change.word
    head = Text(f"learning-head-{word}", trials=count, sessions=sessions)
    if _is_change(change):
        sentences = [_change(measure, learning, change, head), *_shape(measure, learning, change)]
    else:
        level = measure.level(float(np.median(learning.values)))
        sentences = [Text("learning-level", head=head, subject=measure.as_subject, level=level)]
    if count < MIN_TRIALS_FOR_CONSTANT:
        sentences.append(Text("learning-caution", count=count))
    return in_sequence(sentences)


def session_sentences(name: str, kept_change: Retention) -> Text:
    """Say what changed within a session, and how much of it was kept until the next one."""
    measure, (within, between) = TRIAL_MEASURES[name], kept_change
    if within.is_noise and between.is_noise:
        return Text("learning-sessions-noise", sessions=within.sessions)
    steps: dict[str, Value] = {
        "within": Text("learning-within", how=within.how, amount=measure.difference(abs(within.mean))),
        "between": Text("learning-between", how=between.how, amount=measure.difference(abs(between.mean))),
        "sessions": within.sessions,
    }
    if within.is_noise or not _is_better(name, within.mean):
        return Text("learning-sessions", **steps)
    if between.is_noise:
        return Text("learning-sessions-perhaps-kept", **steps)
    if _is_better(name, between.mean):
        return Text("learning-sessions-kept", **steps)
    share = 1 - abs(between.mean / within.mean)
    if share < 0.01:
        return Text("learning-sessions-lost", **steps)
    return Text("learning-sessions-part-kept", percent=Figure(100 * share), **steps)


def _change_statistics(name: str, learning: LearningCurve, change: CourseChange) -> Text:
    """Return the statistics of the change and of the curve of a measure."""
    measure, (first, last) = TRIAL_MEASURES[name], _ends(learning)
    # A few unusual trials at an end may contradict the change; the sentence must not.
    went = {(True, True): "fell", (False, False): "rose"}.get((change.falls, last < first), "went")
    medians = Text(
        "learning-medians",
        subject=measure.as_subject,
        how=went if _is_change(change) else "went",
        first=measure.level(first),
        last=measure.level(last),
        edge=EDGE,
        trials=len(learning.n),
    )
    return in_sequence(
        [medians, *_test(change), *_slope(measure, learning, change), _form(measure, learning)],
    )


def _test(change: CourseChange) -> list[Text]:
    """Say how the change was tested; nothing where it was not."""
    if change.p_value is None:
        return []
    level, sessions = _two_digits(change.level), change.sessions
    if change.p_value < 0.001:
        return [Text("learning-p-small", level=level, sessions=sessions)]
    return [Text("learning-p", p=_two_digits(change.p_value), level=level, sessions=sessions)]


def _two_digits(value: float) -> float:
    return float(f"{value:.2g}")


def _is_change(change: CourseChange) -> bool:
    return change.word in ("better", "worse")


def session_statistics(name: str, kept_change: Retention) -> Text:
    """Return the changes within and between sessions with their intervals."""
    measure, (within, between) = TRIAL_MEASURES[name], kept_change
    return Text(
        "learning-statistics",
        within=Text("learning-statistics-within", sessions=within.sessions, **_interval(measure, within)),
        between=Text("learning-statistics-between", **_interval(measure, between)),
    )


def _ends(learning: LearningCurve) -> tuple[float, float]:
    """Return the medians of the first and of the last trials."""
    return float(np.median(learning.values[:EDGE])), float(np.median(learning.values[-EDGE:]))


def _is_better(name: str, change: float) -> bool:
    better = TRIAL_MEASURES[name].better
    return better is not None and (change < 0) == (better == "low")


def _change(measure: Measure, learning: LearningCurve, change: CourseChange, head: Text) -> Text:
    """Say by how much a measure fell or rose; not where a few unusual trials at an end contradict it."""
    first, last = _ends(learning)
    how = "fell" if change.falls else "rose"
    if first == last or (last < first) != change.falls:
        return Text("learning-change", head=head, subject=measure.as_subject, how=how)
    return Text(
        "learning-change-by",
        head=head,
        subject=measure.as_subject,
        how=how,
        amount=measure.difference(abs(last - first)),
        first=measure.figure(first),
        last=measure.level(last),
    )


def _shape(measure: Measure, learning: LearningCurve, change: CourseChange) -> list[Text]:
    """Say where a measure levels off; nothing where a level line is best, or the curve contradicts the change."""
    curve = learning.curve
    if curve.form == "level" or (curve.b > 0) != change.falls:
        return []
    if curve.form == "power":
        return [Text("learning-goes-on")]
    if not learning.levels_off:
        return [Text("learning-not-level-yet")]
    level = max(curve.a, 0.0) if np.all(learning.values >= 0) else curve.a
    return [Text("learning-levels-off", level=measure.level(level))]


def _interval(measure: Measure, change: MeanChange) -> dict[str, Value]:
    """Return a mean change and its interval; without their signs where the sentence says that it fell or rose."""
    mean, low, high = change.mean, change.low, change.high
    if not change.is_noise:
        mean, (low, high) = abs(mean), sorted((abs(low), abs(high)))
    return {
        "how": change.how,
        "change": measure.difference(mean),
        "low": measure.figure(low),
        "high": measure.figure(high),
    }


def _slope(measure: Measure, learning: LearningCurve, change: CourseChange) -> list[Text]:
    """Say how steep the course is; nothing where there is no change, or the slope contradicts it."""
    slope = theil_sen(learning.n.tolist(), learning.values.tolist())
    if not _is_change(change) or slope == 0 or (slope < 0) != change.falls:
        return []
    figure = _two_digits(abs(slope) * measure.factor)
    step = measure.difference_with_unit(figure, figure)
    return [Text("learning-slope", how="falls" if change.falls else "rises", step=step)]


def _form(measure: Measure, learning: LearningCurve) -> Text:
    curve = learning.curve
    if curve.form == "level":
        return Text("learning-form-level")
    if curve.form == "power":
        return Text("learning-form-power")
    if not learning.levels_off:
        return Text("learning-form-open")
    level = measure.level(curve.a)
    if learning.constant is not None:
        tau, low, high = (Figure(trials, 1) for trials in learning.constant)
        return Text("learning-form-constant", level=level, trials=tau, low=low, high=high)
    if len(learning.n) < MIN_TRIALS_FOR_CONSTANT:
        return Text("learning-form-few", level=level, least=MIN_TRIALS_FOR_CONSTANT)
    return Text("learning-form-fast", level=level)
