"""Learning curves over trials, and plain sentences that describe them."""

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from app.scoring.learning_fit import Curve, Numbers, fit_exponential, fit_level, fit_power
from app.scoring.retention import describe_retention, retention
from app.scoring.trend import Trend, mann_kendall, theil_sen

MIN_TRIALS = 8  # a curve has three parameters
MIN_TRIALS_FOR_CONSTANT = 20  # with fewer, the learning constant is too uncertain to be given
EDGE = 3  # trials at either end whose medians are compared
LARGEST = 1e100  # larger values are left out: sums of squares would overflow


class Measure(NamedTuple):
    """The words and the unit of a measure, and what a stored value is multiplied by to be in that unit."""

    words: str
    unit: str
    factor: float = 1.0


MEASURES: dict[str, Measure] = {
    "dist": Measure("The distance driven", "m"),
    "dist_ratio": Measure("The distance driven over the length of the path", ""),
    "e_diff": Measure("The area off the path", "m²"),
    "time": Measure("The time for a trial", "s"),
    "cross_track_rms": Measure("The usual distance from the path", "m"),
    "cross_track_max": Measure("The largest distance from the path", "m"),
    "mean_speed": Measure("The mean speed", "m/s"),
    "stops": Measure("The number of stops", ""),
    "collisions": Measure("The number of contacts with walls and obstacles", ""),
    "contact_time": Measure("The time in contact with walls and obstacles", "s"),
    "stages_done": Measure("The number of stages done", ""),
    "follow_error_rms": Measure("The usual error of the distance to the leader", "m"),
    "follow_error_max": Measure("The largest error of the distance to the leader", "m"),
    "follow_near": Measure("The share of time near the asked distance", "%", 100.0),
    "heading_error_deg": Measure("The angle off the mark", "°"),
    "turn_drift": Measure("The way off the spot", "m"),
    "cones_touched": Measure("The number of cones touched", ""),
    "gap_clearance": Measure("The narrowest clearance in a gap", "m"),
    "door_contacts": Measure("The number of contacts with a door or gap", ""),
    "turn_reversals": Measure("The number of changes between left and right turns", ""),
    "pulses_per_metre": Measure("The number of commands per metre", "/m"),
    "sparc": Measure("The smoothness of the speed (higher is smoother)", ""),
    "ldlj": Measure("Another measure of the smoothness of the speed (higher is smoother)", ""),
}


class LearningCurve(NamedTuple):
    """One measure over trials, its trend and its fitted curves."""

    n: Numbers  # (n,) trial numbers, from 1
    values: Numbers  # (n,)
    trend: Trend
    curves: tuple[Curve, ...]  # level line, exponential and power law, the one with the smallest AICc first

    @property
    def curve(self) -> Curve:
        """The best curve; its form is "level" where nothing was learnt."""
        return self.curves[0]

    @property
    def levels_off(self) -> bool:
        """Whether the constant's whole confidence interval is below the number of trials (false where it is NaN)."""
        return self.curve.form == "exponential" and self.curve.c_high <= self.n[-1]

    @property
    def constant(self) -> tuple[float, float, float] | None:
        """The learning constant tau in trials with its confidence interval, where there are trials enough for it."""
        if not self.levels_off or len(self.n) < MIN_TRIALS_FOR_CONSTANT or math.isnan(self.curve.c_low):
            return None
        return self.curve.c, self.curve.c_low, self.curve.c_high


def fit_learning_curve(n: Sequence[float], values: Sequence[float]) -> LearningCurve | None:
    """Fit one measure over trials; None with fewer than 8 trials.

    `n` are trial numbers from 1, rising; `values` (n,) are finite and below 1e100. The curves are compared by AICc,
    which prefers the level line unless a bent curve fits well enough for its additional parameters.
    """
    if len(values) < MIN_TRIALS:
        return None
    number = np.asarray(n, dtype=np.float64)
    series = np.asarray(values, dtype=np.float64)
    curves = [fit_level(series), fit_exponential(number, series), fit_power(number, series)]
    curves.sort(key=lambda curve: curve.aicc)
    return LearningCurve(number, series, mann_kendall(values), tuple(curves))


