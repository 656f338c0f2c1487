"""The owner's page "Backup": folder, passphrase, the backups that were made, deleted patients, incidents."""

import asyncio
from pathlib import Path
from typing import Annotated, Literal

from fastapi import APIRouter, Depends
from pydantic import Field, SecretStr

from app.api.answers import Answer, MomentText, Sentence
from app.api.deps import ComputingPart, Db, Owner, RowId, SettingsPart
from app.api.page_session import OF_CLINIC, OWN_NAME, any_session
from app.api.parts import part
from app.computing_process import ComputingProcess
from app.features.backup.age_files import SHORTEST_PASSPHRASE
from app.features.backup.contents import clinic_mark
from app.features.backup.kept_backups import DAILY, MONTHLY, WEEKLY
from app.features.backup.made_backups import backup_warning, last_good_backup, newest_backups
from app.features.backup.night_backups import NightBackups, backup_settings
from app.features.backup.night_secret import keep_secret, opened_folder, read_secret
from app.features.backup.signature import clinic_fingerprint
from app.file_modes import OWNER_FOLDER
from app.quantities import Document, Line
from app.refusals import Conflict
from app.settings import Settings
from app.store.database import Database
from app.store.keeping.erasure import deleted_patients, erase_patient
from app.store.keeping.incidents import all_incidents, lift_incident
from app.store.keeping.passed_time import clock_warning
from app.store.keeping.record_time import MOST_YEARS, record_time, set_record_time
from app.store.log import write_log
from app.texts import Text

router = APIRouter(tags=["backup"])

Reason = Annotated[Line, Field(min_length=3, max_length=400)]
Passphrase = Annotated[SecretStr, Field(min_length=SHORTEST_PASSPHRASE, max_length=200)]

Backups = Annotated[NightBackups, Depends(part(NightBackups))]


class BackupSettings(Document):
    """Where the backups of every night go, when, and what is in them."""

    folder: Annotated[Line, Field(max_length=1000)] | None
    hour: Annotated[int, Field(strict=True, ge=0, le=23)]
    with_keys: bool
    passphrase: Passphrase | None = None  # None: as before
    encrypted: bool


class RecordTime(Document):
    """For how many years after the last session records must be kept; None: nothing is set."""

    years: Annotated[int, Field(strict=True, ge=1, le=MOST_YEARS)] | None


class Lifting(Document):
    """Why the mark of an incident is lifted."""

    reason: Reason


class MadeBackupView(Answer):
    """A backup that was made, or that failed."""

    at: MomentText
    place: str
    name: str
    in_folder: bool
    good: bool
    message: Text
    files: int
    bytes: int
    encrypted: bool
    with_keys: bool


class CourseView(Answer):
    """How far the backup under way is."""

    step: Literal["store", "verify"]
    done: int
    total: int


class DeletedPatientView(Answer):
    """A deleted patient; at `until` the patient is erased."""

    id: int
    code: str
    pseudonym: str
    deleted: MomentText
    until: MomentText
    recordings: int
    why_not: Sentence


class IncidentView(Answer):
    """An incident's archive, and the ids of its patients, who are not erased before the mark is lifted."""

    id: int
    made: MomentText
    since: MomentText
    hash: str
    lifted: MomentText | None
    reason: str | None
    patients: list[int]


class KeptView(Document):
    """How many backups of the folder stay."""

    daily: int = DAILY
    weekly: int = WEEKLY
    monthly: int = MONTHLY


class BackupsView(Document):
    """All of the page."""

    folder: str | None
    hour: int
    with_keys: bool
    encrypted: bool
    kept: KeptView = KeptView()
    years: int | None
    warning: str
    clock: str  # what the clock's jumps keep from being erased; empty: it goes on as time does
    last_good: str | None
    made: list[MadeBackupView]
    course: CourseView | None
    deleted: list[DeletedPatientView]
    incidents: list[IncidentView]
    fingerprint: str  # of the public key that signs archives; empty before the first one


def _view(settings: Settings, database: Database, backups: NightBackups) -> BackupsView:
    with database.reading() as db:
        chosen, good = backup_settings(db), last_good_backup(db)
        folder_is_there = chosen.folder is not None and Path(chosen.folder).is_dir()
        last = None if good is None else good.at
        warning = backup_warning(last, has_folder=chosen.folder is not None, folder_is_there=folder_is_there)
        course = backups.course
        return BackupsView(
            folder=chosen.folder,
            hour=chosen.hour,
            with_keys=chosen.with_keys,
            encrypted=read_secret(settings.backup) is not None,
            years=record_time(db),
            warning=str(warning or ""),
            clock=str(clock_warning(db) or ""),
            last_good=None if last is None else last.isoformat(),
            made=[MadeBackupView.of(row) for row in newest_backups(db)],
            course=None if course is None else CourseView.of(course),
            deleted=[DeletedPatientView.of(row) for row in deleted_patients(db)],
            incidents=[
                IncidentView(
                    id=row.id,
                    made=row.made,
                    since=row.since,
                    hash=row.hash,
                    lifted=row.lifted,
                    reason=row.reason,
                    patients=patients,
                )
                for row, patients in all_incidents(db)
            ],
            fingerprint=clinic_fingerprint(settings.signing),
        )


