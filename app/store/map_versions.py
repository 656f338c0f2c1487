"""Versions of a patient's map: adapted from one another, or restored; none is ever overwritten."""

from datetime import datetime
from typing import Literal, NamedTuple

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.json_values import JsonDocument
from app.refusals import Conflict
from app.source import UNKNOWN, SourceGroup, source_group
from app.store.parameters import current_parameters, save_parameters, save_profile
from app.store.tables import ParameterSet, Profile, Run, Trial
from app.texts import Text

CALIBRATION_RUNS = ("rest", "free", "prompt")  # kinds of recordings
BACK_TO = "back_to"  # in `Profile.difference` of a version that goes back: the version whose map it has


class MapVersion(NamedTuple):
    """One version of a patient's map."""

    version: int
    origin: str  # calibration, adaptation, donning, back
    parent: int | None
    difference: JsonDocument | None
    created: datetime
    trials: list[int]  # ids of the trials that were driven with it, the newest last


def save_adapted(
    db: Session,
    patient_id: int,
    session_id: int,
    adapted: DriveParameters,
    difference: JsonDocument,
    *,
    origin: Literal["adaptation", "donning"] = "adaptation",
) -> Profile:
    """Make an adapted set the current one, on the next version of the patient's map."""
    _row, now = current_parameters(db, patient_id)
    profile = save_profile(
        db,
        patient_id,
        session_id,
        adapted.profile,
        simulated=now.simulated,
        origin=origin,
        parent=now.version,
        difference=difference,
    )
    save_parameters(db, profile, adapted)
    return profile


def version_before(db: Session, patient_id: int) -> int | None:
    """Return the version that going back would restore; None for a map that comes straight from a calibration."""
    _row, now = current_parameters(db, patient_id)
    before = _before(db, now)
    return None if before is None else before.version


def go_back(db: Session, patient_id: int, session_id: int) -> Profile:
    """Make a copy of the map before the current one the next version, and return it.

    Dead-zones and fulls are restored with it, except those that a person has set since; bindings, modes and speeds
    stay. When nothing was set since, the set equals the earlier one exactly and has its hash.
    """
    row, now = current_parameters(db, patient_id)
    before = _before(db, now)
    if before is None:
        raise Conflict(Text("store-no-map-before"))
    restored = _settings_of(db, before, newest=True)
    at_first = _settings_of(db, now, newest=False)
    settings = {**row.settings, "gestures": _gestures_back(row.settings, at_first, restored)}
    profile = save_profile(
        db,
        patient_id,
        session_id,
        CalibrationProfile.model_validate(before.document),
        simulated=before.simulated,
        origin="back",
        parent=now.version,
        difference={BACK_TO: before.version},
    )
    save_parameters(db, profile, DriveParameters.model_validate({**settings, "profile": before.document}))
    return profile


def versions_of(db: Session, patient_id: int) -> list[MapVersion]:
    """Return all versions of a patient's map, the newest first."""
    driven: dict[int, list[int]] = {}
    for trial, version in db.execute(
        select(Trial.id, Profile.version)
        .join(ParameterSet, ParameterSet.id == Trial.parameters_id)
        .join(Profile, Profile.id == ParameterSet.profile_id)
        .where(Trial.patient_id == patient_id)
        .order_by(Trial.id)
    ):
        driven.setdefault(version, []).append(trial)
    rows = db.scalars(select(Profile).where(Profile.patient_id == patient_id).order_by(Profile.version.desc()))
    return [
        MapVersion(row.version, row.origin, row.parent, row.difference, row.created, driven.get(row.version, []))
        for row in rows
    ]


def version_row(db: Session, patient_id: int, version: int) -> Profile:
    """Return one version of a patient's map."""
    return db.execute(select(Profile).where(Profile.patient_id == patient_id, Profile.version == version)).scalar_one()


def calibration_behind(db: Session, profile: Profile) -> CalibrationProfile:
    """Return the calibration that a version of the map comes from."""
    first = min(family(db, profile.patient_id, profile.version))
    return CalibrationProfile.model_validate(version_row(db, profile.patient_id, first).document)


def source_of_map(db: Session, profile: Profile) -> SourceGroup:
    """Return the group of the recordings that a version of the map was calibrated with."""
    if profile.simulated is not False:
        return source_group(UNKNOWN, profile.simulated)
    first = version_row(db, profile.patient_id, min(family(db, profile.patient_id, profile.version)))
    shirt = db.scalar(
        select(Run.shirt)
        .where(Run.session_id == first.session_id, Run.kind.in_(CALIBRATION_RUNS), Run.started <= first.created)
        .order_by(Run.started.desc())
        .limit(1)
    )
    return source_group(shirt or UNKNOWN, profile.simulated)


def family(db: Session, patient_id: int, version: int) -> set[int]:
    """Return all versions that come from the same calibration as `version`, that calibration included."""
    parents = {
        row.version: row.parent
        for row in db.execute(select(Profile.version, Profile.parent).where(Profile.patient_id == patient_id))
    }

    def root(of: int) -> int:
        while (parent := parents.get(of)) is not None:
            of = parent
        return of

    wanted = root(version)
    return {each for each in parents if root(each) == wanted}


def _before(db: Session, now: Profile) -> Profile | None:
    """Return the map before `now`; for a version that restored an earlier one, the map before that earlier one."""
    original = now
    while original.origin == "back" and original.difference is not None:
        original = version_row(db, now.patient_id, original.difference[BACK_TO])
    return None if original.parent is None else version_row(db, now.patient_id, original.parent)


def _settings_of(db: Session, profile: Profile, *, newest: bool) -> JsonDocument:
    """Return the newest settings of a version, or its first ones."""
    query = select(ParameterSet).where(ParameterSet.profile_id == profile.id)
    if newest:
        query = query.where(ParameterSet.current.is_(True))
    row = db.scalars(query.order_by(ParameterSet.id)).first()
    return {} if row is None else row.settings


def _gestures_back(now: JsonDocument, at_first: JsonDocument, restored: JsonDocument) -> list[JsonDocument]:
    """Return the gestures of `now` as they are in `restored`, where nobody has changed them since `at_first`."""
    initial = {gesture["name"]: gesture for gesture in at_first.get("gestures", ())}
    old = {gesture["name"]: gesture for gesture in restored.get("gestures", ())}
    return [old.get(each["name"], each) if initial.get(each["name"]) == each else each for each in now["gestures"]]
