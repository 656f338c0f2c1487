"""The one place that opens the database: SQLite, its settings, its migrations, one writer at a time."""

import sqlite3
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from alembic import command
from alembic.config import Config
from sqlalchemy import Engine, create_engine, event
from sqlalchemy.exc import DatabaseError
from sqlalchemy.orm import Session

from app.session.refusals import NO_ROOM, Full, Unavailable

MIGRATIONS = Path(__file__).parent / "migrations"
BUSY_TIMEOUT = 5000  # ms; another program (a backup) may hold the file for a moment


def make_engine(file: Path) -> Engine:
    """Return an engine on `file`; every connection is durable (WAL, FULL) and keeps its references whole."""
    engine = create_engine(f"sqlite:///{file}")

    @event.listens_for(engine, "connect")
    def _prepare(connection: Any, _record: object) -> None:
        connection.isolation_level = None  # we begin transactions ourselves, below
        cursor = connection.cursor()
        for pragma in ("journal_mode=WAL", "synchronous=FULL", "foreign_keys=ON", f"busy_timeout={BUSY_TIMEOUT}"):
            cursor.execute(f"PRAGMA {pragma}")
        cursor.close()

    @event.listens_for(engine, "begin")
    def _begin(connection: Any) -> None:
        # A transaction that starts by reading and then writes cannot be refused half-way.
        connection.exec_driver_sql("BEGIN IMMEDIATE")

    return engine


def migrate(engine: Engine, revision: str = "head") -> None:
    """Bring the schema to `revision`: up with "head" or a number, down with "base" or "-1" (by one)."""
    with engine.begin() as connection:
        config = Config()
        config.set_main_option("script_location", str(MIGRATIONS).replace("%", "%%"))
        config.attributes["connection"] = connection
        (command.downgrade if revision in {"base", "-1"} else command.upgrade)(config, revision)


Transaction = Session
"""What the store's functions work in."""


class Database:
    """The clinic's database, brought to the newest schema when it is opened; Refusal when it cannot be."""

    def __init__(self, file: Path) -> None:
        file.parent.mkdir(parents=True, exist_ok=True)
        self._engine = make_engine(file)
        self._one_at_a_time = threading.Lock()
        try:
            with _in_words():
                migrate(self._engine)
        except BaseException:
            self.close()
            raise

    @contextmanager
    def transaction(self) -> Iterator[Transaction]:
        """Yield a session; all of what was done in it is kept, or nothing when an exception passes.

        Raises
        ------
        Full
            When there is no room for what was done in it.
        Unavailable
            When another program holds the file for too long, or it is damaged.
        """
        with (
            _in_words(),
            self._one_at_a_time,
            Session(self._engine, expire_on_commit=False) as session,
            session.begin(),
        ):
            yield session

    def close(self) -> None:
        """Close every connection."""
        self._engine.dispose()


@contextmanager
def _in_words() -> Iterator[None]:
    """Say in a sentence what people can do something about."""
    try:
        yield
    except DatabaseError as error:
        code = getattr(error.orig, "sqlite_errorcode", 0) & 0xFF  # the rest of it says which way it happened
        if code == sqlite3.SQLITE_FULL:
            raise Full(NO_ROOM) from error
        if code in {sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED}:
            raise Unavailable("Another program holds the database: wait for its end, then try again.") from error
        if code in {sqlite3.SQLITE_NOTADB, sqlite3.SQLITE_CORRUPT}:
            raise Unavailable("The database is damaged: put a copy of it back, or begin with a new folder.") from error
        raise
