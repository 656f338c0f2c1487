"""The trials from which a proposal to adapt the map is made, and the check that it is still current."""

from collections.abc import Sequence
from typing import NamedTuple

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.json_values import JsonDocument
from app.scoring.map_losses.losses import MOST_TRIALS
from app.source import SourceGroup
from app.store.map_versions import calibration_behind, family
from app.store.parameters import as_document, current_parameters
from app.store.run_groups import is_of_group
from app.store.tables import ParameterSet, Patient, Profile, Run, Trial

LAST_TRIALS = 6  # older trials say little about how the person moves today


class PastTrialRow(NamedTuple):
    """The recording of a trial, and the full of each gesture that it was driven with."""

    run_id: str
    fulls: dict[str, float]  # gesture -> FS/s


class AdaptationMaterial(NamedTuple):
    """The current parameter set, and the trials that show how the person moves."""

    parameters: DriveParameters
    calibrated: CalibrationProfile  # the calibration from which the current map comes
    trials: tuple[int, ...]  # ids, the newest last
    run_ids: list[str]  # of their recordings
    fresh: int  # number of trials driven with the current map, the newest ones
    past: list[PastTrialRow]  # all trials with a map of the same calibration, of earlier sessions too, the newest last


def material_for(db: Session, patient_id: int, session_id: int, group: SourceGroup) -> AdaptationMaterial:
    """Return the last kept trials of a session that were driven with a map of the same calibration, and all of them.

    This session's trials show how the person moves: the shirt has been put on again since the earlier ones. All trials
    together show whether the map loses something. A trial in which motion was never permitted counts as well, because
    the dead-zone has to follow the noise that kept the chair from starting. `group`: that of the shirt in use. A
    simulated movement never changes the map of a person, a person's movement never a simulated one, and what a camera
    saw never the map of a worn shirt.
    """
    row, profile = current_parameters(db, patient_id)
    versions = family(db, patient_id, profile.version)
    rows = db.execute(
        select(Trial, Profile.version, ParameterSet.settings)
        .join(ParameterSet, ParameterSet.id == Trial.parameters_id)
        .join(Profile, Profile.id == ParameterSet.profile_id)
        .join(Run, Run.id == Trial.run_id)
        .where(
            is_of_group(group),
            Trial.kept.is_(True),
            Trial.status == "done",
            Profile.patient_id == patient_id,
            Profile.version.in_(versions),
        )
        .order_by(Trial.id.desc())
    )
    newest = list(rows)
    last = [(trial, version) for trial, version, _ in newest if trial.session_id == session_id][:LAST_TRIALS][::-1]
    return AdaptationMaterial(
        as_document(row, profile),
        calibration_behind(db, profile),
        tuple(trial.id for trial, _ in last),
        [trial.run_id for trial, _ in last],
        sum(version == profile.version for _, version in last),
        [PastTrialRow(trial.run_id, _fulls(settings)) for trial, _, settings in newest[:MOST_TRIALS][::-1]],
    )


def _fulls(settings: JsonDocument) -> dict[str, float]:
    return {gesture["name"]: float(gesture["full"]) for gesture in settings.get("gestures", ())}


def is_current(db: Session, patient_id: int, base: str, trials: Sequence[int]) -> bool:
    """Return whether the set of this hash is still the current one, and all of these trials are still kept."""
    if as_document(*current_parameters(db, patient_id)).hash != base:
        return False
    return all(trial is not None and trial.kept for trial in (db.get(Trial, each) for each in trials))


def mode_of(db: Session, patient_id: int) -> str:
    """Return the adaptation mode of a patient's map: off, suggest or auto."""
    return db.get_one(Patient, patient_id).adaptation
