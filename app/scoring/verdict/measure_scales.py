"""The scales on which measures are compared, where their noise is even, and the trials in which they count."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.scoring.measures import TEST_MEASURES, TRIAL_MEASURES, Measure

Numbers = NDArray[np.float64]
Row = Mapping[str, Any]
"""A trial as it is compared: `id`, `number`, `session`, `familiarisation`, and its measures by name."""
Rows = Sequence[Row]

LARGEST = 1e100  # larger values are left out, as in a learning curve
SMALLEST = 1e-9  # on the log scale; smaller values count as this one
COUNT_SHIFT = 3 / 8  # Anscombe, Biometrika 35 (1948)
POISSON_SPREAD = 0.5  # of a count on its scale
MISSED_RANK = 0.9  # share of the trials before that reached the goal, which a trial that missed it is no better than
LEAST_SPREAD = 0.01  # of the level: nobody repeats a trial more closely; equal trials would make any change count


def measure_of(name: str) -> Measure:
    """Return the entry of a measure of a trial or of an interface test."""
    return TRIAL_MEASURES.get(name) or TEST_MEASURES[name]


def value_of(trial: Row, name: str) -> float | None:
    """Return a trial's measure where it counts; None where it was not measured or the goal was not reached."""
    value = trial.get(name)
    if value is None or not abs(value) < LARGEST:
        return None
    if TRIAL_MEASURES[name].needs_goal and not trial.get("reached", True):
        return None
    return float(value)


def measured_in(rows: Rows) -> list[str]:
    """Return the names of the measures that at least one of these trials has; no other one is known in any."""
    return [name for name in TRIAL_MEASURES if any(row.get(name) is not None for row in rows)]


def with_missed(name: str, values: Numbers, missed: NDArray[np.bool_]) -> Numbers:
    """Return values (n,) on their scale, those of trials that missed the goal replaced by a bound; NaN: none is known.

    How a trial would have ended that was not driven to its end is not known; a trial that missed the goal counts as no
    better than the worst tenth of the trials before it that reached it. Source of the rank: Lachin, Controlled Clinical
    Trials 20 (1999). `values` are in the order driven; those of missed trials are not used.
    """
    rank = MISSED_RANK if measure_of(name).better == "low" else 1.0 - MISSED_RANK
    bounded = values.copy()
    for place in np.flatnonzero(missed):
        before = values[:place][~missed[:place]]
        bounded[place] = np.quantile(before, rank) if len(before) else np.nan
    return bounded


def to_scale(name: str, values: Numbers) -> Numbers:
    """Return values (n,) on the scale on which their noise does not depend on their level."""
    scale = measure_of(name).scale
    if scale == "log":
        return np.log(np.maximum(values, SMALLEST))
    if scale == "root":
        return np.sqrt(np.maximum(values, 0.0))
    if scale == "count":
        return np.sqrt(np.maximum(values, 0.0) + COUNT_SHIFT)
    return values


def from_scale(name: str, value: float) -> float:
    """Return a value of the scale in the unit of the measure."""
    scale = measure_of(name).scale
    if scale == "log":
        return float(np.exp(min(value, np.log(LARGEST))))
    if scale == "root":
        return max(value, 0.0) ** 2
    if scale == "count":
        return max(max(value, 0.0) ** 2 - COUNT_SHIFT, 0.0)
    return value


def least_spread(name: str, scaled: Numbers) -> float:
    """Return the smallest spread between trials that is believed, on the measure's scale."""
    scale = measure_of(name).scale
    if scale == "count":
        return POISSON_SPREAD
    if scale == "log":
        return LEAST_SPREAD
    return LEAST_SPREAD * float(np.median(np.abs(scaled)))
