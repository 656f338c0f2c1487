"""Import the archive of a patient that another clinic has made, or this one: nothing is added before all is checked."""

import json
import os
import shutil
from contextlib import closing, nullcontext
from datetime import UTC, datetime
from pathlib import Path
from typing import Annotated, Any, NamedTuple

from pydantic import ConfigDict, Field, ValidationError
from sqlalchemy import or_, select
from sqlalchemy.orm import Session

from app.child_process import limit_memory
from app.clock import utc_now
from app.cues import Cue
from app.disk_room import ROOM_TO_RECORD
from app.features.archive.archive_file import RUN_ID, OpenArchive, open_archive
from app.features.archive.patient_rows import Rows, WrongRows, add_patient_rows, check_rows, patient_rows
from app.features.archive.row_forms import first_error
from app.features.archive.service import archive_steps, clinic_name, require_room_for
from app.file_modes import OWNER_FOLDER
from app.files import sync_folder
from app.layout import ShirtLayout
from app.messages import MAX_GESTURES
from app.quantities import Document, Hertz, Name
from app.recording.format import PER_CHANNEL
from app.recording.groups import read_in_groups
from app.refusals import NO_ROOM, Conflict, DiskFull, PatientHere
from app.store.access.visible_patients import of_clinic
from app.store.database import Database, Transaction
from app.store.files.disk_watch import disk_room
from app.store.files.replacements import archive_on_shelf
from app.store.files.temporary_folders import temporary_folder
from app.store.keeping.incidents import incident_of
from app.store.keeping.keeping_tables import PatientFile
from app.store.keeping.last_ids import store_last_ids
from app.store.keeping.owned_rows import erase_rows, forget_in_lists, rows_of_patient, sqlite_connection
from app.store.keeping.record_time import must_be_kept_until
from app.store.log import write_log
from app.store.origins import ImportedSession, PatientImport
from app.store.schema import metadata
from app.store.tables import Patient, PatientSession, Run
from app.texts import Text, Value
from app.visible_text import visible_line


class RecordingHeader(Document):
    """What every export and review reads of `run.json`; its other fields are read with care where they are used."""

    model_config = ConfigDict(extra="allow", frozen=True, allow_inf_nan=False)

    layout: ShirtLayout
    sample_rate: Hertz
    gestures: Annotated[tuple[Name, ...], Field(max_length=MAX_GESTURES)] = ()
    cues: tuple[Cue, ...] = ()
    software: str = ""
    kind: Name | None = None
    path: Name | None = None
    parameters: dict[str, Any] | None = None
    floorplan: dict[str, Any] | None = None


def wrong_recording(folder: Path) -> Text | None:
    """Say in half a sentence what is wrong with a recording, None when nothing is; damage that is known is not wrong.

    A recording of which nothing is known but its numbers, because `run.json` was lost, is exported by nobody.
    """
    import pyarrow as pa

    try:
        run = read_in_groups(folder)
        header = RecordingHeader.model_validate_json(json.dumps(run.meta), strict=True) if run.meta else None
        for rows in run.groups:
            many = len(rows["t"])
            if header is not None and many and rows[PER_CHANNEL].shape[1] != len(header.layout.channels):
                return Text("archive-recording-channels", recording=folder.name)
            if header is not None and many and rows["score"].shape[1] != len(header.gestures):
                return Text("archive-recording-gestures", recording=folder.name)
    except ValidationError as error:
        return Text("archive-recording-field", recording=folder.name, problem=first_error(error))
    except (pa.ArrowException, OSError, ValueError, TypeError, KeyError, AttributeError, NotImplementedError):
        return Text("archive-recording-unreadable", recording=folder.name)
    return None


