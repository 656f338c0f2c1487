"""The archive of a whole patient: made in one clinic, imported in another one."""

import shutil
from contextlib import closing, nullcontext
from pathlib import Path
from typing import Any, NamedTuple

from pydantic import ValidationError

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.disk_room import ROOM_TO_RECORD
from app.exports.archive_file import RUN_ID, MakeReport, OpenArchive, archive_steps, open_archive
from app.exports.archive_room import require_room_for
from app.exports.package import Step
from app.file_modes import OWNER_FOLDER
from app.files import sync_folder
from app.isolated_reader import limit_memory
from app.refusals import NO_ROOM, Conflict, DiskFull
from app.scoring.interface_test.interface_measures import check_documents
from app.store.database import Database, Transaction
from app.store.files.disk_watch import disk_room
from app.store.files.passing_folder import passing_folder
from app.store.log import write_log
from app.store.patients import find_patient
from app.store.records.consents import require_consent
from app.store.records.imports import (
    clinic_name,
    earlier_import,
    note_import,
    patient_of_rows,
    require_mergeable,
    require_new,
    runs_here,
)
from app.store.records.patient_merge import add_missing_rows
from app.store.records.patient_rows import Rows, WrongRows, add_patient_rows, check_rows, patient_rows
from app.visible_text import visible_line, visible_lines

WRONG = "{file}: this archive cannot be read, because {why}; nothing was imported."
OPEN = "A session of this patient is open: end it first, then make the archive."


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


class ArchiveMaterial(NamedTuple):
    """Everything that the archive of a patient is made from."""

    clinic: str  # its name
    rows: Rows
    folders: list[Path]  # of the recordings

    def steps(self, make_report: MakeReport | None) -> list[Step]:
        """Return the steps that write the archive, to be called one after the other with the file to be made.

        `make_report` returns the report of the patient's course as HTML; None: the archive has no report.
        """
        return archive_steps(self.clinic, self.rows, self.folders, make_report)


def archive_material(
    database: Database, clinic_id: int, patient_id: int, person: str, runs: Path, place: Path
) -> ArchiveMaterial:
    """Return what the archive of a patient is made from; log that `person` makes it, in the folder `place`.

    `runs` is the folder of all recordings. NotFound when there is no such patient; Conflict without consent, or while
    a session of the patient is open; DiskFull when the disk of `place` has no room for it.
    """
    with database.transaction() as db:
        find_patient(db, clinic_id, patient_id)
        require_consent(db, patient_id, "sharing")
        rows = patient_rows(db, patient_id)
        clinic = clinic_name(db, clinic_id)
        if any(row["ended"] is None for row in rows["session"]):
            raise Conflict(OPEN)
        folders = [runs / str(row["id"]) for row in rows["run"]]
        require_room_for(folders, place)
        write_log(db, person, "export", patient=patient_id, session=None, form="archive", runs=len(rows["run"]))
    return ArchiveMaterial(clinic, rows, folders)


def make_archive(
    database: Database,
    clinic_id: int,
    patient_id: int,
    person: str,
    runs: Path,
    package: Path,
    make_report: MakeReport | None = None,
) -> str:
    """Write the archive of a patient to `package` and return its hash; raises what `archive_material` raises."""
    material = archive_material(database, clinic_id, patient_id, person, runs, package.parent)
    for step in material.steps(make_report):
        step(package)
    with open_archive(package) as made:
        return made.listed.hash


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
        rows = _checked(archive, file)
        with database.transaction() as db:
            patient = patient_of_rows(db, clinic_id, rows)
            here = frozenset() if patient is None else runs_here(db, patient.id)
        if disk_room(runs.parent).free < archive.recording_bytes(here) + ROOM_TO_RECORD:
            raise DiskFull(NO_ROOM)
        runs.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
        with passing_folder(runs.parent, "import") if unpacked is None else nullcontext(unpacked) as folder:
            folder.mkdir(mode=OWNER_FOLDER, exist_ok=True)
            archive.unpack_recordings(folder, here)
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


def _checked(archive: OpenArchive, file: Path) -> Rows:
    document = archive.patient()
    try:
        rows = check_rows(document.get("tables") if isinstance(document, dict) else None)
        _check_contents(rows, archive)
    except (WrongRows, ValidationError, TypeError, KeyError) as error:
        why = str(error) if isinstance(error, WrongRows) else "one of its documents has another form"
        raise ValueError(WRONG.format(file=file, why=why)) from error
    except ValueError as error:
        raise ValueError(WRONG.format(file=file, why=f"a text in it is refused: {error}")) from error
    return rows


def _check_contents(rows: Rows, archive: OpenArchive) -> None:
    """Raise WrongRows or ValueError for documents and texts that this program would not have stored."""
    patient = rows["patient"][0]
    for name in ("code", "pseudonym"):
        visible_line(patient[name])
    visible_lines(patient["note"])
    visible_line(archive.listed.clinic)
    runs = [row["id"] for row in rows["run"]]
    if len(runs) != len(set(runs)) or not all(RUN_ID.fullmatch(run) for run in runs):
        raise WrongRows("its recordings have wrong names")
    if not {name.split("/")[1] for name in archive.listed.files if "/" in name} <= set(runs):
        raise WrongRows("it has a recording that no row names")
    for row in rows["moment_comment"]:
        if not row["author"]:
            raise WrongRows("a comment in it has no author")
        visible_line(row["author"])
    for row in rows["comment_revision"]:
        visible_lines(row["text"])
    for row in rows["interface_test"]:
        check_documents(row["plan"], row["measures"], row["workload"])
    profiles: dict[Any, Any] = {}
    for row in rows["profile"]:
        profiles[row["id"]] = CalibrationProfile.model_validate(row["document"]).model_dump(mode="json")
    for row in rows["parameters"]:
        DriveParameters.model_validate({**row["settings"], "profile": profiles[row["profile_id"]]})


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
