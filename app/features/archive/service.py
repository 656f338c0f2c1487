"""Make the archive of a patient, recording by recording; first look whether there is room for it.

`archive.json` has the hash of every file. A zip file's directory stands at its end, and names its files in any order:
so `archive.json` is written last and named first. Each recording is read once, and a browser or a proxy that waits for
the archive gets the first bytes before any recording was read.
"""

import json
import zipfile
from collections.abc import Callable
from functools import partial
from hashlib import sha256
from pathlib import Path
from typing import Any, NamedTuple

from sqlalchemy.orm import Session

from app.features.archive.archive_file import (
    CHUNK,
    LIST,
    PATIENT,
    REPORT,
    RUN_FILE,
    ArchiveList,
    FileEntry,
    entry_of,
    hash_of,
    open_archive,
)
from app.features.archive.patient_rows import Rows, patient_rows
from app.package import Step, entry
from app.refusals import Conflict, DiskFull
from app.store.access.visible_patients import own_clinic_id
from app.store.consent import require_consent
from app.store.database import Database
from app.store.files.room_for_files import room_refusal
from app.store.log import write_log
from app.store.patients import find_patient
from app.store.runs import run_ids
from app.store.tables import Clinic
from app.texts import Text

MakeReport = Callable[[], bytes]


def archive_steps(clinic: str, tables: Any, folders: list[Path], make_report: MakeReport | None) -> list[Step]:
    """Return the steps that write an archive of a patient's rows and of the recordings in `folders`.

    They are called one after the other with the file to be made: the first writes the documents, one for each folder
    its recording, the last the list. `make_report` returns the content of `report.html`; None: there is no report.
    """
    begin = partial(_begin, tables, make_report)
    recordings = (partial(_add_recording, folder) for folder in sorted(folders))
    return [begin, *recordings, partial(_add_list, clinic)]


def recorded_files(folder: Path) -> list[tuple[str, Path]]:
    """Return the files of a recording that belong to an archive, with their names in it."""
    named = [(f"runs/{folder.name}/{file.name}", file) for file in sorted(folder.glob("*"))]
    return [(name, file) for name, file in named if RUN_FILE.fullmatch(name)]


def _begin(tables: Any, make_report: MakeReport | None, package: Path) -> int:
    contents = {PATIENT: json.dumps({"tables": tables}, indent=1, sort_keys=True, ensure_ascii=False).encode()}
    if make_report is not None:
        contents[REPORT] = make_report()
    package.unlink(missing_ok=True)
    with zipfile.ZipFile(package, "x") as opened:
        for name, content in contents.items():
            info = entry(name)
            info.comment = entry_of(content).sha256.encode()
            opened.writestr(info, content)
        return opened.start_dir


def _add_recording(folder: Path, package: Path) -> int:
    with zipfile.ZipFile(package, "a") as opened:
        for name, file in recorded_files(folder):
            _add(opened, file, name)
        return opened.start_dir


def _add(package: zipfile.ZipFile, file: Path, name: str) -> None:
    """Add a file as it is; its hash stands in the comment of its entry until the list is written."""
    info = entry(name)
    info.compress_type = zipfile.ZIP_STORED
    digest = sha256()
    with file.open("rb") as source, package.open(info, "w", force_zip64=True) as target:
        while chunk := source.read(CHUNK):
            digest.update(chunk)
            target.write(chunk)
    info.comment = digest.hexdigest().encode()


def _add_list(clinic: str, package: Path) -> int:
    with zipfile.ZipFile(package, "a") as opened:
        files = {}
        for info in opened.filelist:
            files[info.filename] = FileEntry(bytes=info.file_size, sha256=info.comment.decode())
            info.comment = b""
        report = files.pop(REPORT, None)
        listed = ArchiveList(clinic=clinic, hash=hash_of(files), files=files, report=report)
        opened.writestr(entry(LIST), listed.model_dump_json(indent=1))
        opened.filelist.insert(0, opened.filelist.pop())  # the directory names the list first
        return opened.start_dir


class ArchiveRoom(NamedTuple):
    """How large the recordings of an archive are, and why there is no room for them; None when there is."""

    bytes: int
    message: Text | None


def archive_room(database: Database, patient_id: int, runs: Path, place: Path) -> ArchiveRoom:
    """Return whether the archive of a patient can be made in the folder `place`; `runs` has all recordings.

    NotFound when there is no such patient.
    """
    with database.reading() as db:
        find_patient(db, patient_id)
        folders = [runs / run_id for run_id in run_ids(db, patient_id)]
    return room_for(folders, place)


def room_for(folders: list[Path], place: Path) -> ArchiveRoom:
    """Return whether an archive of the recordings in `folders` can be made in `place`: recording goes on beside it."""
    size = sum(file.stat().st_size for folder in folders for _, file in recorded_files(folder))
    return ArchiveRoom(size, room_refusal("archive", size, place))


def require_room_for(folders: list[Path], place: Path) -> None:
    """Raise DiskFull when an archive of the recordings in `folders` has no room in `place`."""
    message = room_for(folders, place).message
    if message is not None:
        raise DiskFull(message)


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


def clinic_name(db: Session) -> str:
    """Return the name of a clinic."""
    return db.get_one(Clinic, own_clinic_id(db)).name


def archive_material(database: Database, patient_id: int, person: str, runs: Path, place: Path) -> ArchiveMaterial:
    """Return what the archive of a patient is made from; log that `person` makes it, in the folder `place`.

    `runs` is the folder of all recordings. NotFound when there is no such patient; Conflict without consent, or while
    a session of the patient is open; DiskFull when the disk of `place` has no room for it.
    """
    with database.transaction() as db:
        find_patient(db, patient_id)
        require_consent(db, patient_id, "sharing")
        rows = patient_rows(db, patient_id)
        clinic = clinic_name(db)
        if any(row["ended"] is None for row in rows["session"]):
            raise Conflict(Text("archive-session-here"))
        folders = [runs / str(row["id"]) for row in rows["run"]]
        require_room_for(folders, place)
        write_log(db, person, "export", patient=patient_id, session=None, form="archive", runs=len(rows["run"]))
    return ArchiveMaterial(clinic, rows, folders)


def make_archive(
    database: Database,
    patient_id: int,
    person: str,
    runs: Path,
    package: Path,
    make_report: MakeReport | None = None,
) -> str:
    """Write the archive of a patient to `package` and return its hash; raises what `archive_material` raises."""
    material = archive_material(database, patient_id, person, runs, package.parent)
    for step in material.steps(make_report):
        step(package)
    with open_archive(package) as archive:
        return archive.listed.hash
