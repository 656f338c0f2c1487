"""Erase a deleted patient for good: all rows, then all files; what stays is a tombstone and the log."""

import shutil
import sqlite3
from contextlib import closing
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path
from typing import Final

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict, NotFound
from app.settings import Settings
from app.store.access.visible_patients import WITH_DELETED
from app.store.database import Database
from app.store.files.replacements import BETWEEN, archive_on_shelf
from app.store.files.temporary_folders import remove_temporary_folders
from app.store.keeping.incidents import incident_of
from app.store.keeping.keeping_tables import ErasedPatient, PatientFile
from app.store.keeping.last_ids import store_last_ids
from app.store.keeping.owned_rows import (
    RowIds,
    erase_rows,
    forget_in_lists,
    rows_of_patient,
    sqlite_connection,
    tables_in,
)
from app.store.keeping.passed_time import passed_now
from app.store.keeping.record_time import must_be_kept_until
from app.store.keeping.tombstones import Tombstone, add_tombstones, tombstone
from app.store.log import write_log
from app.store.own_rows import own_row
from app.store.schema import metadata
from app.store.tables import Patient, PatientSession, Run
from app.texts import Text

UNDO_FOR: Final = timedelta(days=30)  # a deleted patient can be brought back, and is then erased
UNDO_ENDED: Final = "30 days after the deletion"  # those of UNDO_FOR, in the log; log.ftl translates it


@dataclass(frozen=True, slots=True)
class DeletedPatient:
    """A deleted patient, with what goes when the patient is erased."""

    id: int
    code: str
    pseudonym: str
    deleted: datetime
    until: datetime  # when the patient is erased
    recordings: int
    why_not: Text | None  # why the patient cannot be erased now; None when nothing is in the way


def deleted_patients(db: Session) -> list[DeletedPatient]:
    """Return the clinic's deleted patients, who can still be restored, the latest first."""
    query = select(Patient).where(Patient.deleted.is_not(None))
    patients = db.scalars(query.order_by(Patient.deleted.desc()), execution_options=WITH_DELETED)
    return [_described(db, patient, patient.deleted) for patient in patients if patient.deleted is not None]


def erase_patient(database: Database, settings: Settings, patient_id: int, person: str | None) -> None:
    """Erase a deleted patient: rows, recordings, uploads. The log says by whom, and whether a reason was given.

    Raises
    ------
    NotFound
        When no deleted patient has this id.
    Conflict
        With the reason, when an incident or the time for which records must be kept stands against it.
    """
    with database.transaction(closing=True) as db:
        patient = _deleted_patient(db, patient_id)
        why_not = _refusal(db, patient)
        if why_not:
            raise Conflict(why_not)
        # The words of the reason may be about the patient, and go.
        why = {"reason": UNDO_ENDED if person is None else "", "reason_given": bool(patient.deletion_reason)}
        # The tombstone comes first: if the program ended here, a restored backup would leave the patient out, too.
        now = utc_now()
        add_tombstones(settings.erased, [tombstone(patient_id, patient.created, now)])
        rows = _erase(db, patient, now)
        counts = {table: len(ids) for table, ids in sorted(rows.items())}
        write_log(db, person, "patient erased", patient=patient_id, rows=counts, **why)
    remove_erased_files(database, settings)


def erase_due(database: Database, settings: Settings) -> None:
    """Erase the patients who were deleted 30 days ago, and remove the files of an interrupted erasure.

    30 days must really have passed: a clock that was set forward erases nobody (`app/store/keeping/passed_time.py`).
    """
    with database.reading() as db:
        query = select(Patient).where(Patient.deleted <= passed_now(db) - UNDO_FOR)
        deleted = list(db.scalars(query, execution_options=WITH_DELETED))
        due = [patient.id for patient in deleted if not _refusal(db, patient)]
    for patient_id in due:
        erase_patient(database, settings, patient_id, None)
    remove_erased_files(database, settings)


def erase_again(database: Database, settings: Settings, tombstones: frozenset[Tombstone]) -> list[int]:
    """Erase the patients of these tombstones from a restored clinic, and return their ids."""
    with database.transaction(closing=True) as db:
        patients = [
            patient
            for stone in sorted(tombstones)
            if (patient := db.get(Patient, stone.patient, execution_options=WITH_DELETED)) is not None
            and tombstone(patient.id, patient.created, patient.created).created == stone.created
        ]
        for patient in patients:
            rows = _erase(db, patient, utc_now())
            counts = {table: len(ids) for table, ids in sorted(rows.items())}
            write_log(db, None, "patient erased again", patient=patient.id, rows=counts, reason="restored backup")
    add_tombstones(settings.erased, tombstones)
    remove_erased_files(database, settings)
    return [patient.id for patient in patients]


