"""Verify the log by its chain of hashes and its head: edited, moved, inserted and removed rows are detected."""

import json
import logging
import os
import re
from collections.abc import Iterable, Mapping
from contextlib import closing
from dataclasses import dataclass
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path
from typing import Any
from zlib import crc32

from sqlalchemy.orm import Session

from app.file_modes import OWNER_FILE
from app.files import sync_folder
from app.store.schema import connect
from app.texts import Text

FIRST = "0" * 64  # previous hash of the first row
HEAD_BEGUN = "log head begun"  # from this row on, a removal of the newest rows is detected
LINE = 128  # bytes
WHOLE_LINE = re.compile(
    rb"(?P<content>(?P<rows>\d{1,15}) (?P<id>\d{1,19}) (?P<hash>[0-9a-f]{64})) (?P<check>[0-9a-f]{8}) *\n"
)
ROWS = "SELECT id, at, person, what, details, previous_hash, hash FROM log"

RawRow = Any  # id, at, person, what, details, previous_hash, hash as SQLite stores them


@dataclass(frozen=True, slots=True)
class ChainHead:
    """The number of rows of the log, and the id and hash of the newest row."""

    rows: int = 0
    id: int = 0
    hash: str = FIRST


class HeadFile:
    """The file beside the database that keeps the head.

    It is written after each commit that added rows. After a crash in between, the head lacks the rows of that commit,
    and is never ahead of the log. So rows that follow on the head raise no alarm; a head ahead of the log always does.

    The file has two lines of 128 bytes, `ROWS ID HASH CRC-32`. The valid line with more rows counts; the other one is
    overwritten in place. This needs no room on a full disk, and a power cut damages the new line at most.
    """

    def __init__(self, database: Path) -> None:
        self.file = database.with_name(f"{database.name}.log-head")

    def read(self) -> ChainHead | None:
        """Return the head, None when there is none that can be read."""
        return self._newest()[1]

    def write(self, head: ChainHead) -> None:
        """Write the head and wait until it is on the disk; raise OSError when that fails."""
        place, before = self._newest()
        content = f"{head.rows} {head.id} {head.hash}"
        line = f"{content} {crc32(content.encode()):08x}".ljust(LINE - 1).encode() + b"\n"
        descriptor = os.open(self.file, os.O_WRONLY | os.O_CREAT, OWNER_FILE)
        try:
            os.pwrite(descriptor, line, LINE * (1 - place))
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
        if before is None:
            sync_folder(self.file.parent)

    def _newest(self) -> tuple[int, ChainHead | None]:
        """Return the index of the line that counts (0 or 1) and its head; (1, None) when neither line is valid."""
        newest: tuple[int, ChainHead | None] = (1, None)
        try:
            content = self.file.read_bytes()
        except OSError:
            return newest
        for place in (0, 1):
            match = WHOLE_LINE.fullmatch(content[place * LINE : (place + 1) * LINE])
            if match and int(match["check"], 16) == crc32(match["content"]):
                head = ChainHead(int(match["rows"]), int(match["id"]), match["hash"].decode())
                if newest[1] is None or head.rows > newest[1].rows:
                    newest = (place, head)
        return newest

    def after(self, db: Session) -> ChainHead | None:
        """Return the head with the newest rows of `db`.

        None when they do not follow on the head in the file: then the file stays as evidence that the log was changed.
        """
        head = self.read()
        return None if head is None else advance(db, head)


def entry_hash(previous: str, at: datetime, person: str | None, what: str, details: Mapping[str, object]) -> str:
    """Return the hash of a row (hexadecimal SHA-256), which includes the hash of the row before."""
    content = json.dumps([previous, at.isoformat(), person, what, details], sort_keys=True, separators=(",", ":"))
    return sha256(content.encode()).hexdigest()


def advance(db: Session, head: ChainHead) -> ChainHead | None:
    """Return the head advanced over the rows added since; None when they do not follow on it."""
    connection = db.connection()
    if head.rows:
        stored = connection.exec_driver_sql("SELECT hash FROM log WHERE id = ?", (head.id,)).scalar()
        if stored != head.hash:
            return None
    for row in connection.exec_driver_sql(f"{ROWS} WHERE id > ? ORDER BY id", (head.id,)):
        if not _chains_on(head.hash, row):
            return None
        head = ChainHead(head.rows + 1, row[0], row[6])
    return head


def _chains_on(previous: str, row: RawRow) -> bool:
    """Return whether a row is valid and follows on `previous`; never raises, whatever the row contains."""
    _, at, person, what, details, previous_hash, own_hash = row
    try:
        moment = datetime.fromisoformat(at)
        expected = entry_hash(previous, moment.replace(tzinfo=UTC), person, what, json.loads(details))
        as_stored = moment.isoformat(" ", "microseconds")
    except (TypeError, ValueError, RecursionError):
        return False
    return bool(previous_hash == previous and own_hash == expected and at == as_stored)


@dataclass(frozen=True, slots=True)
class LogCheck:
    """The result of a check of the whole log."""

    whole: bool
    rows: int  # number of valid rows, from the first
    message: Text  # the finding in sentences


def verify_log(database: Path) -> LogCheck:
    """Check every row of the log, and the newest ones against the head; write nothing.

    Raises
    ------
    sqlite3.DatabaseError
        When there is no log in the file.
    """
    head = HeadFile(database).read()  # read before the rows: rows added meanwhile follow on it
    with closing(connect(database)) as connection:
        connection.text_factory = lambda text: text.decode(errors="replace")
        return _check(head, connection.execute(f"{ROWS} ORDER BY id"))


def warn_of_changed_log(database: Path) -> None:
    """Warn on the console when the log was changed; the owner's settings page shows it, too."""
    check = verify_log(database)
    if not check.whole:
        logging.getLogger("bodydrive").warning("%s", check.message)


def _check(head: ChainHead | None, rows: Iterable[RawRow]) -> LogCheck:
    count, newest, hash_at_head, begun = 0, FIRST, FIRST, None
    for row in rows:
        if not _chains_on(newest, row):
            return LogCheck(False, count, Text("logs-row-changed", row=str(row[0])))
        count, newest = count + 1, row[6]
        if head is not None and count == head.rows:
            hash_at_head = newest
        if row[3] == HEAD_BEGUN:
            begun = Text("logs-head-begun", row=count, day=datetime.fromisoformat(row[1]).date())
    if head is None:
        return LogCheck(False, count, Text("logs-head-missing")) if count else LogCheck(True, 0, Text("logs-empty"))
    if head.rows > count:
        return LogCheck(False, count, Text("logs-newest-removed", left=count, rows=head.rows))
    if head.hash != hash_at_head:
        return LogCheck(False, count, Text("logs-rows-exchanged", rows=head.rows))
    message = Text("logs-whole", rows=count)
    if late := count - head.rows:
        message = Text("logs-sentences", first=message, second=Text("logs-head-behind", rows=late))
    if begun is not None:
        message = Text("logs-sentences", first=message, second=begun)
    return LogCheck(True, count, message)
