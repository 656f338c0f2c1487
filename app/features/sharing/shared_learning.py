"""The learning of one patient in each task, for the page of a share link: no figure of another patient is in it."""

from typing import Any

from app.api.parts import WebParts
from app.api.replay.trajectories import MOST_TRAJECTORIES, TrialLine
from app.features.sharing.attention import tasks_of
from app.quantities import Document
from app.scoring.learning import learning_curves
from app.scoring.measures import TRIAL_MEASURES, Word
from app.scoring.verdict.verdicts import task_verdicts
from app.session.clinic_spread import Task
from app.source import SourceGroup
from app.store.database import Database
from app.store.learning_trials import CountedTrial, counted_trials
from app.world.path_titles import path_title


class TaskLearning(Document):
    """Trials of one patient on one path with one kind of source."""

    floorplan_title: str
    path_name: str
    path_title: str  # its name where the floor plan has no such path any more
    source: SourceGroup
    trials: list[dict[str, Any]]
    curves: dict[str, Any]
    words: dict[str, Word]  # measure -> verdict word on the newest session against the one before
    path: list[tuple[float, float]]
    trajectories: list[TrialLine]


def learning_of(
    database: Database, web: WebParts, clinic_id: int, patient_id: int, session_id: int | None
) -> list[TaskLearning]:
    """Return what a patient drove, by task; with a session, its trials only, and verdicts up to it."""
    found = []
    with database.transaction() as db:
        tasks = tasks_of(db, clinic_id, patient_id)
        counted = {task: counted_trials(db, clinic_id, patient_id, task[0], task[1]) for task in tasks}
    for (floorplan, path, source), every in counted.items():
        trials = [one for one in every if one.group == source]
        shown = [one for one in trials if session_id is None or one.trial.session_id == session_id]
        if shown:
            until = [one for one in trials if one.session <= shown[-1].session]
            task = Task(clinic_id, floorplan, path, source)
            found.append(_learning(web, task, patient_id, shown, until))
    return found


def _learning(
    web: WebParts, task: Task, patient_id: int, shown: list[CountedTrial], until: list[CountedTrial]
) -> TaskLearning:
    rows = [one.row() for one in shown]
    clinic = web.spread.of_others(task, patient_id)
    compared = web.computing.ask(task_verdicts, [one.row() for one in until], clinic, ()).sessions
    verdicts = compared[0].verdicts if compared else {}
    words = {name: verdict.word for name, verdict in verdicts.items() if verdict.word != "number"}
    newest = [one.trial for one in shown[-MOST_TRAJECTORIES:]]
    return TaskLearning(
        floorplan_title=newest[-1].floorplan_title,
        path_name=task.path,
        path_title=path_title(web.own_floorplans, task.floorplan, task.path),
        source=task.group,
        trials=rows,
        curves=web.computing.ask(learning_curves, rows, tuple(TRIAL_MEASURES), clinic),
        words=words,
        path=[(x, y) for x, y in newest[-1].path_points],
        trajectories=web.trajectories.lines([(trial.number, web.runs.folder_of(trial.run_id)) for trial in newest]),
    )