def remove_erased_files(database: Database, settings: Settings) -> None:
    """Remove the files of erased patients, and the bytes that SQLite's write-ahead log still holds of them.

    The temporary folders of killed imports and exports are removed as well: they can hold recordings of anybody.
    """
    remove_temporary_folders(settings.state)
    with database.reading() as db:
        remaining = {row.id: list(row.files) for row in db.scalars(select(ErasedPatient)) if row.files}
    if not remaining:
        return
    for patient, files in remaining.items():
        for name in files:
            _remove(settings.state / name)
        _erase_in_copies(settings, patient)
    with database.transaction(closing=True) as db:
        for patient in remaining:
            db.get_one(ErasedPatient, patient).files = []
    database.empty_write_ahead_log()


def _described(db: Session, patient: Patient, deleted: datetime) -> DeletedPatient:
    runs = select(func.count(Run.id)).join(PatientSession, Run.session_id == PatientSession.id)
    recordings = db.scalar(runs.where(PatientSession.patient_id == patient.id), execution_options=WITH_DELETED)
    return DeletedPatient(
        id=patient.id,
        code=patient.code,
        pseudonym=patient.pseudonym,
        deleted=deleted,
        until=deleted + UNDO_FOR,
        recordings=recordings or 0,
        why_not=_refusal(db, patient),
    )


def _deleted_patient(db: Session, patient_id: int) -> Patient:
    missing = Text("store-no-deleted-patient", patient=patient_id)
    patient = own_row(db, Patient, patient_id, missing, deleted=True)
    if patient.deleted is None:
        raise NotFound(missing)
    return patient


def _refusal(db: Session, patient: Patient) -> Text | None:
    incident = incident_of(db, patient.id)
    if incident is not None:
        return Text("store-incident-not-erased", code=patient.code, made=incident.made.date())
    until = must_be_kept_until(db, patient)
    if until is not None and not patient.deletion_reason:
        return Text("store-records-kept", code=patient.code, until=until.date())
    return None


def _erase(db: Session, patient: Patient, now: datetime) -> RowIds:
    """Erase the rows of a patient within a transaction, and store which files are to be removed after it."""
    record = ErasedPatient(id=patient.id, created=patient.created, erased=now, files=_files_of(db, patient))
    db.flush()
    connection = sqlite_connection(db)
    tables = metadata()
    rows = rows_of_patient(connection, tables, patient.id)
    store_last_ids(connection, tables, rows)
    erase_rows(connection, tables, rows)
    forget_in_lists(connection, patient.id)
    db.expunge_all()
    db.merge(record)  # a backup of before may know the erasure of another patient of this id
    db.flush()
    return rows


def _files_of(db: Session, patient: Patient) -> list[str]:
    """Return recordings and uploads of a patient, with what was replaced, relative to the state folder."""
    rows = rows_of_patient(sqlite_connection(db), metadata(), patient.id)
    runs = select(Run.folder).where(Run.session_id.in_(rows.get("session", ())))
    recordings = [f"runs/{folder}" for folder in db.scalars(runs, execution_options=WITH_DELETED)]
    query = select(PatientFile).where(PatientFile.patient_id == patient.id)
    uploaded = list(db.scalars(query, execution_options=WITH_DELETED))
    uploads = [f"files/{file.name}" for file in uploaded if file.current]
    replaced = [f"replaced/file/*{BETWEEN}{file.name}" for file in uploaded]
    return [*recordings, *uploads, *replaced, f"replaced/{archive_on_shelf(None, patient.created)}"]


def _remove(place: Path) -> None:
    """Remove a file, a folder, or all files of a pattern."""
    for match in place.parent.glob(place.name):
        if match.is_dir():
            shutil.rmtree(match)
        else:
            match.unlink(missing_ok=True)


def _erase_in_copies(settings: Settings, patient: int) -> None:
    """Erase a patient from the copies of the database that upgrades have made; their schemas may be of any age."""
    for copy in settings.state.glob(f"{settings.database.name}.*.backup"):
        tables = tables_in(copy)
        with closing(sqlite3.connect(copy, isolation_level=None)) as connection:
            connection.execute("PRAGMA secure_delete=ON")
            connection.execute("BEGIN IMMEDIATE")
            erase_rows(connection, tables, rows_of_patient(connection, tables, patient))
            forget_in_lists(connection, patient)
            connection.execute("COMMIT")
            connection.execute("VACUUM")
