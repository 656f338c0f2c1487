"""The measures of an interface test: how quickly and how straight a person reaches targets with a cursor.

Throughput follows ISO 9241-411 with the effective width: the spread of where the cursor ends says how exactly the
person aimed, whatever the size of the target that was drawn.
"""

import math
from collections import defaultdict
from collections.abc import Sequence
from statistics import fmean, stdev
from typing import Annotated, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field, StrictBool

from app.quantities import Count, Document
from app.world.cursor_task import Attempt, CursorPlan, CursorTask

SPREAD_TO_WIDTH = 4.133  # the width that holds 96 % of normally distributed ends, over their standard deviation
FEWEST_ENDS = 8  # acquired targets, below which their spread is not known well enough for a throughput

Amount = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e12)]
Way = Literal["ahead", "back", "left", "right"]
DIRECTION_NAMES: dict[tuple[float, float], Way] = {
    (1.0, 0.0): "ahead",
    (-1.0, 0.0): "back",
    (0.0, 1.0): "left",
    (0.0, -1.0): "right",
}


class DirectionMeasures(Document):
    """What happened on the ways in one direction."""

    acquired: Count
    missed: Count
    movement_time: Amount | None  # s, mean over the acquired targets


class InterfaceMeasures(Document):
    """The measures of one interface test; means are over the acquired targets, None where there are too few."""

    duration: Amount  # s from the first target to the end
    complete: StrictBool  # whether it ran for as long as was planned
    acquired: Count
    missed: Count
    acquisitions_per_minute: Amount | None
    first_entry: Amount | None  # s from the appearance of a target until the cursor is in it for the first time
    dial_in: Amount | None  # s from the first entry to the last one
    entries: Amount | None  # per acquired target; 1 means that no target was left again
    path_efficiency: Amount | None  # 0..1, straight way over the way of the cursor
    effective_width: Amount | None  # arms of the cross
    throughput: Amount | None  # bit/s
    directions: dict[Way, DirectionMeasures]  # ahead, back, left, right: of the way to the target


class Ways(NamedTuple):
    """Ways to the targets at one distance."""

    distance: float  # mean way along the line from target to target, of the acquired targets, arms
    time: float  # s, mean of all targets; a missed one counts with the time after which it was given up


def index_of_difficulty(distance: float, width: float) -> float:
    """Return log2(distance / width + 1) in bit; distance >= 0 and width > 0 in the same unit."""
    return math.log2(distance / width + 1.0)


def effective_width(errors: Sequence[float]) -> float | None:
    """Return 4.133 times the standard deviation of the ends along their ways; None for fewer than 8, or no spread."""
    if len(errors) < FEWEST_ENDS:
        return None
    spread = stdev(errors)
    return SPREAD_TO_WIDTH * spread if spread > 0.0 else None


def throughput(ways: Sequence[Ways], width: float) -> float | None:
    """Return the mean over the distances of effective index of difficulty over time, in bit/s; None without ways."""
    rates = [index_of_difficulty(max(0.0, way.distance), width) / way.time for way in ways if way.time > 0.0]
    return fmean(rates) if rates else None


def path_efficiency(attempt: Attempt) -> float:
    """Return the straight way from where the cursor began to its last entry, over the way it took; 0 to 1."""
    straight = math.dist(attempt.start, attempt.entry)
    return min(1.0, straight / attempt.way) if attempt.way > 0.0 else 1.0


def replay_task(plan: CursorPlan, run_t: ArrayLike, u1: ArrayLike, u2: ArrayLike) -> CursorTask:
    """Return the task after all ticks of a run, as it was while the run was recorded.

    Parameters
    ----------
    plan
        What was asked.
    run_t
        (n,) s since the start of the run, rising.
    u1, u2
        (n,) controls, -1..1.
    """
    task = CursorTask(plan)
    columns = (np.asarray(column, dtype=np.float64).tolist() for column in (run_t, u1, u2))
    for row in zip(*columns, strict=True):
        task.step(*row)
    return task


def interface_measures(task: CursorTask) -> InterfaceMeasures:
    """Return the measures of a test from its task, which has taken all ticks."""
    plan, attempts = task.plan, task.attempts
    acquired = [attempt for attempt in attempts if attempt.acquired]
    duration = 0.0 if task.phase == "ready" else plan.duration - task.remaining
    errors = [_along(attempt, _middle(attempt)) for attempt in acquired]
    width = effective_width(errors)
    return InterfaceMeasures(
        duration=duration,
        complete=task.phase == "over",
        acquired=len(acquired),
        missed=len(attempts) - len(acquired),
        acquisitions_per_minute=60.0 * len(acquired) / duration if duration > 0.0 else None,
        first_entry=_mean([attempt.first_entry or 0.0 for attempt in acquired]),
        dial_in=_mean([(attempt.last_entry or 0.0) - (attempt.first_entry or 0.0) for attempt in acquired]),
        entries=_mean([attempt.entries for attempt in acquired]),
        path_efficiency=_mean([path_efficiency(attempt) for attempt in acquired]),
        effective_width=width,
        throughput=None if width is None else throughput(_ways(attempts, plan.time_limit), width),
        directions={direction: _direction(attempts, vector) for vector, direction in DIRECTION_NAMES.items()},
    )


def _middle(attempt: Attempt) -> tuple[float, float]:
    return attempt.target.ahead, attempt.target.left


def _along(attempt: Attempt, origin: tuple[float, float]) -> float:
    """Return how far the cursor ended from `origin` along the line from target to target, beyond it positive."""
    ahead, left = attempt.target.direction
    return (attempt.end[0] - origin[0]) * ahead + (attempt.end[1] - origin[1]) * left


def _ways(attempts: Sequence[Attempt], time_limit: float) -> list[Ways]:
    """Return the ways at each distance; where no target was acquired the distance is 0, and so is the throughput."""
    groups: dict[float, list[Attempt]] = defaultdict(list)
    for attempt in attempts:
        groups[attempt.target.distance].append(attempt)
    return [
        Ways(
            _mean([_along(attempt, attempt.start) for attempt in group if attempt.acquired]) or 0.0,
            fmean((attempt.last_entry or 0.0) if attempt.acquired else time_limit for attempt in group),
        )
        for _, group in sorted(groups.items())
    ]


def _direction(attempts: Sequence[Attempt], vector: tuple[float, float]) -> DirectionMeasures:
    chosen = [attempt for attempt in attempts if attempt.target.direction == vector]
    times = [attempt.last_entry or 0.0 for attempt in chosen if attempt.acquired]
    return DirectionMeasures(acquired=len(times), missed=len(chosen) - len(times), movement_time=_mean(times))


def _mean(values: Sequence[float]) -> float | None:
    return fmean(values) if values else None
