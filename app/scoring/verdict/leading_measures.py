"""The measures that lead in a task or a two-minute test: only they carry a verdict, so that few are wrong by chance."""

from typing import Final

from app.scoring.measures import TRIAL_MEASURES
from app.scoring.verdict.measure_scales import Row, Rows

LEADING: Final[tuple[tuple[tuple[str, ...], tuple[str, ...]], ...]] = (
    (("stages_done",), ("stages_done", "time", "collisions")),
    (("heading_error_deg",), ("heading_error_deg", "turn_drift", "time")),
    (("follow_error_rms",), ("follow_error_rms", "follow_near", "e_diff")),
    (("gaps", "gap_clearance"), ("gap_clearance", "e_diff", "time")),  # of a task with gaps, not at every door
    (("cones_touched",), ("cones_touched", "e_diff", "time")),
    ((), ("e_diff", "dist", "time")),
)
"""The measures that lead in a task, by what its trials have: the first row whose named measures are all there."""

LEADING_OF_TESTS: Final = ("acquisitions_per_minute", "throughput", "first_entry")

MOST_LEADING: Final = 3


def leading_measures(trial: Row) -> tuple[str, ...]:
    """Return the three measures that say most about a task, by what a trial of it has.

    Of a trial with none of them, the first three that can be compared.
    """
    names = next(leading for required, leading in LEADING if all(trial.get(name) is not None for name in required))
    measured = tuple(name for name in names if trial.get(name) is not None)
    others = (
        name for name, measure in TRIAL_MEASURES.items() if measure.better is not None and trial.get(name) is not None
    )
    return measured or tuple(others)[:MOST_LEADING]


def leading_of_task(trials: Rows) -> tuple[str, ...]:
    """Return what leads in a task, by all that one of its trials has: a trial that missed the goal may lack some."""
    return leading_measures({name: value for trial in trials for name, value in trial.items() if value is not None})
