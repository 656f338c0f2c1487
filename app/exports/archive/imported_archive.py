"""Imports the archive of a patient that another clinic has made, or this one."""

import shutil
from contextlib import closing, nullcontext
from pathlib import Path
from typing import NamedTuple

from app.disk_room import ROOM_TO_RECORD
from app.exports.archive.archive_contents import WRONG, checked_rows
from app.exports.archive.archived_recordings import wrong_recording
from app.exports.archive.open_archive import OpenArchive, open_archive
from app.file_modes import OWNER_FOLDER
from app.files import sync_folder
from app.isolated_reader import limit_memory
from app.refusals import NO_ROOM, DiskFull
from app.store.database import Database, Transaction
from app.store.files.disk_watch import disk_room
from app.store.files.passing_folder import passing_folder
from app.store.log import write_log
from app.store.records.imports import (
    earlier_import,
    note_import,
    patient_of_rows,
    require_mergeable,
    require_new,
    runs_here,
)
from app.store.records.patient_merge import add_missing_rows
from app.store.records.patient_rows import Rows, WrongRows, add_patient_rows


class Imported(NamedTuple):
    """The patient of an archive, whether the import added it, and how much came in with it.

    A patient who is not new was imported before; then only what was missing came in, or nothing.
    """

    patient_id: int
    code: str
    is_new: bool
    sessions: int = 0
    trials: int = 0  # finished and kept
    comments: int = 0


def import_archive(
    database: Database, clinic_id: int, file: Path, person: str, runs: Path, unpacked: Path | None = None
) -> Imported:
    """Import the archive in `file`; one that was imported before changes nothing.

    A newer archive of a patient who came with an earlier one adds what is missing here.

    Its recordings are unpacked in `unpacked`, a folder on the disk of `runs` that is made; without one, in a folder
    that is removed.

    Raises
    ------
    ValueError
        One sentence, when the file is no archive, damaged, hostile, or of a newer program.
    Conflict, DiskFull
        When the code or a recording is in the clinic already, or there is no room.
    """
    with open_archive(file) as archive:
        with database.transaction() as db:
            known = earlier_import(db, clinic_id, archive.listed.hash)
            if known is not None:
                return Imported(known.id, known.code, is_new=False)
        rows = checked_rows(archive)
        with database.transaction() as db:
            patient = patient_of_rows(db, clinic_id, rows)
            here = frozenset() if patient is None else runs_here(db, patient.id)
        if disk_room(runs.parent).free < archive.recording_bytes(here) + ROOM_TO_RECORD:
            raise DiskFull(NO_ROOM)
        runs.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
        with passing_folder(runs.parent, "import") if unpacked is None else nullcontext(unpacked) as folder:
            folder.mkdir(mode=OWNER_FOLDER, exist_ok=True)
            archive.unpack_recordings(folder, here)
            wrong = next(filter(None, map(wrong_recording, sorted(folder.iterdir()))), "")
            if wrong:
                raise ValueError(WRONG.format(file=archive.file, why=wrong))
            return _add(database, clinic_id, archive, rows, person, folder, runs)


def import_apart(clinic: Path, clinic_id: int, file: Path, person: str, runs: Path, unpacked: Path) -> Imported:
    """Import an archive in a process of its own, which then has little memory; `clinic` is the file of the database.

    Raises what `import_archive` raises.
    """
    limit_memory()
    try:
        with closing(Database(clinic)) as database:
            return import_archive(database, clinic_id, file, person, runs, unpacked)
    except MemoryError as error:
        raise ValueError(WRONG.format(file=file, why="it needs too much memory")) from error


def _add(
    database: Database, clinic_id: int, archive: OpenArchive, rows: Rows, person: str, unpacked: Path, runs: Path
) -> Imported:
    """Add rows and recordings; when one cannot be added, none is."""
    moved: list[Path] = []
    try:
        with database.transaction() as db:
            try:
                imported, new = _add_rows(db, clinic_id, archive, rows, person)
            except WrongRows as error:
                raise ValueError(WRONG.format(file=archive.file, why=error)) from error
            for folder in sorted(unpacked.iterdir()):
                if folder.name not in new:
                    continue
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
    return imported


def _add_rows(
    db: Transaction, clinic_id: int, archive: OpenArchive, rows: Rows, person: str
) -> tuple[Imported, frozenset[str]]:
    """Add what is missing of an archive's rows; return what came in, and the new recordings."""
    patient = patient_of_rows(db, clinic_id, rows)
    listed = archive.listed
    if patient is not None:
        require_mergeable(db, patient, rows)
        added = add_missing_rows(db, clinic_id, patient.id, rows)
        note_import(db, patient.id, listed.hash, listed.clinic, person, added.sessions)
        imported = Imported(patient.id, patient.code, False, len(added.sessions), added.trials, added.comments)
        new = added.runs
    else:
        require_new(db, clinic_id, rows)
        patient_id = add_patient_rows(db, clinic_id, rows)
        note_import(db, patient_id, listed.hash, listed.clinic, person)
        trials = sum(row["status"] == "done" and row["kept"] is True for row in rows["trial"])
        counts = len(rows["session"]), trials, len(rows["moment_comment"])
        imported = Imported(patient_id, rows["patient"][0]["code"], True, *counts)
        new = frozenset(row["id"] for row in rows["run"])
    details = {"archive": listed.hash, "sessions": imported.sessions}
    write_log(db, person, "archive imported", patient=imported.patient_id, **details)
    return imported, new
