"""The rows of a database that belong to a patient, found by its foreign keys, and their erasure.

This works on a file of any schema: on the clinic's database, on a copy made before an upgrade, on a restored backup.
A table that is added later needs no line here.
"""

# ruff: noqa: S608  (names of tables and columns come from the database itself)
import json
import sqlite3
from collections import defaultdict
from collections.abc import Iterator
from typing import NamedTuple

RowIds = dict[str, set[int]]
"""SQLite's row ids, by table."""


class ForeignKey(NamedTuple):
    """A column of a table that names rows of another one."""

    table: str
    column: str
    required: bool
    parent: str
    parent_column: str


def rows_of_patient(connection: sqlite3.Connection, patient: int) -> RowIds:
    """Return the patient's own row and all rows that belong to it: their required foreign keys lead to it."""
    keys = [key for key in foreign_keys(connection) if key.required]
    found: RowIds = defaultdict(set)
    found["patient"] = {row[0] for row in connection.execute("SELECT id FROM patient WHERE id = ?", (patient,))}
    is_complete = False
    while not is_complete:
        is_complete = True
        for key in keys:
            if more := _children(connection, key, found[key.parent]) - found[key.table]:
                found[key.table] |= more
                is_complete = False
    return {table: ids for table, ids in found.items() if ids}


def erase_rows(connection: sqlite3.Connection, rows: RowIds) -> None:
    """Erase rows, and let other rows no longer name them. Within a transaction that has begun."""
    connection.execute("PRAGMA defer_foreign_keys=ON")  # until the commit: the order of the tables does not matter
    for key in foreign_keys(connection):
        if not key.required and rows.get(key.parent):
            named = _children(connection, key, rows[key.parent]) - rows.get(key.table, set())
            _run(connection, f'UPDATE "{key.table}" SET "{key.column}" = NULL WHERE rowid IN', named)
    for table, ids in rows.items():
        _run(connection, f'DELETE FROM "{table}" WHERE rowid IN', ids)


def forget_in_lists(connection: sqlite3.Connection, patient: int) -> None:
    """Remove a patient from the patients that are shown to reviewers, where this schema has such lists."""
    if "patients" not in {row[1] for row in connection.execute("PRAGMA table_info(person)")}:
        return
    for person, text in connection.execute("SELECT id, patients FROM person WHERE patients IS NOT NULL").fetchall():
        shown = json.loads(text)
        if shown and patient in shown:
            left = json.dumps([one for one in shown if one != patient])
            connection.execute("UPDATE person SET patients = ? WHERE id = ?", (left, person))


def foreign_keys(connection: sqlite3.Connection) -> list[ForeignKey]:
    """Return all foreign keys of a database."""
    return [key for table in tables(connection) for key in _keys_of(connection, table)]


def tables(connection: sqlite3.Connection) -> list[str]:
    """Return the names of all tables."""
    found = connection.execute("SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%'")
    return [name for (name,) in found.fetchall()]


def _keys_of(connection: sqlite3.Connection, table: str) -> Iterator[ForeignKey]:
    required = {row[1] for row in connection.execute(f'PRAGMA table_info("{table}")') if row[3] or row[5]}
    for _, _, parent, column, parent_column, *_ in connection.execute(f'PRAGMA foreign_key_list("{table}")').fetchall():
        yield ForeignKey(table, column, column in required, parent, parent_column or "id")


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
