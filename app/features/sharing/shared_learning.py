"""The learning of one patient in each task, for the page of a share link: no figure of another patient is in it."""

from dataclasses import dataclass
from typing import Annotated, Any

from fastapi import Depends

from app.api.driving.clinic_places import ClinicPlaces
from app.api.parts import parts_for
from app.api.replay.trajectories import MOST_TRAJECTORIES, Trajectories, TrialLine
from app.computing_process import ComputingProcess
from app.features.sharing.attention import tasks_of
from app.quantities import Document
from app.scoring.learning import learning_curves
from app.scoring.measures import TRIAL_MEASURES, Word
from app.scoring.verdict.verdicts import task_verdicts
from app.session.clinic_spread import ClinicSpread, Task
from app.session.runs import SessionRuns
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


@dataclass(frozen=True, slots=True)
class SharedLearning:
    """What the page of a share link says about the learning of its patient."""

    database: Database
    computing: ComputingProcess
    runs: SessionRuns
    trajectories: Trajectories
    spread: ClinicSpread
    places: ClinicPlaces

    def of_patient(self, clinic_id: int, patient_id: int, session_id: int | None) -> list[TaskLearning]:
        """Return what a patient drove, by task; with a session, its trials only, and verdicts up to it."""
        found = []
        with self.database.transaction() as db:
            tasks = tasks_of(db, clinic_id, patient_id)
            counted = {task: counted_trials(db, clinic_id, patient_id, task[0], task[1]) for task in tasks}
        for (floorplan, path, source), every in counted.items():
            trials = [one for one in every if one.group == source]
            shown = [one for one in trials if session_id is None or one.trial.session_id == session_id]
            if shown:
                until = [one for one in trials if one.session <= shown[-1].session]
                found.append(self._of_task(Task(clinic_id, floorplan, path, source), patient_id, shown, until))
        return found

    def _of_task(
        self, task: Task, patient_id: int, shown: list[CountedTrial], until: list[CountedTrial]
    ) -> TaskLearning:
        rows = [one.row() for one in shown]
        clinic = self.spread.of_others(task, patient_id)
        compared = self.computing.ask(task_verdicts, [one.row() for one in until], clinic, ()).sessions
        verdicts = compared[0].verdicts if compared else {}
        newest = [one.trial for one in shown[-MOST_TRAJECTORIES:]]
        recordings = [(trial.number, self.runs.folder_of(trial.run_id)) for trial in newest]
        return TaskLearning(
            floorplan_title=newest[-1].floorplan_title,
            path_name=task.path,
            path_title=path_title(self.places.own, task.floorplan, task.path),
            source=task.group,
            trials=rows,
            curves=self.computing.ask(learning_curves, rows, tuple(TRIAL_MEASURES), clinic),
            words={name: verdict.word for name, verdict in verdicts.items() if verdict.word != "number"},
            path=[(x, y) for x, y in newest[-1].path_points],
            trajectories=self.trajectories.lines(recordings),
        )


Learning = Annotated[SharedLearning, Depends(parts_for(SharedLearning))]
