"""The trials from which a proposal to adapt the map is made, and the check that it is still current."""

from collections.abc import Sequence
from typing import NamedTuple

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.store.map_versions import family, version_row
from app.store.parameters import as_document, current_parameters
from app.store.practice import PRACTICE_ENDS
from app.store.tables import Parameters, Patient, Profile, Run, Trial

LAST_TRIALS = 6  # older trials say little about how the person moves today


class AdaptationMaterial(NamedTuple):
    """The current parameter set, and the trials that show how the person moves."""

    parameters: DriveParameters
    calibrated: CalibrationProfile  # the calibration from which the current map comes
    trials: tuple[int, ...]  # ids, the newest last
    run_ids: list[str]  # of their recordings
    fresh: int  # number of trials driven with the current map, the newest ones


def material_for(db: Session, patient_id: int, session_id: int, *, simulated: bool | None) -> AdaptationMaterial:
    """Return the last kept trials of a session that were driven with a map of the same calibration.

    Trials of earlier sessions are left out, because the shirt has been put on again since. `simulated`: nobody wears
    the shirt in use. A simulated movement never changes the map of a person, nor the other way round.
    """
    row, profile = current_parameters(db, patient_id)
    versions = family(db, patient_id, profile.version)
    found = db.execute(
        select(Trial, Profile.version)
        .join(Parameters, Parameters.id == Trial.parameters_id)
        .join(Profile, Profile.id == Parameters.profile_id)
        .join(Run, Run.id == Trial.run_id)
        .where(
            Run.simulated.is_(simulated),
            Trial.session_id == session_id,
            Trial.kept.is_(True),
            Trial.end.in_(PRACTICE_ENDS),
            Profile.patient_id == patient_id,
            Profile.version.in_(versions),
        )
        .order_by(Trial.id.desc())
    )
    last = [(trial, version) for trial, version in found if trial.measures is not None][:LAST_TRIALS][::-1]
    return AdaptationMaterial(
        as_document(row, profile),
        CalibrationProfile.model_validate(version_row(db, patient_id, min(versions)).document),
        tuple(trial.id for trial, _ in last),
        [trial.run_id for trial, _ in last],
        sum(version == profile.version for _, version in last),
    )


def is_current(db: Session, patient_id: int, base: str, trials: Sequence[int]) -> bool:
    """Return whether the set of this hash is still the current one, and all of these trials are still kept."""
    if as_document(*current_parameters(db, patient_id)).hash != base:
        return False
    return all(trial is not None and trial.kept for trial in (db.get(Trial, each) for each in trials))


def mode_of(db: Session, patient_id: int) -> str:
    """Return the adaptation mode of a patient's map: off, suggest or auto."""
    return db.get_one(Patient, patient_id).adaptation
