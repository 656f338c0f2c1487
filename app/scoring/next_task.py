"""The task that is proposed to a patient: the last one again, or its next level when the last trials went well."""

from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import Literal, NamedTuple

from app.scoring.measures import MeasureValues
from app.scoring.verdict.measure_scales import Rows
from app.scoring.verdict.measure_verdict import ClinicSpreads, compare, series_of
from app.source import SourceGroup
from app.world.scene import DrivingPlace

FIRST = ("clinic", "main")
"""Floor plan and path of the corridors of the published study: the first task of a new patient."""

TRIALS = 3  # in succession must have gone well before a harder task is proposed

Reason = Literal["first", "again", "next level"]


class DrivenTask(NamedTuple):
    """A trial that is over."""

    floorplan: str
    path: str
    group: SourceGroup
    counts: bool  # it was not discarded
    went_well: bool


class NextTask(NamedTuple):
    """A proposed task, and why it is proposed."""

    floorplan: str
    path: str
    reason: Reason


def went_well(end: str | None, measures: MeasureValues | None) -> bool:
    """Return whether a trial reached its goal, the task done to its end, without any contact."""
    return end == "goal" and measures is not None and bool(measures.get("reached")) and measures.get("collisions") == 0


def is_worse_than_noise(rows: Rows, clinic: ClinicSpreads) -> bool:
    """Return whether one of the newest trials is worse than noise against the one before it that is compared.

    The measure is the area off the path, or the time of a task without one. Trials for getting used to the task have no
    verdict, and neither have trials of which there are too few: then nothing is worse. `rows` and `clinic` as for
    `trial_verdicts`.
    """
    newest = {row["id"] for row in rows[-TRIALS:]}
    for name in ("e_diff", "time"):
        series, ids = series_of(rows, name)
        if len(ids):
            pairs = [(before, after) for before, after in pairwise(ids) if int(after) in newest]
            verdicts = [compare(name, series, ids == before, ids == after, clinic.get(name)) for before, after in pairs]
            return any(verdict is not None and verdict.word == "worse" for verdict in verdicts)
    return False


def next_task(
    trials: Sequence[DrivenTask],
    group: SourceGroup,
    places: Mapping[str, DrivingPlace],
    is_worse: Callable[[str, str], bool],
) -> NextTask:
    """Return the task to propose.

    Parameters
    ----------
    trials : sequence of DrivenTask
        The patient's trials that are over, the newest last.
    group : SourceGroup
        Only trials of this group count for the next level: what a simulated person can do says nothing of a patient.
    places : mapping of str to DrivingPlace
        All places that are offered, by the name of the floor plan: a scene's easiest level first.
    is_worse : callable
        Called with floor plan and path before a next level is proposed: whether the newest trials there are worse than
        this person's noise.
    """
    last = next((trial for trial in reversed(trials) if _is_offered(trial, places)), None)
    if last is None:
        return NextTask(*FIRST, "first")
    counted = [
        trial
        for trial in trials
        if trial.counts and trial.group == group and (trial.floorplan, trial.path) == (last.floorplan, last.path)
    ]
    newest = counted[-TRIALS:]
    if len(newest) == TRIALS and all(trial.went_well for trial in newest):
        harder = _next_level(last, places)
        if harder is not None and not is_worse(last.floorplan, last.path):
            return NextTask(harder, last.path, "next level")
    return NextTask(last.floorplan, last.path, "again")


def _is_offered(trial: DrivenTask, places: Mapping[str, DrivingPlace]) -> bool:
    return trial.floorplan in places and _has_path(places[trial.floorplan], trial.path)


def _has_path(place: DrivingPlace, name: str) -> bool:
    return any(path.name == name for path in place.plan.paths)


def _next_level(last: DrivenTask, places: Mapping[str, DrivingPlace]) -> str | None:
    """Return the floor plan of the next harder level of the same scene with the same path; None when there is none."""
    scene = places[last.floorplan].scene
    if scene is None:
        return None
    levels = [name for name, place in places.items() if place.scene is not None and place.scene.name == scene.name]
    harder = levels[levels.index(last.floorplan) + 1 :]
    return next((name for name in harder if _has_path(places[name], last.path)), None)
