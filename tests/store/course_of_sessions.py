"""Stores a course of sessions with measured trials, without recordings, as if they were driven on earlier days."""

from collections.abc import Sequence
from datetime import timedelta
from typing import Any

from sqlalchemy.orm import Session

from app.clock import utc_now
from app.source import Source
from app.store.parameters import current_parameters, save_parameters, save_profile
from app.store.runs import add_run, add_trial, finish_trial
from app.store.tables import PatientSession
from app.world.floorplan import FloorPlan
from building import make_parameters

SIMULATED = Source(shirt="simulator", body="person", chair="virtual", simulated=True)


def store_course(
    db: Session,
    clinic_id: int,
    patient_id: int,
    plan: FloorPlan,
    sessions: Sequence[Sequence[dict[str, Any]]],
    source: Source = SIMULATED,
) -> list[int]:
    """Store the trials of each session by their measures on the first path of `plan`; return their ids.

    The last session was a day ago, each one before it a week earlier.
    """
    parameters, path = make_parameters(), plan.paths[0]
    ids: list[int] = []
    for place, trials in enumerate(sessions):
        morning = utc_now().astimezone().replace(hour=9, minute=0)
        day = morning - timedelta(days=1 + 7 * (len(sessions) - 1 - place))
        session = PatientSession(
            clinic_id=clinic_id, patient_id=patient_id, number=place + 1, started=day, ended=day, accepted=True
        )
        db.add(session)
        db.flush()
        if place == 0:
            save_parameters(db, save_profile(db, patient_id, session.id, parameters.profile), parameters)
        row, _ = current_parameters(db, patient_id)
        for measures in trials:
            run = f"course-{patient_id}-{len(ids)}"
            trial = add_trial(
                db,
                run=add_run(db, run, session.id, "drive", run, source),
                patient_id=patient_id,
                parameters_id=row.id,
                floorplan=plan.name,
                floorplan_title=plan.title,
                path=path.name,
                path_points=[[x, y] for x, y in path.points],
            )
            trial.started = day + timedelta(minutes=2 * len(ids))
            finish_trial(db, trial.id, "goal" if measures["reached"] else "time-out", measures)
            ids.append(trial.id)
    return ids
