"""Whether the disk has room for the archive of a patient, before it is made."""

from pathlib import Path
from typing import NamedTuple

from app.exports.archive.archive_writing import recorded_files
from app.refusals import DiskFull
from app.store.database import Database
from app.store.files.room_to_make import words_without_room
from app.store.patients import find_patient
from app.store.runs import run_ids


class ArchiveRoom(NamedTuple):
    """How large the recordings of an archive are, and why there is no room for them; no words when there is."""

    bytes: int
    words: str


def archive_room(database: Database, clinic_id: int, patient_id: int, runs: Path, place: Path) -> ArchiveRoom:
    """Return whether the archive of a patient can be made in the folder `place`; `runs` has all recordings.

    NotFound when there is no such patient.
    """
    with database.transaction() as db:
        find_patient(db, clinic_id, patient_id)
        folders = [runs / one for one in run_ids(db, patient_id)]
    return room_for(folders, place)


def room_for(folders: list[Path], place: Path) -> ArchiveRoom:
    """Return whether an archive of the recordings in `folders` can be made in `place`: recording goes on beside it."""
    size = sum(file.stat().st_size for folder in folders for _, file in recorded_files(folder))
    return ArchiveRoom(size, words_without_room("archive", size, place))


def require_room_for(folders: list[Path], place: Path) -> None:
    """Raise DiskFull when an archive of the recordings in `folders` has no room in `place`."""
    words = room_for(folders, place).words
    if words:
        raise DiskFull(words)
