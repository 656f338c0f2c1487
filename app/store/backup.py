"""Copy the database while it is in use: verified, readable by its owner only."""

import os
import shutil
import sqlite3
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

from app.clock import utc_now
from app.file_modes import OWNER_FILE
from app.files import sync_folder
from app.refusals import DiskFull, Unavailable
from app.texts import Figure, Text

SLACK = 4_000_000  # bytes that must stay free beside a copy
PAGES_AT_ONCE = 256  # 1 MB: between two steps others may use the file
BUSY_LIMIT = 5.0  # s to wait for another program that writes to the database

Counts = dict[str, int]


@dataclass(frozen=True, slots=True)
class Backup:
    """A verified copy of the database."""

    file: Path
    rows: Counts  # of each table


def back_up(database: Path, folder: Path, label: str) -> Backup:
    """Copy `database` into `folder` by SQLite's backup function, verify the copy and return it.

    The copy is one file, `NAME.LABEL.DATE.backup`, and can take the place of the database unchanged. It appears under
    this name only when its integrity check passed and each of its tables has as many rows as the original.

    Raises
    ------
    DiskFull
        When there is no room for it.
    Unavailable
        When the copy is not equal to the original.
    OSError, sqlite3.Error
        When `database` cannot be read or the copy cannot be written. No copy is left behind in any of these cases.
    """
    target = folder / f"{database.name}.{label}.{utc_now():%Y-%m-%dT%H-%M-%S-%f}Z.backup"
    part = target.with_name(f".{target.name}.part")
    with closing(sqlite3.connect(database, timeout=BUSY_LIMIT, isolation_level=None)) as source:
        source.execute("BEGIN")  # all that follows sees one state of the database, even if another program writes
        size = _count(source, "PRAGMA page_count") * _count(source, "PRAGMA page_size")
        _require_room(folder, size)
        try:
            os.close(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, OWNER_FILE))
            with closing(sqlite3.connect(part, isolation_level=None)) as copy:
                source.backup(copy, pages=PAGES_AT_ONCE)
                copy.execute("PRAGMA journal_mode=DELETE")  # one file, without a write-ahead log beside it
                complaint, rows = _text(copy, "PRAGMA integrity_check"), _counts(copy)
            if complaint != "ok" or rows != _counts(source):
                raise Unavailable(Text("store-copy-unequal", database=str(database)))
            _sync(part)
            part.replace(target)
        finally:
            part.unlink(missing_ok=True)
    sync_folder(folder)
    return Backup(target, rows)


def _require_room(folder: Path, size: int) -> None:
    free = shutil.disk_usage(folder).free
    if free < size + SLACK:
        raise DiskFull(Text("store-copy-no-room", needed=Figure((size + SLACK) / 1e6), folder=str(folder)))


def _counts(connection: sqlite3.Connection) -> Counts:
    names = connection.execute("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name").fetchall()
    return {name: _count(connection, f'SELECT COUNT(*) FROM "{name}"') for (name,) in names}  # noqa: S608


def _text(connection: sqlite3.Connection, query: str) -> str:
    text: str = connection.execute(query).fetchone()[0]
    return text


def _count(connection: sqlite3.Connection, query: str) -> int:
    count: int = connection.execute(query).fetchone()[0]
    return count


def _sync(file: Path) -> None:
    with file.open("rb") as opened:
        os.fsync(opened.fileno())
