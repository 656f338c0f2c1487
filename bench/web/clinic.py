"""Clinics with trials for a benchmark."""

import math
from pathlib import Path

from sqlalchemy import select

from app.cli.serve import furnish
from app.clock import utc_now
from app.features.consents.service import give_consent
from app.settings import Settings, data_folder
from app.source import STUDY_SOURCE, Source
from app.store.access.sign_ins import sign_in
from app.store.database import Database
from app.store.parameters import current_parameters
from app.store.patients import end_session, open_session
from app.store.people import add_person, the_clinic
from app.store.runs import add_run, add_trial, finish_trial
from app.store.tables import Trial
from app.world.floorplan import load_floorplan
from bench.course import PLAN, store_course

TRIALS = 22  # as in the paper
SESSIONS = 10  # of a course
REVIEWED, REVIEWED_SECONDS = 3, 300.0  # sessions; s of each of their recordings: 21 in all, and 16 are cached
SIMULATED = Source(shirt="simulator", body="person", chair="virtual", simulated=True)


def furnish_clinic(state: Path) -> list[str]:
    """Make a clinic whose patient drove trials; return the token of a sign-in, and pages that need large libraries."""
    plan = load_floorplan(data_folder() / "floorplans" / "apartment.json")
    path = plan.paths[0]
    database = Database(Settings(state=state).database)
    furnish(database)
    with database.transaction() as db:
        clinic = the_clinic(db)
        session = None if clinic is None else open_session(db)
        if clinic is None or session is None:
            raise RuntimeError("the clinic of the benchmark was not made")
        parameters, _ = current_parameters(db, session.patient_id)
        for number in range(TRIALS):
            run = f"run-{number}"
            trial = add_trial(
                db,
                run=add_run(db, run, session.id, "drive", run, SIMULATED),
                patient_id=session.patient_id,
                parameters_id=parameters.id,
                floorplan=plan.name,
                floorplan_title=plan.title,
                path=path.name,
                path_points=[[x, y] for x, y in path.points],
            )
            measures = {"reached": True, "e_diff": 1.0 + math.exp(-number / 5), "time": 60.0 - number}
            finish_trial(db, trial.id, "goal", measures)
        end_session(db)
        token = sign_in(db, add_person(db, clinic, "Ada", "owner", None), "bench")
    database.close()
    learning = f"learning?floorplan={plan.name}&path={path.name}&source={SIMULATED.group}"
    return [token, f"/patients/{session.patient_id}/{learning}"]


def furnish_course(state: Path) -> list[str]:
    """Make a clinic with a course of 10 sessions; return the token of a sign-in, a report, an export and a review."""
    settings = Settings(state=state)
    database = Database(settings.database)
    store_course(database, settings.runs, SESSIONS)
    with database.transaction() as db:
        clinic = the_clinic(db)
        if clinic is None:
            raise RuntimeError("the clinic of the benchmark was not made")
        give_consent(db, 1, "sharing", utc_now().date(), "bench")
        token = sign_in(db, add_person(db, clinic, "Ada", "owner", None), "bench")
        path = db.scalars(select(Trial.path)).first()
    database.close()
    review = f"learning?floorplan={PLAN}&path={path}&source={STUDY_SOURCE.group}&measure=e_diff"
    pages = ("report?form=pdf", f"export?form=csv&session={SESSIONS}", review)
    return [token, *(f"/patients/1/{page}" for page in pages)]


def furnish_review(state: Path, kind: str) -> list[str]:
    """Make a clinic with trials of five minutes; return the token of a sign-in, `kind`, and the ids of the trials."""
    settings = Settings(state=state)
    database = Database(settings.database)
    store_course(database, settings.runs, REVIEWED, REVIEWED_SECONDS)
    with database.transaction() as db:
        clinic = the_clinic(db)
        if clinic is None:
            raise RuntimeError("the clinic of the benchmark was not made")
        token = sign_in(db, add_person(db, clinic, "Ada", "owner", None), "bench")
        trials = [str(trial) for trial in db.scalars(select(Trial.id).order_by(Trial.id))]
    database.close()
    return [token, kind, *trials]
