"""The three measures that lead in a task: they alone carry a verdict, so that few words are wrong by chance."""

from typing import Final

from app.scoring.measures import LEADING, TRIAL_MEASURES
from app.scoring.verdict.measure_scales import Row, Rows

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
