"""The learning curves of a patient, and what is better than noise."""

from collections import Counter
from typing import Annotated, Any

from fastapi import APIRouter, Query
from pydantic import AfterValidator

from app.api.deps import Anyone, ComputingPart, Db, RowId, RunsPart, SpreadPart, TrajectoriesPart
from app.api.replay.trajectories import MOST_TRAJECTORIES, TrialLine
from app.api.routes.source_view import RequestedGroup
from app.api.sign_in.identity import SignedInPerson
from app.quantities import Document
from app.refusals import Conflict
from app.scoring.learning import learning_curves
from app.scoring.measures import TRIAL_MEASURES
from app.scoring.verdict.verdicts import TaskVerdicts, TrialVerdicts, task_verdicts, trial_verdicts
from app.session.clinic_spread import Task
from app.source import SourceGroup
from app.store.database import Database
from app.store.learning_trials import CountedTrial, counted_trials
from app.store.log import log_viewing
from app.store.patients import find_patient
from app.store.runs import find_trial
from app.store.tables import Trial
from app.texts import Text

router = APIRouter(tags=["review"])

PlaceName = Annotated[str, Query(max_length=64)]


def _known_measure(name: str) -> str:
    if name not in TRIAL_MEASURES:
        raise ValueError(Text("api-no-measure", measures=", ".join(TRIAL_MEASURES)))
    return name


class LearningView(Document):
    """Kept trials of one source on one path over all sessions, with learning curves."""

    source: SourceGroup  # of all that is shown; trials of another one are in no curve with these
    others: dict[SourceGroup, int]  # how many kept trials there are of the other sources
    trials: list[dict[str, Any]]
    curves: dict[str, Any]
    verdicts: TaskVerdicts


class TrajectoriesView(Document):
    """The trajectories of the newest kept trials of one source on one path, and the path as it was driven last."""

    trajectories: list[TrialLine]
    path: list[tuple[float, float]]


@router.get("/patients/{patient_id}/learning")
def learning(
    patient_id: RowId,
    floorplan: PlaceName,
    path: PlaceName,
    source: RequestedGroup,
    person: Anyone,
    *,
    database: Db,
    computing: ComputingPart,
    spread: SpreadPart,
    measure: Annotated[str | None, AfterValidator(_known_measure)] = None,
) -> LearningView:
    """Return the learning curve of a patient on one path; curves and deterioration in one measure or in every one."""
    every = _counted(database, person, patient_id, floorplan, path)
    clinic = spread.of_others(Task(floorplan, path, source), patient_id)
    counted = [trial for trial in every if trial.group == source]
    rows = [trial.row() for trial in counted]
    names = list(TRIAL_MEASURES) if measure is None else [measure]
    return LearningView(
        source=source,
        others=dict(Counter(trial.group for trial in every if trial.group != source)),
        trials=[{**row, "started": trial.trial.started.isoformat()} for row, trial in zip(rows, counted, strict=True)],
        curves=computing.ask(learning_curves, rows, names, clinic, every_model=True),
        verdicts=computing.ask(task_verdicts, rows, clinic, names),
    )


@router.get("/patients/{patient_id}/trajectories")
def trajectories(
    patient_id: RowId,
    floorplan: PlaceName,
    path: PlaceName,
    source: RequestedGroup,
    person: Anyone,
    database: Db,
    runs: RunsPart,
    trajectories: TrajectoriesPart,
) -> TrajectoriesView:
    """Return the newest trajectories of a patient on one path; recordings that were not read before take a moment.

    Of the newest 30 kept trials.
    """
    every = _counted(database, person, patient_id, floorplan, path)
    newest = [counted_trial.trial for counted_trial in every if counted_trial.group == source][-MOST_TRAJECTORIES:]
    return TrajectoriesView(
        trajectories=trajectories.lines([(trial.number, runs.folder_of(trial.run_id)) for trial in newest]),
        path=[(x, y) for x, y in newest[-1].path_points] if newest else [],
    )


def _counted(
    database: Database, person: SignedInPerson, patient_id: int, floorplan: str, path: str
) -> list[CountedTrial]:
    """Return the kept trials of a patient on one path, and log who views them."""
    with database.transaction(closing=True) as db:
        find_patient(db, patient_id)
        trials = counted_trials(db, patient_id, floorplan, path)
        log_viewing(db, person.name, patient_id)
    return trials


@router.get("/trials/{trial_id}/verdicts")
def verdicts_of_trial(
    trial_id: RowId,
    person: Anyone,
    database: Db,
    computing: ComputingPart,
    spread: SpreadPart,
    against: Annotated[int | None, Query(ge=1, le=2**31)] = None,
) -> TrialVerdicts:
    """Tell in which measures a trial is better than noise against another one; by default the one before that counts.

    409 when the two are not of one patient, task and source.

    `best`: of the compared trials before it; `familiarisation`: those of the two that are among the first three. The
    word `number`: a measure that does not lead in the task, without word and band.
    """
    with database.transaction() as db:
        trial = find_trial(db, trial_id)
        other = trial if against is None else find_trial(db, against)
        if _task_of(trial) != _task_of(other):
            raise Conflict(Text("api-trials-not-comparable"))
        log_viewing(db, person.name, trial.patient_id)
        counted = counted_trials(db, trial.patient_id, trial.floorplan, trial.path)
    group = trial.run.source.group
    clinic = spread.of_others(Task(trial.floorplan, trial.path, group), trial.patient_id)
    rows = [counted_trial.row() for counted_trial in counted if counted_trial.group == group]
    return computing.ask(trial_verdicts, rows, clinic, trial_id, against)


def _task_of(trial: Trial) -> tuple[int, str, str, SourceGroup]:
    return trial.patient_id, trial.floorplan, trial.path, trial.run.source.group
