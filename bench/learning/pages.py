"""Checks all words of a page on many simulated people: three leading measures, reaching, the trend, a deterioration.

`python -m bench.learning.verdicts` prints its tables. The measures of a simulated person are independent of each other:
so most words are wrong by chance.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.scoring.verdict.course import course_change
from app.scoring.verdict.deterioration import deteriorations
from app.scoring.verdict.leading_measures import leading_of_task
from app.scoring.verdict.spread import Spread
from app.scoring.verdict.verdicts import task_verdicts

Numbers = NDArray[np.float64]
Row = dict[str, Any]
LEADING = ("e_diff", "dist", "time")
OTHERS = ("dist_ratio", "cross_track_rms", "cross_track_max", "pulses_per_metre", "follow_error_max", "contact_time")


class Course(NamedTuple):
    """What happens to simulated people."""

    layout: Sequence[int]  # trials of each session
    change: Callable[[int, int], float] = lambda _session, _number: 0.0  # of the logarithm of every measure
    limit: float = math.inf  # of the area over its level: above it the trial misses the goal
    missed: Callable[[int], float] = lambda _session: 0.0  # probability of a miss for another reason
    changed: tuple[str, ...] = LEADING  # the measures that change
    correlation: float = 0.0  # of the noise of a trial with that of the one before


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
    for name in names:
        noise = correlated(rng, len(session), course.correlation)
        value = sizes[0] * rng.normal(0.0, 1.0, len(course.layout))[session - 1] + sizes[1] * noise
        value += change if name in course.changed else 0.0
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


def words_on_page(rows: list[Row], clinic: dict[str, Spread]) -> set[str]:
    """Return what a page says of these trials that is more than noise."""
    found = task_verdicts(rows, clinic)
    said = {
        f"session {name} {one.word}"
        for pair in found.sessions
        for name, one in pair.verdicts.items()
        if one.word in ("better", "worse")
    }
    return said | {f"deterioration {name}" for name in found.deterioration}


def alarm_at(rows: list[Row], clinic: dict[str, Spread]) -> tuple[bool, bool]:
    """Return whether a deterioration is told after any session, and after the last one."""
    sessions = sorted({row["session"] for row in rows})
    found = [bool(deteriorations([row for row in rows if row["session"] <= one], clinic)) for one in sessions]
    return any(found), found[-1]


def trend_words(rows: list[Row], clinic: dict[str, Spread]) -> set[str]:
    """Return in which measures the sentence on all sessions says more than noise."""
    leading = leading_of_task(rows)
    words = {name: course_change(name, rows, leading, clinic).word for name in leading}
    return {f"course {name} {word}" for name, word in words.items() if word in ("better", "worse")}
