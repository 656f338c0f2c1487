"""Retention: the change of a measure within sessions, compared with its change from one session to the next."""

import math
from collections.abc import Sequence
from itertools import groupby, pairwise
from typing import NamedTuple

import numpy as np

EDGE = 2  # trials at either end of a session whose mean is its start and its end
MIN_TRIALS = 2 * EDGE  # of a session; with fewer, its start and its end would share trials
CONFIDENCE = 0.99  # six intervals of three measures stand side by side: together 5 % are wrong
MIN_SESSIONS = 4  # with fewer, the interval of the mean change between sessions is too wide


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
        enough = len(series) >= MIN_TRIALS
        ends.append((float(np.mean(series[:EDGE])), float(np.mean(series[-EDGE:]))) if enough else None)
    if sum(end is not None for end in ends) < MIN_SESSIONS:
        return None
    within = [end[1] - end[0] for end in ends if end]
    between = [after[0] - before[1] for before, after in pairwise(ends) if before and after]
    return Retention(_mean(within), _mean(between)) if len(between) >= MIN_SESSIONS - 1 else None


def _mean(changes: Sequence[float]) -> MeanChange:
    from scipy.special import stdtrit

    mean, count = float(np.mean(changes)), len(changes)
    half = float(stdtrit(count - 1, (1 + CONFIDENCE) / 2) * np.std(changes, ddof=1)) / math.sqrt(count)
    return MeanChange(mean, mean - half, mean + half, count)
