"""Trials of simulated people over sessions, for the checks of verdicts (`python -m bench.learning.verdicts`).

The measures of a person are independent of each other: so most words are wrong by chance.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.scoring.verdict.leading_measures import LEADING as LEADING_OF_TASKS

Numbers = NDArray[np.float64]
Row = dict[str, Any]
LEADING = LEADING_OF_TASKS[-1][1]  # along a path


class Course(NamedTuple):
    """What happens to simulated people."""

    layout: Sequence[int]  # trials of each session
    change: Callable[[int, int], float] = lambda _session, _number: 0.0  # of the logarithm of every measure
    limit: float = math.inf  # of the area over its level: above it the trial misses the goal
    missed: Callable[[int], float] = lambda _session: 0.0  # probability of a miss for another reason
    correlation: float = 0.0  # of the noise of a trial with that of the one before, also over a pause
    changes: int | None = None  # how many measures change, the first ones; None: all


def trials(rng: np.random.Generator, within: float, between: float, course: Course, names: Sequence[str]) -> list[Row]:
    """Return the trials of a person, whose noise multiplies every measure; level 1."""
    session = np.repeat(np.arange(1, len(course.layout) + 1), course.layout)
    number = np.arange(1, len(session) + 1)
    change = np.array([course.change(int(s), int(n)) for s, n in zip(session, number, strict=True)])
    sizes = [math.sqrt(math.log1p(part**2)) for part in (between, within)]
    rows: list[Row] = [
        {"id": int(n), "number": int(n), "session": int(s), "familiarisation": False, "reached": True}
        for s, n in zip(session, number, strict=True)
    ]
    for place, name in enumerate(names):
        noise = correlated(rng, len(session), course.correlation)
        value = sizes[0] * rng.normal(0.0, 1.0, len(course.layout))[session - 1] + sizes[1] * noise
        value += change * (course.changes is None or place < course.changes)
        for row, one in zip(rows, value, strict=True):
            row[name] = math.exp(one)
    for row in rows:
        row["reached"] = bool(row[names[0]] <= course.limit and rng.random() >= course.missed(row["session"]))
    return rows


def correlated(rng: np.random.Generator, count: int, correlation: float) -> Numbers:
    """Return noise (count,) of variance 1 in which each value is correlated with the one before."""
    noise = rng.normal(0.0, 1.0, count)
    for place in range(1, count):
        noise[place] = correlation * noise[place - 1] + math.sqrt(1 - correlation**2) * noise[place]
    return noise
