"""The calibration under way: its script, its steps and their recordings, which survive a restart."""

from sqlalchemy import delete, select
from sqlalchemy.orm import Session

from app.json_values import JsonDocument
from app.refusals import Conflict
from app.source import OWN_GROUPS, source_group
from app.store.map_versions import family
from app.store.tables import CalibrationStep, PatientSession, Profile, Run
from app.texts import Text


def begin_calibration(db: Session, session: PatientSession, script: JsonDocument, steps: list[str]) -> None:
    """Begin the calibration anew with this script; every step is waiting, earlier recordings stay on disk."""
    db.execute(delete(CalibrationStep).where(CalibrationStep.session_id == session.id))
    db.add_all(
        CalibrationStep(session_id=session.id, step=step, status="waiting", words="", run_id=None) for step in steps
    )
    session.script, session.current_step, session.result, session.accepted = script, steps[0], None, False
    db.flush()


def calibration_steps(db: Session, session_id: int) -> dict[str, CalibrationStep]:
    """Return the steps of the calibration under way, by their id."""
    rows = db.scalars(select(CalibrationStep).where(CalibrationStep.session_id == session_id))
    return {row.step: row for row in rows}


def set_step(
    db: Session, session_id: int, step: str, status: str, message: Text | str, run_id: str | None = None
) -> None:
    """Store the status of a step, and its run when one is given; otherwise the step keeps its run."""
    row = db.get_one(CalibrationStep, (session_id, step))
    row.status, row.words = status, message
    if run_id is not None:
        row.run_id = run_id
    db.flush()


def recordings_of(db: Session, session_id: int) -> dict[str, str]:
    """Return the folder of each done step's recording, below the folder of all runs."""
    rows = db.execute(
        select(CalibrationStep.step, Run.folder)
        .join(Run, Run.id == CalibrationStep.run_id)
        .where(CalibrationStep.session_id == session_id, CalibrationStep.status == "done")
    )
    return {row.step: row.folder for row in rows}


def recordings_behind(db: Session, row: Profile) -> dict[str, str]:
    """Return the recordings of the calibration that a map comes from; none when its steps were recorded again."""
    first = min(family(db, row.patient_id, row.version))
    origin = db.scalars(select(Profile).where(Profile.patient_id == row.patient_id, Profile.version == first)).one()
    session = db.get(PatientSession, origin.session_id)
    if session is None or session.result is None or session.result["created"] != origin.document["created"]:
        return {}
    return recordings_of(db, session.id)


def is_calibration_simulated(db: Session, session_id: int) -> bool | None:
    """Return whether nobody wore the shirt in the done steps, None when unknown; Conflict for a mixture of groups."""
    groups = {
        source_group(shirt, simulated): simulated
        for shirt, simulated in db.execute(
            select(Run.shirt, Run.simulated)
            .join(CalibrationStep, CalibrationStep.run_id == Run.id)
            .where(CalibrationStep.session_id == session_id, CalibrationStep.status == "done")
        )
    }
    if len(groups) > 1:
        raise Conflict(Text("store-steps-mixed-sensors" if groups.keys() & OWN_GROUPS.keys() else "store-steps-mixed"))
    return next(iter(groups.values()), None)


def fail_interrupted_steps(db: Session) -> None:
    """Mark the steps that an ended web process left running as failed: they have to be repeated."""
    for row in db.scalars(select(CalibrationStep).where(CalibrationStep.status == "running")):
        row.status, row.words = "failed", Text("store-step-interrupted")
