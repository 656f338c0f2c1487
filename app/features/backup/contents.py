"""What of a clinic's folder goes into a backup: the database's copy, recordings, uploads, and the keys on request."""

import os
import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from app.clock import utc_now
from app.features.backup.manifest import DATABASE
from app.file_modes import OWNER_FOLDER
from app.recording.format import END_FILE
from app.refusals import Refusal
from app.settings import Settings
from app.store.backup import Counts, back_up
from app.store.keeping.passed_time import passed_of
from app.store.people import mark_of
from app.texts import Text

GOING_ON = 60.0  # s: an unfinished recording that was written to within this time is going on
HEAD = f"{DATABASE}.log-head"


@dataclass(frozen=True, slots=True)
class BackupFile:
    """A file that is to be backed up."""

    path: str  # within the backup
    file: Path
    size: int
    changed: int  # ns since 1970


@dataclass(frozen=True, slots=True)
class Contents:
    """All that is to be backed up."""

    sources: tuple[BackupFile, ...]
    rows: Counts
    left_out: tuple[str, ...]
    passed: datetime  # up to which time has really passed, wherever the clock was set to


@contextmanager
def contents_of(settings: Settings, *, with_keys: bool) -> Iterator[Contents]:
    """Copy and check the database, list everything else, and yield it; the copy is removed afterwards.

    The head of the log is read before the database: rows that are added meanwhile follow on it. So are the
    tombstones: a patient who is erased meanwhile is in both or in none.

    Raises
    ------
    Refusal, OSError
        When there is no clinic, when another backup is being made, or when the copy cannot be made.
    """
    _require_clinic(settings)
    work = settings.backup / "work"
    shutil.rmtree(work, ignore_errors=True)  # of a backup that was interrupted
    work.mkdir(mode=OWNER_FOLDER, parents=True)
    try:
        beside = [_copied(file, work) for file in (_head_of(settings), settings.erased) if file.is_file()]
        copy = back_up(settings.database, work, "copy")
        copy.file.rename(work / DATABASE)
        left_out: list[str] = []
        folders = [settings.runs, settings.files, settings.models, settings.floorplans, settings.replaced]
        folders += [settings.keys, settings.authority, settings.signing] if with_keys else []
        listed = [source for folder in folders for source in _listed(settings, folder, left_out)]
        sources = [_source(work / DATABASE, DATABASE), *(_source(file, file.name) for file in beside)]
        yield Contents((*sources, *listed), copy.rows, tuple(left_out), passed_of(work / DATABASE))
    finally:
        shutil.rmtree(work, ignore_errors=True)


def clinic_mark(settings: Settings) -> str:
    """Return what tells this clinic from all others, also after it was restored: the hash of when it was set up.

    Refusal when there is no clinic, or none that is set up.
    """
    _require_clinic(settings)
    with closing(sqlite3.connect(settings.database)) as connection:
        created = connection.execute("SELECT created FROM clinic ORDER BY id LIMIT 1").fetchone()
    if created is None:
        raise Refusal(Text("backups-not-set-up", folder=str(settings.state)))
    return mark_of(created[0])


def _require_clinic(settings: Settings) -> None:
    if not settings.database.is_file():
        raise Refusal(Text("backups-no-clinic", folder=str(settings.state)))


def _head_of(settings: Settings) -> Path:
    return settings.database.with_name(HEAD)


def _copied(file: Path, work: Path) -> Path:
    return Path(shutil.copyfile(file, work / file.name))


def _listed(settings: Settings, folder: Path, left_out: list[str]) -> Iterator[BackupFile]:
    """Yield the files below a folder, in a fixed order; of the recordings, those that are not going on."""
    for place, folders, files in os.walk(folder):
        here = Path(place)
        folders.sort()
        if folder == settings.runs and _is_going_on(here, files):
            left_out.append(here.name)
            continue
        for name in sorted(files):
            file = here / name
            if not name.endswith(".part") and file.is_file() and not file.is_symlink():
                yield _source(file, file.relative_to(settings.state).as_posix())


def _is_going_on(folder: Path, files: list[str]) -> bool:
    """Return whether a recording is being written: it is not closed, and was written to just now."""
    if not files or END_FILE in files:
        return False
    newest = max((folder / name).stat().st_mtime for name in files)
    return utc_now().timestamp() - newest < GOING_ON


def _source(file: Path, path: str) -> BackupFile:
    status = file.stat()
    return BackupFile(path, file, status.st_size, status.st_mtime_ns)
