"""Runs (recordings) and trials."""

import math

from sqlalchemy import JSON, func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.registration import features
from app.json_values import JsonDocument, JsonValue
from app.refusals import Conflict
from app.scoring.interruptions import reason_to_ask
from app.source import UNKNOWN_SOURCE, Source
from app.store.access.visible_patients import WITH_DELETED, own_clinic_id
from app.store.own_rows import own_row
from app.store.tables import PatientSession, Run, Trial
from app.texts import Text


def add_run(db: Session, run_id: str, session_id: int, kind: str, folder: str, source: Source = UNKNOWN_SOURCE) -> Run:
    """Add a run that begins in `folder` (relative to the folder of all runs), with the source of its signals."""
    run = Run(
        id=run_id,
        session_id=session_id,
        kind=kind,
        folder=folder,
        started=utc_now(),
        ended=None,
        rows=None,
        dropped=None,
        **source.model_dump(),
    )
    db.add(run)
    db.flush()
    return run


def run_ids(db: Session, patient_id: int) -> list[str]:
    """Return the ids of all runs of a patient."""
    query = select(Run.id).join(PatientSession, PatientSession.id == Run.session_id)
    return list(db.scalars(query.where(PatientSession.patient_id == patient_id)))


def open_runs(db: Session) -> dict[str, str]:
    """Return the folders of the runs that have not ended, by their ids, also those of deleted patients."""
    query = select(Run.id, Run.folder).where(Run.ended.is_(None))
    return {run: folder for run, folder in db.execute(query, execution_options=WITH_DELETED)}  # noqa: C416  (typed rows)


def run_folders(db: Session) -> frozenset[str]:
    """Return the folders of all runs, also those of deleted patients."""
    return frozenset(db.scalars(select(Run.folder), execution_options=WITH_DELETED))


def close_run(db: Session, run_id: str, rows: int | None, dropped: int | None) -> None:
    """Store that a run has ended, with its counts; None when the control process could not report them."""
    run = db.get_one(Run, run_id)
    run.ended, run.rows, run.dropped = utc_now(), rows, dropped


def add_trial(
    db: Session,
    *,
    run: Run,
    patient_id: int,
    parameters_id: int,
    floorplan: str,
    floorplan_title: str,
    path: str,
    path_points: list[list[float]],
) -> Trial:
    """Add the patient's next trial on this path."""
    last = db.scalar(
        select(func.max(Trial.number)).where(
            Trial.patient_id == patient_id, Trial.floorplan == floorplan, Trial.path == path
        )
    )
    trial = Trial(
        clinic_id=own_clinic_id(db),
        patient_id=patient_id,
        session_id=run.session_id,
        parameters_id=parameters_id,
        run=run,
        number=(last or 0) + 1,
        floorplan=floorplan,
        floorplan_title=floorplan_title,
        path=path,
        path_points=path_points,
        started=utc_now(),
        status="running",
        end=None,
        kept=True,
        discard_reason=None,
        measures=None,
    )
    db.add(trial)
    db.flush()
    return trial


def finish_trial(db: Session, trial_id: int, end: str, measures: JsonDocument | None) -> Trial:
    """Store how a trial ended, and its measures; one that is not finite is stored as null.

    A trial that the machine interrupted too much is left out until a person keeps it.
    """
    trial = db.get_one(Trial, trial_id)
    trial.status, trial.end = "done", end
    trial.measures = None if measures is None else _storable_measures(measures)
    _ask_for(trial)
    return trial


def _ask_for(trial: Trial) -> None:
    reason = reason_to_ask(trial.measures or {})
    if trial.kept and reason is not None:
        trial.kept, trial.discard_reason = False, reason


def trials_of_older_measures(db: Session, version: int) -> dict[int, str]:
    """Return the finished trials whose measures are of an older version, the newest first, with their runs' folders."""
    stored_version = Trial.measures["measures_version"].as_integer()
    old = (Trial.status == "done", Trial.measures != JSON.NULL, stored_version < version)
    query = select(Trial.id, Run.folder).join(Run, Run.id == Trial.run_id).where(*old)
    return dict(db.execute(query.order_by(Trial.id.desc())).all())


def renew_measures(db: Session, trial_id: int, measures: JsonDocument) -> JsonDocument:
    """Store the measures of a trial that was measured again; return the figures that changed, as they were before.

    A trial of a signed session goes on counting, because a person has signed that it counts.
    """
    trial = db.get_one(Trial, trial_id)
    before, trial.measures = trial.measures or {}, _storable_measures(measures)
    if not _lock_reason(db, trial.session_id):
        _ask_for(trial)
    return {name: value for name, value in before.items() if _is_changed_figure(value, measures.get(name))}


def _is_changed_figure(before: object, now: object) -> bool:
    if not isinstance(before, int | float):
        return False
    return not (isinstance(now, int | float) and math.isclose(before, now, rel_tol=1e-6, abs_tol=1e-9))


def _storable_measures(measures: JsonDocument) -> JsonDocument:
    return {name: _storable(value) for name, value in measures.items()}


def _storable(value: JsonValue) -> JsonValue:
    """Return a value with null in place of every number that is not finite."""
    if isinstance(value, dict):
        return {name: _storable(inner) for name, inner in value.items()}
    if isinstance(value, list):
        return [_storable(inner) for inner in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def find_trial(db: Session, trial_id: int) -> Trial:
    """Return one of the clinic's trials."""
    return own_row(db, Trial, trial_id, Text("store-no-trial", trial=trial_id))


def trials_of(db: Session, patient_id: int, floorplan: str | None = None, path: str | None = None) -> list[Trial]:
    """Return a patient's trials, the newest last; of one path only when it is named."""
    query = select(Trial).where(Trial.patient_id == patient_id).order_by(Trial.id)
    if floorplan is not None:
        query = query.where(Trial.floorplan == floorplan)
    if path is not None:
        query = query.where(Trial.path == path)
    return list(db.scalars(query))


def keep_trial(db: Session, trial_id: int, discard_reason: Text | str | None) -> Trial:
    """Keep a trial, or discard it for a reason; its recording stays."""
    trial = find_trial(db, trial_id)
    if trial.status != "done":
        raise Conflict(Text("store-trial-running"))
    _require_unlocked(db, trial.session_id)
    trial.kept, trial.discard_reason = discard_reason is None, discard_reason
    return trial


def close_interrupted_trials(db: Session) -> list[Trial]:
    """End the trials that an ended web process left running; their recordings can still be read."""
    interrupted = list(db.scalars(select(Trial).where(Trial.status == "running")))
    for trial in interrupted:
        trial.status, trial.end = "done", "fault"
    return interrupted


def _lock_reason(db: Session, session_id: int) -> Text | None:
    """Return the sentence why nothing of a session may be changed, None when it may."""
    return next(filter(None, (feature.why_locked(db, session_id) for feature in features().values())), None)


def _require_unlocked(db: Session, session_id: int) -> None:
    """Raise Conflict when a session is locked: for functions that may also find that nothing changes."""
    if reason := _lock_reason(db, session_id):
        raise Conflict(reason)
