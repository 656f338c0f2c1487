"""Learning curves over trials, and what they say in plain sentences."""

import math
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from app.session.learning_fit import Curve, Numbers, fit_exponential, fit_level, fit_power
from app.session.trend import Trend, mann_kendall

MIN_TRIALS = 8  # below: not enough for a curve of three parameters
MIN_TRIALS_FOR_CONSTANT = 20  # below: the learning constant is too uncertain to be told
EDGE = 3  # trials at either end whose mean stands for "at first" and "at last"


class Measure(NamedTuple):
    """How a measure is called and counted."""

    words: str
    unit: str


MEASURES: dict[str, Measure] = {
    "dist": Measure("Dist, the distance driven,", "m"),
    "dist_ratio": Measure("The distance driven over the length of the path", ""),
    "e_diff": Measure("E_diff, the area between trajectory and path,", "m²"),
    "time": Measure("The time for a trial", "s"),
    "cross_track_rms": Measure("The distance from the path (rms)", "m"),
    "cross_track_max": Measure("The largest distance from the path", "m"),
    "mean_speed": Measure("The mean speed", "m/s"),
    "stops": Measure("The number of stops", ""),
    "collisions": Measure("The number of contacts with walls and obstacles", ""),
    "contact_time": Measure("The time in contact with walls and obstacles", "s"),
    "stages_done": Measure("The number of stages done", ""),
    "follow_error_rms": Measure("The error of the distance to the leader (rms)", "m"),
    "follow_error_max": Measure("The largest error of the distance to the leader", "m"),
    "follow_near": Measure("The share of time near the asked distance", ""),
    "heading_error_deg": Measure("The angle beside the mark", "°"),
    "turn_drift": Measure("The way off the spot", "m"),
    "cones_touched": Measure("The number of cones touched", ""),
    "gap_clearance": Measure("The narrowest clearance in a gap", "m"),
    "door_contacts": Measure("The number of contacts with a door or gap", ""),
    "turn_reversals": Measure("The number of changes between left and right turns", ""),
    "pulses_per_metre": Measure("The number of commands per metre", "/m"),
    "sparc": Measure("The smoothness of the speed (SPARC, higher is smoother)", ""),
    "ldlj": Measure("The smoothness of the speed (log dimensionless jerk, higher is smoother)", ""),
}


class LearningCurve(NamedTuple):
    """What can be said about one measure over trials."""

    n: Numbers  # (n,) trial numbers, from 1
    values: Numbers  # (n,)
    trend: Trend
    curve: Curve  # the one that costs the least information; its form is "level" where nothing was learnt

    @property
    def constant(self) -> tuple[float, float, float] | None:
        """The learning constant tau in trials with its confidence interval, where there are trials enough for it."""
        if self.curve.form != "exponential" or len(self.n) < MIN_TRIALS_FOR_CONSTANT:
            return None
        if math.isnan(self.curve.c_low) or math.isnan(self.curve.c_high):
            return None
        return self.curve.c, self.curve.c_low, self.curve.c_high


def fit_learning_curve(n: Sequence[float], values: Sequence[float]) -> LearningCurve | None:
    """Fit one measure over trials; None with fewer than 8 trials.

    `n` are trial numbers from 1, rising; `values` (n,) are finite. A curve with a bend is preferred to a level line
    only where AICc says that it is worth its parameters.
    """
    if len(values) < MIN_TRIALS:
        return None
    number = np.asarray(n, dtype=np.float64)
    series = np.asarray(values, dtype=np.float64)
    curves = [fit_level(series), fit_exponential(number, series), fit_power(number, series)]
    best = min(curves, key=lambda curve: curve.aicc)
    return LearningCurve(number, series, mann_kendall(values), best)


def learning_curves(trials: Sequence[Mapping[str, Any]]) -> dict[str, dict[str, Any]]:
    """Return, per measure that the trials have, a sentence or two and the fitted curve, ready for JSON.

    Parameters
    ----------
    trials : in the order driven; each has measures by name, and may have `number` (or `trial`), from 1, and `reached`.
        A trial that did not reach the goal has no comparable distance, area or time, so that it is left out.

    Returns
    -------
    {measure: {"text": str, "fit": None or {"n": [...], "value": [...], "low": [...], "high": [...]}}}; the band is
    the 95 % band of the curve.
    """
    curves: dict[str, dict[str, Any]] = {}
    for name, measure in MEASURES.items():
        if not any(name in trial for trial in trials):
            continue
        rows = [
            (float(trial.get("number", trial.get("trial", index))), float(trial[name]))
            for index, trial in enumerate(trials, start=1)
            if trial.get("reached", True) and trial.get(name) is not None and math.isfinite(trial[name])
        ]
        rows.sort(key=lambda row: row[0])
        learning = fit_learning_curve([row[0] for row in rows], [row[1] for row in rows])
        if learning is None:
            count = f"{len(rows)} of at least {MIN_TRIALS} that reached the goal"
            curves[name] = {"text": f"Not enough trials for a learning curve: {count}.", "fit": None}
        else:
            curves[name] = {"text": describe(measure, learning), "fit": _fit_of(learning)}
    return curves


def describe(measure: Measure, learning: LearningCurve) -> str:
    """Say in plain sentences what the curve shows."""
    first, last = float(np.mean(learning.values[:EDGE])), float(np.mean(learning.values[-EDGE:]))
    count = len(learning.n)
    p = "p < 0.001" if learning.trend.p < 0.001 else f"p = {learning.trend.p:.2g}"
    went = {"falls": "fell", "rises": "rose", "none": "went"}[learning.trend.direction]
    change = (
        f"{measure.words} {went} from {_number(first, measure.unit)} to {_number(last, measure.unit)} "
        f"(means of the first and the last {EDGE} of {count} trials; Mann-Kendall trend test: {p})."
    )
    if learning.trend.direction == "none":
        change += " This is not a trend: it may be chance."
    return f"{change} {_shape_in_words(measure, learning)}"


def _shape_in_words(measure: Measure, learning: LearningCurve) -> str:
    curve = learning.curve
    count = len(learning.n)
    if curve.form == "level":
        return "No curve describes it better than a level line."
    if curve.form == "power":
        return "A power law describes it better than an exponential: large steps at first, then ever smaller ones."
    if math.isnan(curve.c_high):
        return "An exponential describes it best, and it has not levelled off within these trials."
    levels = f"An exponential describes it best, levelling off at {_number(curve.a, measure.unit)}"
    if learning.constant is not None:
        tau, low, high = learning.constant
        return f"{levels}, with a learning constant of {tau:.1f} trials (95 %: {low:.1f} to {high:.1f})."
    if count < MIN_TRIALS_FOR_CONSTANT:
        return f"{levels}; how fast is told from {MIN_TRIALS_FOR_CONSTANT} trials on."
    return f"{levels} within the first trials."


def _fit_of(learning: LearningCurve) -> dict[str, list[float]] | None:
    curve = learning.curve
    if curve.form == "level":
        return None
    return {
        "n": [float(n) for n in learning.n],
        "value": [float(value) for value in curve.value],
        "low": [float(value) for value in curve.low],
        "high": [float(value) for value in curve.high],
    }


def _number(value: float, unit: str) -> str:
    return f"{value:.3g} {unit}".rstrip()
