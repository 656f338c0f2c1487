"""What a proposal to adapt the map is made from, and whether it still holds."""

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

LAST_TRIALS = 6  # what a person did long ago says little of today


class AdaptationMaterial(NamedTuple):
    """The set that drives now, and the trials that show how the person moves."""

    parameters: DriveParameters
    calibrated: CalibrationProfile  # what the map of now goes back to
    trials: tuple[int, ...]  # ids, the newest last
    run_ids: list[str]  # of their recordings
    fresh: int  # how many of them were driven with the map of now


def material_for(db: Session, patient_id: int, session_id: int, *, simulated: bool | None) -> AdaptationMaterial:
    """Return the last trials of a session that count, and were driven with a map of the same calibration.

    Those of earlier sessions tell nothing: the shirt was put on again since. `simulated` says of the shirt in use
    whether nobody wears it: a simulated movement never changes the map of a person, nor the other way round.
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
    """Tell whether the set of this hash still drives, and all of these trials still count."""
    if as_document(*current_parameters(db, patient_id)).hash != base:
        return False
    return all(trial is not None and trial.kept for trial in (db.get(Trial, each) for each in trials))


def mode_of(db: Session, patient_id: int) -> str:
    """Return whether a patient's map is adapted: off, suggest, auto."""
    return db.get_one(Patient, patient_id).adaptation
