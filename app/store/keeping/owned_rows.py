"""The rows of a database that belong to a patient, found by the foreign keys of its tables, and their erasure.

The tables are those of the metadata: of the program for the clinic's database, and of the file itself for a copy that
was made before an upgrade (`tables_in`). A table that is added later needs no line here.
"""

# ruff: noqa: S608  (names of tables and columns come from the metadata)
import json
import sqlite3
from collections import defaultdict
from pathlib import Path
from typing import NamedTuple

from sqlalchemy import MetaData, create_engine
from sqlalchemy.orm import Session

RowIds = dict[str, set[int]]
"""SQLite's row ids, by table."""


class ForeignKey(NamedTuple):
    """A column of a table that names rows of another one."""

    table: str
    column: str
    required: bool
    parent: str
    parent_column: str


def sqlite_connection(db: Session) -> sqlite3.Connection:
    """Return the connection to SQLite itself, within the transaction of `db`."""
    connection = db.connection().connection.driver_connection
    assert isinstance(connection, sqlite3.Connection)
    return connection


def tables_in(file: Path) -> MetaData:
    """Return the tables of a database file of any schema, without those of Alembic."""
    tables = MetaData()
    engine = create_engine(f"sqlite:///{file}")
    tables.reflect(engine, only=lambda name, _: name != "alembic_version")
    engine.dispose()
    return tables


def rows_of_patient(connection: sqlite3.Connection, tables: MetaData, patient: int) -> RowIds:
    """Return the patient's own row and all rows that belong to it: their required foreign keys lead to it."""
    keys = [key for key in foreign_keys(tables) if key.required]
    rows: RowIds = defaultdict(set)
    rows["patient"] = {row[0] for row in connection.execute("SELECT id FROM patient WHERE id = ?", (patient,))}
    is_complete = False
    while not is_complete:
        is_complete = True
        for key in keys:
            if children := _children(connection, key, rows[key.parent]) - rows[key.table]:
                rows[key.table] |= children
                is_complete = False
    return {table: ids for table, ids in rows.items() if ids}


def erase_rows(connection: sqlite3.Connection, tables: MetaData, rows: RowIds) -> None:
    """Erase rows, and let other rows no longer name them. Within a transaction that has begun."""
    connection.execute("PRAGMA defer_foreign_keys=ON")  # until the commit: the order of the tables does not matter
    for key in foreign_keys(tables):
        if not key.required and rows.get(key.parent):
            named = _children(connection, key, rows[key.parent]) - rows.get(key.table, set())
            _run(connection, f'UPDATE "{key.table}" SET "{key.column}" = NULL WHERE rowid IN', named)
    for table, ids in rows.items():
        _run(connection, f'DELETE FROM "{table}" WHERE rowid IN', ids)


def forget_in_lists(connection: sqlite3.Connection, patient: int) -> None:
    """Remove a patient from the patients that are shown to reviewers."""
    for person, text in connection.execute("SELECT id, patients FROM person WHERE patients IS NOT NULL").fetchall():
        shown = json.loads(text)
        if shown and patient in shown:
            remaining = json.dumps([other for other in shown if other != patient])
            connection.execute("UPDATE person SET patients = ? WHERE id = ?", (remaining, person))


def foreign_keys(tables: MetaData) -> list[ForeignKey]:
    """Return all foreign keys of these tables, in the order of the tables' names."""
    return [
        ForeignKey(name, column.name, not column.nullable, key.column.table.name, key.column.name)
        for name, table in sorted(tables.tables.items())
        for column in table.columns
        for key in column.foreign_keys
    ]


def _children(connection: sqlite3.Connection, key: ForeignKey, parents: set[int]) -> set[int]:
    if not parents:
        return set()
    query = (
        f'SELECT rowid FROM "{key.table}" WHERE "{key.column}" IN (SELECT "{key.parent_column}" FROM "{key.parent}" '
        "WHERE rowid IN (SELECT value FROM json_each(?)))"
    )
    return {row[0] for row in connection.execute(query, (json.dumps(list(parents)),))}


def _run(connection: sqlite3.Connection, statement: str, ids: set[int]) -> None:
    connection.execute(f"{statement} (SELECT value FROM json_each(?))", (json.dumps(list(ids)),))