@router.get("/backups")
def read_backups(_person: Owner, settings: SettingsPart, database: Db, backups: Backups) -> BackupsView:
    """Return the settings, the newest backups, how far one is that is being made, deleted patients, incidents.

    For owners. The other routes of the page give this answer, too.
    """
    return _view(settings, database, backups)


@router.post("/backups", status_code=202)
@any_session(OF_CLINIC)
async def begin(person: Owner, settings: SettingsPart, database: Db, backups: Backups) -> BackupsView:
    """Begin a backup now; it goes on by itself. 409 without a folder, and while one is being made."""
    await backups.begin(person.name)
    return await asyncio.to_thread(_view, settings, database, backups)


@router.put("/backups/settings")
@any_session(OF_CLINIC)
async def choose(
    body: BackupSettings,
    person: Owner,
    settings: SettingsPart,
    database: Db,
    computing: ComputingPart,
    backups: Backups,
) -> BackupsView:
    """Choose the folder, the hour and the passphrase; 409 in one sentence when the folder cannot be used.

    For owners. `passphrase` null keeps the one that is set.
    """
    await asyncio.to_thread(_choose, body, person.name, settings, database, computing, backups)
    return await asyncio.to_thread(_view, settings, database, backups)


def _choose(
    body: BackupSettings,
    person: str,
    settings: Settings,
    database: Database,
    computing: ComputingProcess,
    backups: NightBackups,
) -> None:
    if backups.course is not None:
        raise Conflict(Text("backups-busy"))
    passphrase = "" if body.passphrase is None else body.passphrase.get_secret_value()
    secret_before = read_secret(settings.backup) if body.encrypted else None
    if body.encrypted and not passphrase and secret_before is None:
        raise Conflict(Text("backups-passphrase-short"))
    if body.folder is not None:
        folder = Path(body.folder)
        if not folder.is_absolute():
            raise Conflict(Text("backups-folder-relative"))
        place = folder.resolve()
        if place.is_relative_to(settings.state.resolve()) or settings.state.resolve().is_relative_to(place):
            raise Conflict(Text("backups-folder-inside"))
        given = passphrase if body.encrypted else ""
        secret, why_not = computing.ask(opened_folder, folder, given, secret_before, clinic_mark(settings))
        if why_not:
            raise Conflict(why_not)
        settings.backup.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
        keep_secret(settings.backup, secret)
    with database.transaction() as db:
        chosen = backup_settings(db)
        chosen.folder, chosen.hour, chosen.with_keys = body.folder, body.hour, body.with_keys
        db.add(chosen)
        details = {"hour": body.hour, "with_keys": body.with_keys, "encrypted": body.encrypted}
        write_log(db, person, "backup settings changed", has_folder=body.folder is not None, **details)


@router.put("/record-keeping")
@any_session(OF_CLINIC)
def keep_records(
    body: RecordTime, person: Owner, settings: SettingsPart, database: Db, backups: Backups
) -> BackupsView:
    """Set for how many years after the last session records must be kept.

    For owners.
    """
    with database.transaction() as db:
        set_record_time(db, body.years)
        write_log(db, person.name, "record time changed", years=body.years)
    return _view(settings, database, backups)


@router.post("/deleted-patients/{patient_id}/erasure")
@any_session(OWN_NAME)
def erase(patient_id: RowId, person: Owner, settings: SettingsPart, database: Db, backups: Backups) -> BackupsView:
    """Erase a deleted patient for good, now; 409 with the reason when something stands against it.

    For owners. An incident, or the time for which records must be kept, can stand against it.
    """
    erase_patient(database, settings, patient_id, person.name)
    return _view(settings, database, backups)


@router.post("/incidents/{incident_id}/lifting")
@any_session(OF_CLINIC)
def lift(
    incident_id: RowId, body: Lifting, person: Owner, settings: SettingsPart, database: Db, backups: Backups
) -> BackupsView:
    """Lift the mark of an incident, so that its patients can be erased.

    For owners.
    """
    with database.transaction() as db:
        lift_incident(db, incident_id, body.reason, person.name)
    return _view(settings, database, backups)
