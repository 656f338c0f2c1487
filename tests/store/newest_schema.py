"""Writes what all migrations together make of an empty database, from which new ones are made: `make schema`."""

import sqlite3
import sys
import tempfile
from contextlib import closing
from pathlib import Path

from app.store.database import make_engine
from app.store.schema import BETWEEN, NEWEST, NEWEST_SCHEMA, migrate


def statements(file: Path) -> list[str]:
    """Return the statements that make the tables, indices and triggers of a database, in the order of their making."""
    with closing(sqlite3.connect(file)) as connection:
        found = connection.execute("SELECT sql FROM sqlite_master WHERE name NOT LIKE 'sqlite_%' ORDER BY rowid")
        return [sql for (sql,) in found]


def newest_schema(folder: Path) -> str:
    """Return the text of the file; `folder` is for the database that is made."""
    file = folder / "newest.sqlite"
    engine = make_engine(file)
    migrate(engine)
    engine.dispose()
    version = f"INSERT INTO alembic_version (version_num) VALUES ('{NEWEST}')"
    return BETWEEN.join([*statements(file), version]) + "\n"


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as made:
        NEWEST_SCHEMA.write_text(newest_schema(Path(made)), encoding="utf-8")
    sys.stdout.write(f"{NEWEST_SCHEMA} is written.\n")
