"""Profiles and parameter sets: every version is kept, with undo, redo and sets saved by name."""

from pydantic import ValidationError
from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.clock import utc_now
from app.json_values import JsonDocument
from app.refusals import Conflict, NotFound
from app.store.tables import ParameterSet, Profile
from app.texts import Text


def save_profile(
    db: Session,
    patient_id: int,
    session_id: int,
    profile: CalibrationProfile,
    *,
    simulated: bool | None = None,
    origin: str = "calibration",
    parent: int | None = None,
    difference: JsonDocument | None = None,
) -> Profile:
    """Save an accepted map as the patient's next version; `parent` is the version that it was made from.

    `simulated` says whether nobody wore the shirt in which it was calibrated, None where that is unknown.
    """
    last = db.scalar(select(func.max(Profile.version)).where(Profile.patient_id == patient_id)) or 0
    row = Profile(
        patient_id=patient_id,
        session_id=session_id,
        version=last + 1,
        origin=origin,
        parent=parent,
        difference=difference,
        document=profile.model_dump(mode="json"),
        created=utc_now(),
        simulated=simulated,
    )
    db.add(row)
    db.flush()
    return row


def newest_profile(db: Session, patient_id: int) -> Profile | None:
    """Return the patient's newest calibration, None before the first."""
    return db.scalar(select(Profile).where(Profile.patient_id == patient_id).order_by(Profile.version.desc()).limit(1))


def _needed_profile(db: Session, patient_id: int) -> Profile:
    row = newest_profile(db, patient_id)
    if row is None:
        raise Conflict(Text("store-not-calibrated"))
    return row


def _history(db: Session, profile: Profile) -> list[ParameterSet]:
    return list(
        db.scalars(
            select(ParameterSet)
            .where(ParameterSet.profile_id == profile.id, ParameterSet.abandoned.is_(False))
            .order_by(ParameterSet.id)
        )
    )


def save_parameters(db: Session, profile: Profile, parameters: DriveParameters) -> ParameterSet:
    """Make `parameters` the current set of `profile`; sets that were undone before can no longer be redone."""
    passed_current = False
    for row in _history(db, profile):
        row.abandoned = passed_current
        passed_current = passed_current or row.current
        row.current = False
    new = ParameterSet(
        profile_id=profile.id,
        title=parameters.title,
        settings=parameters.model_dump(mode="json", exclude={"profile"}),
        hash=parameters.hash,
        created=utc_now(),
        current=True,
        abandoned=False,
    )
    db.add(new)
    db.flush()
    return new


def current_parameters(db: Session, patient_id: int) -> tuple[ParameterSet, Profile]:
    """Return the current set with its profile."""
    profile = _needed_profile(db, patient_id)
    row = db.scalar(select(ParameterSet).where(ParameterSet.profile_id == profile.id, ParameterSet.current.is_(True)))
    if row is None:
        row = save_parameters(db, profile, standard_parameters(CalibrationProfile.model_validate(profile.document)))
    return row, profile


def as_document(row: ParameterSet, profile: Profile) -> DriveParameters:
    """Return the whole parameter set, profile included; Conflict when this program cannot read it."""
    try:
        return DriveParameters.model_validate({**row.settings, "profile": profile.document})
    except ValidationError as error:
        raise Conflict(Text("store-set-of-other-version")) from error


def undo_and_redo(db: Session, patient_id: int) -> tuple[ParameterSet | None, ParameterSet | None]:
    """Return the sets before and after the current one, None where there is none."""
    current, profile = current_parameters(db, patient_id)
    history = _history(db, profile)
    place = [row.id for row in history].index(current.id)
    before = history[place - 1] if place > 0 else None
    after = history[place + 1] if place + 1 < len(history) else None
    return before, after


def step_parameters(db: Session, patient_id: int, *, back: bool) -> ParameterSet:
    """Undo or redo: make the set before or after the current one current."""
    current, _profile = current_parameters(db, patient_id)
    before, after = undo_and_redo(db, patient_id)
    target = before if back else after
    if target is None:
        raise Conflict(Text("store-nothing-to-undo") if back else Text("store-nothing-to-redo"))
    current.current = False
    target.current = True
    db.flush()
    return target


def saved_titles(db: Session, patient_id: int) -> list[str]:
    """Return the names of the patient's sets, in the order in which they were first used."""
    first = func.min(ParameterSet.id)
    return list(
        db.scalars(
            select(ParameterSet.title)
            .join(Profile, Profile.id == ParameterSet.profile_id)
            .where(Profile.patient_id == patient_id)
            .group_by(ParameterSet.title)
            .order_by(first)
        )
    )


def load_titled(db: Session, patient_id: int, title: str) -> ParameterSet:
    """Make a copy of the newest set of this name current, on the newest profile.

    Dead-zones and fulls are given in full scales of the joint, so they stay valid on a newer calibration.
    """
    profile = _needed_profile(db, patient_id)
    saved: JsonDocument | None = db.scalar(
        select(ParameterSet.settings)
        .join(Profile, Profile.id == ParameterSet.profile_id)
        .where(Profile.patient_id == patient_id, ParameterSet.title == title)
        .order_by(ParameterSet.id.desc())
        .limit(1)
    )
    if saved is None:
        raise NotFound(Text("store-no-set", title=title))
    try:
        parameters = DriveParameters.model_validate({**saved, "profile": profile.document})
    except ValidationError as error:
        raise Conflict(Text("store-set-of-other-joints", title=title)) from error
    return save_parameters(db, profile, parameters)
