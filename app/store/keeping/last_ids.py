"""Give no id of an erased row again: the log names sessions, trials and patients by their ids, for ever.

SQLite gives the highest id of a table plus one, which may be the id of an erased row. From the first erasure on, the
ids are counted in the table `last_id`.
"""

import sqlite3
from typing import Protocol

from sqlalchemy import Connection, Integer, MetaData, event
from sqlalchemy.orm import Mapper

from app.store.keeping.owned_rows import RowIds
from app.store.tables import Table


def store_last_ids(connection: sqlite3.Connection, tables: MetaData, rows: RowIds) -> None:
    """Store the highest id of each table of which rows are about to be erased."""
    for table in rows:
        keys = list(tables.tables[table].primary_key)
        if [key.name for key in keys] == ["id"] and isinstance(keys[0].type, Integer):
            (highest,) = connection.execute(f'SELECT MAX(id) FROM "{table}"').fetchone()  # noqa: S608
            connection.execute(
                "INSERT INTO last_id (name, id) VALUES (?, ?) ON CONFLICT DO UPDATE SET id = MAX(id, excluded.id)",
                (table, highest),
            )


class RowWithId(Protocol):
    """A row of a table whose primary key is a number that SQLite gives."""

    id: int | None


@event.listens_for(Table, "before_insert", propagate=True)
def _give_next_id(mapper: Mapper[Table], connection: Connection, row: RowWithId) -> None:
    """Give a new row the next id of its table, where rows of this table were erased."""
    keys = mapper.primary_key
    if [key.name for key in keys] != ["id"] or not isinstance(keys[0].type, Integer) or row.id is not None:
        return
    following = next_id(connection, mapper.local_table.name)  # type: ignore[attr-defined]
    if following is not None:
        row.id = following


def next_id(connection: Connection, table: str) -> int | None:
    """Return the next id of a table of which rows were erased; None for another table, where SQLite gives it."""
    following = (
        f'UPDATE last_id SET id = MAX(id, (SELECT COALESCE(MAX(id), 0) FROM "{table}")) + 1 '  # noqa: S608
        "WHERE name = ? RETURNING id"
    )
    next_value: int | None = connection.exec_driver_sql(following, (table,)).scalar()
    return next_value