def checked_rows(archive: OpenArchive) -> Rows:
    """Return the rows of an archive; ValueError with one sentence when one of them is wrong."""
    document = archive.patient()
    try:
        rows = check_rows(document.get("tables") if isinstance(document, dict) else None)
        _check_contents(rows, archive)
    except WrongRows as error:
        raise _wrong(archive.file, error) from error
    except ValueError as error:
        raise _wrong(archive.file, Text("archive-text-refused", problem=error)) from error
    return rows


def _wrong(file: Path, why: Value) -> ValueError:
    return ValueError(Text("archive-wrong", file=str(file), why=why))


def _check_contents(rows: Rows, archive: OpenArchive) -> None:
    """Raise WrongRows or ValueError for documents and texts that this program would not have stored."""
    visible_line(archive.listed.clinic)
    runs = [row["id"] for row in rows["run"]]
    if len(runs) != len(set(runs)) or not all(RUN_ID.fullmatch(run) for run in runs):
        raise WrongRows(Text("archive-recording-names"))
    if not {name.split("/")[1] for name in archive.listed.files if "/" in name} <= set(runs):
        raise WrongRows(Text("archive-recording-unnamed"))
    if not all(row["author"] for row in rows.get("moment_comment", ())):
        raise WrongRows(Text("archive-comment-without-author"))


class Imported(NamedTuple):
    """The patient of an archive: new, imported before by the same archive, or replaced; and what came in with it."""

    patient_id: int
    code: str
    is_new: bool
    sessions: int = 0
    trials: int = 0  # finished and kept
    kept: str = ""  # the archive of the patient as it was before it was replaced, within the shelf


def import_archive(
    database: Database,
    file: Path,
    person: str,
    runs: Path,
    unpacked: Path | None = None,
    shelf: Path | None = None,
) -> Imported:
    """Import the archive in `file`; one that was imported before changes nothing.

    Its recordings are unpacked in `unpacked`, a folder on the disk of `runs` that is made; without one, in a folder
    that is removed. A patient who is in the clinic already is replaced when a `shelf` is given, the folder of replaced
    files: first an archive of the patient as it is here is put there. A recording that is here stays.

    Raises
    ------
    ValueError
        One sentence, when the file is no archive, damaged, hostile, or of a newer program.
    PatientHere
        When the patient is in the clinic already, and no shelf is given.
    Conflict, DiskFull
        When the code or a recording is another patient's, when the patient cannot be replaced, or there is no room.
    """
    with open_archive(file) as archive:
        with database.reading() as db:
            earlier_import = _earlier_import(db, archive.listed.hash)
            if earlier_import is not None:
                return Imported(earlier_import.id, earlier_import.code, is_new=False)
        rows = checked_rows(archive)
        with database.reading() as db:
            patient = _patient_of_rows(db, rows)
            if patient is not None and shelf is None:
                raise PatientHere(Text("archive-patient-here", code=patient.code))
            here: frozenset[str] = frozenset()
            if patient is not None:
                _require_replaceable(db, patient, rows)
                here = _runs_here(db, patient.id)
        if disk_room(runs.parent).free < archive.recording_bytes(here) + ROOM_TO_RECORD:
            raise DiskFull(NO_ROOM)
        runs.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
        with temporary_folder(runs.parent, "import") if unpacked is None else nullcontext(unpacked) as folder:
            folder.mkdir(mode=OWNER_FOLDER, exist_ok=True)
            archive.unpack_recordings(folder, here)
            wrong = next(filter(None, map(wrong_recording, sorted(folder.iterdir()))), None)
            if wrong is not None:
                raise _wrong(archive.file, wrong)
            shelf_file = "" if shelf is None or patient is None else _put_on_shelf(database, rows, runs, shelf)
            return _add(database, archive, rows, person, folder, runs, shelf_file)


