"""The stored control quality of trials."""

from pydantic import ValidationError
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.scoring.control_quality import ControlQuality
from app.store.tables import Parameters, Profile, Trial


def save_quality(db: Session, trial_id: int, quality: ControlQuality) -> None:
    """Store how well a trial was controlled."""
    db.get_one(Trial, trial_id).quality = quality.model_dump(mode="json")


def stored_quality(trial: Trial) -> ControlQuality | None:
    """Return the stored quality of a trial; None when there is none, or an older program stored other fields."""
    try:
        return None if trial.quality is None else ControlQuality.model_validate(trial.quality)
    except ValidationError:
        return None


def map_version_of(db: Session, trial: Trial) -> int:
    """Return the version of the profile that a trial was driven with."""
    query = select(Profile.version).join(Parameters, Parameters.profile_id == Profile.id)
    return db.scalars(query.where(Parameters.id == trial.parameters_id)).one()
