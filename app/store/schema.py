"""The schema of a database: the metadata of its tables, its revision, the migration to that of this program."""

import sqlite3
from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import quote

from sqlalchemy import Engine, MetaData

from app import __version__
from app.features.registration import features
from app.refusals import Refusal
from app.store import origins  # noqa: F401
from app.store.access import person_tables  # noqa: F401  (tables belong to the metadata once they are imported)
from app.store.backup import back_up
from app.store.keeping import keeping_tables  # noqa: F401
from app.store.tables import Table
from app.texts import Text

if TYPE_CHECKING:
    from alembic.config import Config

MIGRATIONS = Path(__file__).parent / "migrations"
NEWEST = "0004"  # the last revision there; a start with a new database, or one of this revision, loads no alembic


def metadata() -> MetaData:
    """Return what all migrations together make of an empty database, with the tables of features; a test compares."""
    features()  # tables belong to the metadata once they are imported
    return Table.metadata


def connect(file: Path) -> sqlite3.Connection:
    """Return a connection to an existing database file; the caller closes it."""
    return sqlite3.connect(f"file:{quote(str(file))}?mode=rw", uri=True)


def revision_of(file: Path) -> str | None:
    """Return the revision of a database file, None for one that is missing or empty."""
    if not file.exists():
        return None
    with closing(connect(file)) as connection:
        tables = {name for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
        if "alembic_version" not in tables:
            return None
        row = connection.execute("SELECT version_num FROM alembic_version").fetchone()
    return None if row is None else str(row[0])


def bring_up_to_date(file: Path, engine: Engine) -> None:
    """Bring a database to the newest revision; an older one is first copied beside itself.

    Raises
    ------
    Refusal
        When it is of a newer program, when there is no room for the copy, or when the migration fails. The database
        is then unchanged.
    """
    revision = revision_of(file)
    if revision is None:
        _make_tables(engine)
        return
    if revision == NEWEST:
        return
    if revision not in _revisions():
        database = str(file)
        raise Refusal(
            Text("store-schema-newer", database=database, revision=revision, version=__version__, newest=NEWEST)
        )
    copy = back_up(file, file.parent, f"schema-{revision}")
    try:
        migrate(engine)
    except Exception as error:
        why = str(getattr(error, "orig", error)).partition("\n")[0]
        raise Refusal(
            Text(
                "store-schema-failed",
                database=str(file),
                revision=revision,
                newest=NEWEST,
                problem=why,
                copy=copy.file.name,
            )
        ) from error


def _make_tables(engine: Engine) -> None:
    """Make the tables of the newest revision in an empty database, in one transaction."""
    with engine.begin() as connection:
        metadata().create_all(connection, checkfirst=False)
        connection.exec_driver_sql(
            "CREATE TABLE alembic_version "
            "(version_num VARCHAR(32) NOT NULL, CONSTRAINT alembic_version_pkc PRIMARY KEY (version_num))"
        )
        connection.exec_driver_sql("INSERT INTO alembic_version (version_num) VALUES (?)", (NEWEST,))


def migrate(engine: Engine, revision: str = "head") -> None:
    """Migrate to `revision` in one transaction: up with "head" or a number, down with "base" or "-1"."""
    from alembic import command

    with engine.begin() as connection:
        config = _config()
        config.attributes["connection"] = connection
        (command.downgrade if revision in {"base", "-1"} else command.upgrade)(config, revision)


def _revisions() -> set[str]:
    from alembic.script import ScriptDirectory

    return {script.revision for script in ScriptDirectory.from_config(_config()).walk_revisions()}


def _config() -> "Config":
    from alembic.config import Config

    config = Config()
    config.set_main_option("script_location", str(MIGRATIONS).replace("%", "%%"))
    return config
