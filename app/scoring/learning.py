"""Learning curves over trials, with the sentences that describe them."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from app.scoring.learning_fit import Curve, LearningCurve, Numbers, fit_learning_curve
from app.scoring.learning_words import details, plain_sessions, plain_words, session_details, too_few
from app.scoring.measures import TRIAL_MEASURES
from app.scoring.retention import retention
from app.scoring.verdict.change_over_sessions import course_change
from app.scoring.verdict.leading_measures import leading_of_task
from app.scoring.verdict.measure_verdict import ClinicSpreads

LARGEST = 1e100  # larger values are left out: sums of squares would overflow


def learning_curves(
    trials: Sequence[Mapping[str, Any]],
    names: Iterable[str] = TRIAL_MEASURES,
    clinic: ClinicSpreads | None = None,
    *,
    every_model: bool = False,
) -> dict[str, dict[str, Any]]:
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
    curves: dict[str, dict[str, Any]] = {}
    leading = leading_of_task(trials)
    driven = [_row(index, trial) for index, trial in enumerate(trials, start=1)]
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
        curve = curves[name] = {"text": too_few(len(rows)), "sessions": None, "details": [], "fit": None}
        if learning is not None:
            are_known = len(sessions) == len(values)
            kept = retention(sessions, values) if are_known and name in leading else None
            change = course_change(name, driven, leading, clinic or {})
            curve["text"] = plain_words(name, learning, change, len(set(sessions)) if are_known else 0)
            curve["sessions"] = kept and plain_sessions(name, kept)
            curve["details"] = [
                details(name, learning, change),
                *([] if kept is None else [session_details(name, kept)]),
            ]
            curve["fit"] = None if learning.curve.form == "level" else _curve_document(learning.n, learning.curve)
        if every_model:
            curve["form"] = learning and learning.curve.form
            curve["others"] = [] if learning is None else _others(learning)
    return curves


def _row(index: int, trial: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return a trial as verdicts need it; without a number of its session, all are of one."""
    return {"id": index, "number": trial.get("trial", index), "session": 1, "familiarisation": False, **trial}


def _curve_document(n: Numbers, curve: Curve) -> dict[str, list[float]]:
    return {"n": n.tolist(), "value": curve.value.tolist(), "low": curve.low.tolist(), "high": curve.high.tolist()}


def _others(learning: LearningCurve) -> list[dict[str, Any]]:
    best = learning.curve.aicc
    return [
        {"form": curve.form, "aicc_more": curve.aicc - best, **_curve_document(learning.n, curve)}
        for curve in learning.curves[1:]
    ]
