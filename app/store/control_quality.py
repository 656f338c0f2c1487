"""The stored control quality of trials."""

from collections.abc import Collection

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.scoring.control_quality import ControlQuality
from app.store.tables import ParameterSet, PatientSession, Profile, Trial


def save_quality(db: Session, trial_id: int, quality: ControlQuality) -> None:
    """Store how well a trial was controlled."""
    db.get_one(Trial, trial_id).quality = quality.model_dump(mode="json")


def stored_qualities(db: Session, trials: Collection[int]) -> dict[int, ControlQuality]:
    """Return the stored quality of each of these trials that has one."""
    rows = db.execute(select(Trial.id, Trial.quality).where(Trial.id.in_(trials)))
    return {trial: ControlQuality.model_validate(document) for trial, document in rows if document is not None}


def sessions_and_versions(db: Session, trials: Collection[int]) -> dict[int, tuple[int, int]]:
    """Return the number of the session of each of these trials, and the version of the map that it was driven with."""
    query = (
        select(Trial.id, PatientSession.number, Profile.version)
        .join(PatientSession, PatientSession.id == Trial.session_id)
        .join(ParameterSet, ParameterSet.id == Trial.parameters_id)
        .join(Profile, Profile.id == ParameterSet.profile_id)
        .where(Trial.id.in_(trials))
    )
    return {trial: (number, version) for trial, number, version in db.execute(query)}
