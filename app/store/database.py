"""Open the database: SQLite with its settings and migrations, one transaction that writes at a time."""

import logging
import sqlite3
import threading
from collections.abc import Iterator
from contextlib import closing as closing_connection
from contextlib import contextmanager
from pathlib import Path

from sqlalchemy import Connection, Engine, create_engine, event
from sqlalchemy.exc import DatabaseError
from sqlalchemy.orm import Session

from app.features.registration import features
from app.file_modes import OWNER_FILE, OWNER_FOLDER
from app.refusals import NO_ROOM, DiskFull, Unavailable
from app.store.access.visible_patients import restrict
from app.store.files.ballast import Ballast
from app.store.keeping import last_ids  # noqa: F401  (new rows take no id of an erased one)
from app.store.log import HAS_NEW_ROWS, write_log
from app.store.log_chain import HEAD_BEGUN, ChainHead, HeadFile, advance
from app.store.schema import bring_up_to_date
from app.texts import Text

# Error codes that SQLite may also report on a full disk: a file cannot grow or be created, a quota is used up.
NO_ROOM_PERHAPS = {sqlite3.SQLITE_IOERR, sqlite3.SQLITE_CANTOPEN}
BUSY_TIMEOUT = 5000  # ms; another program (a backup) may hold the file for a moment
PRAGMAS = (
    *("journal_mode=WAL", "synchronous=FULL", "foreign_keys=ON", f"busy_timeout={BUSY_TIMEOUT}"),
    "secure_delete=ON",  # what is deleted is overwritten: no word of an erased patient stays in the file
)


def make_engine(file: Path, *, writes: bool = True) -> Engine:
    """Return an engine on `file`; every connection is durable (WAL, FULL) and checks foreign keys.

    One that does not write sees the database as it was when a transaction began, and has a connection for each thread.
    """
    engine = create_engine(f"sqlite:///{file}", max_overflow=10 if writes else -1)
    pragmas = PRAGMAS if writes else (*PRAGMAS, "query_only=ON")

    @event.listens_for(engine, "connect")
    def _prepare(connection: sqlite3.Connection, _record: object) -> None:
        connection.isolation_level = None  # we begin transactions ourselves, below
        cursor = connection.cursor()
        for pragma in pragmas:
            cursor.execute(f"PRAGMA {pragma}")
        cursor.close()

    @event.listens_for(engine, "begin")
    def _begin(connection: Connection) -> None:
        # Lock at once: otherwise a transaction that reads first could be refused when it begins to write.
        connection.exec_driver_sql("BEGIN IMMEDIATE" if writes else "BEGIN")

    return engine


logger = logging.getLogger("bodydrive")

Transaction = Session
"""The database session that the functions of the store take as `db`."""


class Database:
    """The clinic's database, brought to the newest schema when it is opened; Refusal when it cannot be.

    The head of the log lies beside its file, and the ballast, once it has been allocated.
    """

    def __init__(self, file: Path) -> None:
        features()  # their tables belong to the schema
        file.parent.mkdir(mode=OWNER_FOLDER, parents=True, exist_ok=True)
        self.ballast = Ballast(file.with_name(f"{file.name}.ballast"))
        self._head_file = HeadFile(file)
        self._engine = make_engine(file)
        self._reader = make_engine(file, writes=False)
        self._one_at_a_time = threading.Lock()
        self.ballast.make_room()
        try:
            with self._as_refusals():
                if not file.exists():
                    file.touch(OWNER_FILE)
                bring_up_to_date(file, self._engine)
            self._open_head()
        except BaseException:
            self.close()
            raise

    @contextmanager
    def reading(self) -> Iterator[Transaction]:
        """Yield a database session that cannot write; it waits for no transaction, and none waits for it.

        It shows the patients of who asks, as `transaction`.

        Raises
        ------
        Unavailable
            When the file is damaged.
        """
        with self._as_refusals(), Session(self._reader, expire_on_commit=False) as db, db.begin():
            restrict(db)
            yield db

    @contextmanager
    def transaction(self, *, closing: bool = False) -> Iterator[Transaction]:
        """Yield a database session: its changes are committed together, or rolled back when an exception is raised.

        It shows the patients of who asks, and what is theirs (`app/store/access/visible_patients.py`).

        `closing`: this transaction must succeed on a full disk, too, and may use the ballast: it ends something, signs
        somebody in or out, or only logs what has happened anyway.

        Raises
        ------
        DiskFull
            When there is no room for what was done in it.
        Unavailable
            When another program holds the file for too long, or it is damaged.
        """
        if closing:
            self.ballast.make_room()
        with self._as_refusals(), self._one_at_a_time:
            with Session(self._engine, expire_on_commit=False) as db, db.begin():
                restrict(db)
                for feature in features().values():
                    feature.begin(db)
                yield db
                head = self._head_file.after(db) if HAS_NEW_ROWS in db.info else None
            if head is not None:
                self._write_head(head)

    def empty_write_ahead_log(self) -> None:
        """Move the write-ahead log into the database, and empty its file, in which deleted rows may still stand.

        Raises
        ------
        Unavailable
            When somebody reads in the database for longer than BUSY_TIMEOUT. The end of the program empties it then.
        """
        with self._as_refusals(), self._one_at_a_time, closing_connection(self._engine.raw_connection()) as connection:
            [(busy, *_)] = connection.cursor().execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchall()
        if busy:
            raise Unavailable(Text("store-erased-but-read"))

    def close(self) -> None:
        """Close every connection."""
        self._engine.dispose()
        self._reader.dispose()

    def _open_head(self) -> None:
        """Bring the head of the log to its newest row, and log it when the head was missing or behind."""
        with self.transaction(closing=True) as db:
            head = self._head_file.read()
            newest = advance(db, head or ChainHead())
            if head is None and newest is not None:
                self._write_head(newest)
                if newest.rows:
                    write_log(db, None, HEAD_BEGUN, rows=newest.rows)
            elif head is not None and newest is not None and newest != head:
                write_log(db, None, "log head behind", rows=newest.rows - head.rows)

    def _write_head(self, head: ChainHead) -> None:
        try:
            self._head_file.write(head)
        except OSError:
            self.ballast.make_room()
            try:
                self._head_file.write(head)
            except OSError:  # a head behind the log raises no alarm, and the next row updates it
                logger.exception("The head of the log could not be written")

    @contextmanager
    def _as_refusals(self) -> Iterator[None]:
        """Turn database errors that a person can resolve into refusals with a sentence."""
        try:
            yield
        except (DatabaseError, sqlite3.DatabaseError) as error:
            code = getattr(getattr(error, "orig", error), "sqlite_errorcode", 0) & 0xFF  # the upper bits hold details
            if code == sqlite3.SQLITE_FULL or (code in NO_ROOM_PERHAPS and not self.ballast.has_room()):
                raise DiskFull(NO_ROOM) from error
            if code in {sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED}:
                raise Unavailable(Text("store-database-held")) from error
            if code in {sqlite3.SQLITE_NOTADB, sqlite3.SQLITE_CORRUPT}:
                raise Unavailable(Text("store-database-damaged")) from error
            raise