def _put_on_shelf(database: Database, rows: Rows, runs: Path, shelf: Path) -> str:
    """Write an archive of the patient as it is here, and return its place on the shelf."""
    with database.reading() as db:
        patient = _patient_of_rows(db, rows)
        if patient is None:
            return ""
        name = archive_on_shelf(utc_now(), patient.created)
        folders = [runs / run for run in _runs_here(db, patient.id)]
        own_rows, clinic = patient_rows(db, patient.id), clinic_name(db)
    require_room_for(folders, runs)
    target = shelf / name
    part = target.with_name(f".{target.name}.part")
    target.parent.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
    try:
        for step in archive_steps(clinic, own_rows, folders, None):
            step(part)
        with open_archive(part), part.open("rb") as written:
            os.fsync(written.fileno())
        part.replace(target)
        sync_folder(target.parent)
    finally:
        part.unlink(missing_ok=True)
    return name


def import_apart(
    clinic: Path, clinic_id: int, file: Path, person: str, runs: Path, unpacked: Path, shelf: Path | None
) -> Imported:
    """Import an archive in a process of its own, which then has little memory; `clinic` is the file of the database.

    Raises what `import_archive` raises.
    """
    limit_memory()
    try:
        with closing(Database(clinic)) as database, of_clinic(clinic_id):
            return import_archive(database, file, person, runs, unpacked, shelf)
    except MemoryError as error:
        raise _wrong(file, Text("archive-memory")) from error


def _add(
    database: Database,
    archive: OpenArchive,
    rows: Rows,
    person: str,
    unpacked: Path,
    runs: Path,
    shelf_file: str,
) -> Imported:
    """Add rows and recordings, in place of the patient of whom an archive was kept; all, or nothing is changed."""
    moved: list[Path] = []
    gone: frozenset[str] = frozenset()
    try:
        with database.transaction(closing=True) as db:
            try:
                imported, gone = _add_rows(db, archive, rows, person, shelf_file)
            except WrongRows as error:
                raise _wrong(archive.file, error) from error
            for folder in sorted(unpacked.iterdir()):
                target = runs / folder.name
                if target.exists():  # no row names it: an import was killed before its rows were stored
                    shutil.rmtree(target)
                folder.rename(target)
                moved.append(target)
            sync_folder(runs)
    except BaseException:
        for target in moved:
            shutil.rmtree(target, ignore_errors=True)
        raise
    for run in gone:
        shutil.rmtree(runs / run, ignore_errors=True)
    return imported


def _add_rows(
    db: Transaction, archive: OpenArchive, rows: Rows, person: str, shelf_file: str
) -> tuple[Imported, frozenset[str]]:
    """Add an archive's rows; return what came in, and the recordings that are no longer needed."""
    patient, listed = _patient_of_rows(db, rows), archive.listed
    before: frozenset[str] = frozenset()
    uploads: list[PatientFile] = []
    if patient is not None:
        if not shelf_file:  # somebody else imported the patient meanwhile
            raise PatientHere(Text("archive-patient-here", code=patient.code))
        _require_replaceable(db, patient, rows)
        before = _runs_here(db, patient.id)
        rows["patient"][0] |= {"code": patient.code, "pseudonym": patient.pseudonym}  # each clinic gives its own
        uploads = _remove_replaced_rows(db, patient.id)
    _require_new(db, rows)
    patient_id = add_patient_rows(db, rows)
    for upload in uploads:
        upload.patient_id = patient_id
        db.add(upload)
    _store_import(db, patient_id, listed.hash, listed.clinic, person)
    trials = sum(row["status"] == "done" and row["kept"] is True for row in rows["trial"])
    code = rows["patient"][0]["code"]
    details = {"archive": listed.hash, "sessions": len(rows["session"])} | (
        {"replaced": shelf_file} if shelf_file else {}
    )
    write_log(db, person, "archive imported", patient=patient_id, **details)
    imported = Imported(patient_id, code, not shelf_file, len(rows["session"]), trials, shelf_file)
    return imported, before - {row["id"] for row in rows["run"]}