def learning_curves(
    trials: Sequence[Mapping[str, Any]], names: Iterable[str] = MEASURES, *, every_model: bool = False
) -> dict[str, dict[str, Any]]:
    """Return, for each measure that the trials have, sentences and the fitted curve, ready for JSON.

    Parameters
    ----------
    trials
        In the order driven; each has measures by name, and may have `number` (or `trial`), from 1, `session` (its
        number) and `reached`. A trial that did not reach the goal is left out: its distance, area and time are those
        of a part of the path.
    names
        The measures that are asked for; each takes some 10 ms.
    every_model
        Whether to return the curves that were not chosen, too.

    Returns
    -------
    {measure: {"text": str, "sessions": str or None, "fit": None or {"n": [...], "value": [...], "low": [...],
    "high": [...]}}}; the band is the 95 % band of the curve, and there is no fit where a level line is best. `sessions`
    compares the changes within sessions with those between sessions. With `every_model` also "form" ("exponential",
    "power", "level" or None) and "others": [{"form", "aicc_more", "n", "value", "low", "high"}], the better first.
    """
    curves: dict[str, dict[str, Any]] = {}
    for name in names:
        if not any(name in trial for trial in trials):
            continue
        measure = MEASURES[name]
        rows = [
            (float(trial.get("number", trial.get("trial", index))), float(trial[name]), trial.get("session"))
            for index, trial in enumerate(trials, start=1)
            if trial.get("reached", True) and trial.get(name) is not None and abs(trial[name]) < LARGEST
        ]
        rows.sort(key=lambda row: row[0])
        numbers, values = [row[0] for row in rows], [row[1] for row in rows]
        sessions = [row[2] for row in rows if row[2] is not None]
        learning = fit_learning_curve(numbers, values)
        curve = curves[name] = {"text": _too_few(len(rows)), "sessions": None, "fit": None}
        if learning is not None:
            in_unit = [value * measure.factor for value in values]
            kept = retention(sessions, in_unit) if len(sessions) == len(values) else None
            curve["text"] = describe(measure, learning)
            curve["sessions"] = kept and describe_retention(kept, measure.unit)
            curve["fit"] = None if learning.curve.form == "level" else _curve_document(learning.n, learning.curve)
        if every_model:
            curve["form"] = learning and learning.curve.form
            curve["others"] = [] if learning is None else _others(learning)
    return curves


def describe(measure: Measure, learning: LearningCurve) -> str:
    """Describe the trend and the curve of a measure in plain sentences."""
    count, trend = len(learning.n), learning.trend
    first, last = float(np.median(learning.values[:EDGE])), float(np.median(learning.values[-EDGE:]))
    p = "p < 0.001" if trend.p < 0.001 else f"p = {trend.p:.2g}"
    # A few unusual trials at an end may contradict the trend; the sentence must not.
    went = {("falls", True): "fell", ("rises", False): "rose"}.get((trend.direction, last < first), "went")
    change = (
        f"{measure.words} {went} from {_number(first, measure)} to {_number(last, measure)} "
        f"(medians of the first and the last {EDGE} of {count} trials; Mann-Kendall trend test: {p})."
    )
    if trend.direction == "none":
        change += " This is not a trend: it may be chance."
    else:
        change += _slope_in_words(measure, learning)
    few = f" {count} trials are few: the curve may yet change." if count < MIN_TRIALS_FOR_CONSTANT else ""
    return f"{change} {_shape_in_words(measure, learning)}{few}"


def _slope_in_words(measure: Measure, learning: LearningCurve) -> str:
    """Say how steep the trend is; nothing where the slope's interval contains 0, as for mostly equal counts."""
    slope = theil_sen(learning.n.tolist(), learning.values.tolist())
    if slope.low * slope.high <= 0:
        return ""
    least, most = sorted((abs(slope.low) * measure.factor, abs(slope.high) * measure.factor))
    step = _number(abs(slope.median), measure, digits=2)
    return (
        f" From trial to trial it {learning.trend.direction} by {step} in the median (95 %: {least:.2g} to {most:.2g})."
    )


def _too_few(count: int) -> str:
    return f"Not enough trials for a learning curve: {count} of at least {MIN_TRIALS} that reached the goal."


def _shape_in_words(measure: Measure, learning: LearningCurve) -> str:
    curve = learning.curve
    if curve.form == "level":
        return "No curve describes it better than a level line."
    if curve.form == "power":
        return "A power law describes it better than an exponential: large steps at first, then ever smaller ones."
    if not learning.levels_off:
        return "An exponential describes it best, and it has not levelled off within these trials."
    levels = f"An exponential describes it best, levelling off at {_number(curve.a, measure)}"
    if learning.constant is not None:
        tau, low, high = learning.constant
        return f"{levels}, with a learning constant of {tau:.1f} trials (95 %: {low:.1f} to {high:.1f})."
    if len(learning.n) < MIN_TRIALS_FOR_CONSTANT:
        return f"{levels}; how fast is told from {MIN_TRIALS_FOR_CONSTANT} trials on."
    return f"{levels} within the first trials."


def _curve_document(n: Numbers, curve: Curve) -> dict[str, list[float]]:
    return {"n": n.tolist(), "value": curve.value.tolist(), "low": curve.low.tolist(), "high": curve.high.tolist()}


def _others(learning: LearningCurve) -> list[dict[str, Any]]:
    best = learning.curve.aicc
    return [
        {"form": curve.form, "aicc_more": curve.aicc - best, **_curve_document(learning.n, curve)}
        for curve in learning.curves[1:]
    ]


def _number(value: float, measure: Measure, digits: int = 3) -> str:
    return f"{value * measure.factor:.{digits}g} {measure.unit}".rstrip()
