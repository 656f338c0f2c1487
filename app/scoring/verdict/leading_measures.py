"""The three measures that lead in a task: they alone carry a verdict, so that few words are wrong by chance."""

from collections.abc import Mapping, Sequence
from typing import Any, Final

from app.scoring.verdict.measure_comparison import COMPARISONS

MOST_LEADING: Final = 3

# What leads, by what a trial has: the first whose named measures are all there. The pages lead with the same.
LEADING: Final[tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]] = (
    (("stages_done",), ("stages_done", "time", "collisions")),
    (("heading_error_deg",), ("heading_error_deg", "turn_drift", "time")),
    (("follow_error_rms",), ("follow_error_rms", "follow_near", "e_diff")),
    (("gaps", "gap_clearance"), ("gap_clearance", "e_diff", "time")),
    (("cones_touched",), ("cones_touched", "e_diff", "time")),
    ((), ("e_diff", "dist", "time")),
)
LEADING_OF_TESTS: Final = ("acquisitions_per_minute", "first_entry", "throughput")


def leading_measures(trial: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the three measures that say most about a task, by what a trial of it has.

    Of a trial with none of them, the first three that can be compared.
    """
    names = next(large for has, large in LEADING if all(trial.get(name) is not None for name in has))
    found = tuple(name for name in names if trial.get(name) is not None)
    others = (name for name, one in COMPARISONS.items() if one.better is not None and trial.get(name) is not None)
    return found or tuple(others)[:MOST_LEADING]


def leading_of_task(trials: Sequence[Mapping[str, Any]]) -> tuple[str, ...]:
    """Return what leads in a task, by all that one of its trials has: a trial that missed the goal may lack some."""
    return leading_measures({name: value for trial in trials for name, value in trial.items() if value is not None})