def _earlier_import(db: Session, archive: str) -> Patient | None:
    """Return the patient that an archive brought, None when it was not imported here."""
    query = select(Patient).join(PatientImport, PatientImport.patient_id == Patient.id)
    return db.scalar(query.where(PatientImport.archive == archive))


def _patient_of_rows(db: Session, rows: Rows) -> Patient | None:
    """Return the patient of an archive's rows who is in the clinic already, None when there is none.

    A patient is known again by the moment at which the first clinic added the patient.
    """
    try:
        created = datetime.fromisoformat(rows["patient"][0]["created"]).astimezone(UTC)
    except (TypeError, ValueError, OverflowError):
        return None  # no date: the check of the rows says so when they are added
    return db.scalar(select(Patient).where(Patient.created == created).limit(1))


def _runs_here(db: Session, patient_id: int) -> frozenset[str]:
    """Return the recordings of a patient."""
    query = select(Run.id).join(PatientSession, PatientSession.id == Run.session_id)
    return frozenset(db.scalars(query.where(PatientSession.patient_id == patient_id)))


def _require_new(db: Session, rows: Rows) -> None:
    """Raise Conflict when the clinic has the patient's code or one of the recordings already."""
    _require_no_runs(db, [row["id"] for row in rows["run"]])
    code = rows["patient"][0]["code"]
    if db.scalar(select(Patient.id).where(Patient.code == code)) is not None:
        raise Conflict(Text("archive-code-taken", code=code))


def _store_import(db: Session, patient_id: int, archive: str, clinic: str, person: str) -> None:
    """Store that all sessions of a patient came with an archive of `clinic`."""
    row = PatientImport(patient_id=patient_id, archive=archive, clinic=clinic, person=person, at=utc_now())
    db.add(row)
    db.flush()
    for session in db.scalars(select(PatientSession.id).where(PatientSession.patient_id == patient_id)).all():
        db.add(ImportedSession(session_id=session, import_id=row.id))
    db.flush()


def _require_no_runs(db: Session, ids: list[str]) -> None:
    """Raise Conflict when one of these recordings is in the clinic."""
    here = select(Run.id).where(or_(Run.id.in_(ids), Run.folder.in_(ids))).limit(1)
    if db.scalar(here) is not None:
        raise Conflict(Text("archive-recordings-here"))


def _require_replaceable(db: Session, patient: Patient, rows: Rows) -> None:
    """Raise Conflict when a patient cannot be replaced by these rows of an archive."""
    own_runs = _runs_here(db, patient.id)
    _require_no_runs(db, [row["id"] for row in rows["run"] if row["id"] not in own_runs])
    of_patient = select(PatientSession.id).where(PatientSession.patient_id == patient.id)
    if db.scalar(of_patient.where(PatientSession.ended.is_(None)).limit(1)) is not None:
        raise Conflict(Text("archive-session-open", code=patient.code))
    incident = incident_of(db, patient.id)
    if incident is not None:
        raise Conflict(Text("archive-incident", code=patient.code, made=incident.made.date()))
    until = must_be_kept_until(db, patient)
    imported = select(ImportedSession.session_id)
    if until is not None and db.scalar(of_patient.where(PatientSession.id.not_in(imported)).limit(1)) is not None:
        raise Conflict(Text("archive-records-kept", code=patient.code, until=until.date()))


def _remove_replaced_rows(db: Session, patient_id: int) -> list[PatientFile]:
    """Remove all rows of a patient; return what says which uploads are theirs, for the patient who takes the place.

    No tombstone is made: the person is still a patient.
    """
    query = select(PatientFile).where(PatientFile.patient_id == patient_id)
    uploads = [PatientFile(name=row.name, current=row.current) for row in db.scalars(query)]
    connection = sqlite_connection(db)
    tables = metadata()
    rows = rows_of_patient(connection, tables, patient_id)
    store_last_ids(connection, tables, rows)
    erase_rows(connection, tables, rows)
    forget_in_lists(connection, patient_id)
    db.expunge_all()
    return uploads
