"""Every key to another table leads an index: what belongs to a row is found without reading a whole table."""

import sqlite3
from contextlib import closing
from pathlib import Path


def leading_columns(database: sqlite3.Connection, table: str) -> set[str]:
    """Return the first column of the primary key, and of each index over all rows."""
    columns = database.execute("SELECT name, pk FROM pragma_table_info(?)", (table,)).fetchall()
    query = (
        "SELECT info.name FROM pragma_index_list(?) list, pragma_index_info(list.name) info "
        "WHERE info.seqno = 0 AND NOT list.partial"
    )
    return {name for name, place in columns if place == 1} | {name for (name,) in database.execute(query, (table,))}


def test_each_key_leads_an_index_except_that_of_the_clinic(new_database: Path) -> None:
    with closing(sqlite3.connect(new_database / "clinic.sqlite")) as database:
        keys = database.execute(
            'SELECT one.name, key."from" FROM sqlite_master one, pragma_foreign_key_list(one.name) key '
            "WHERE one.type = 'table' AND key.\"table\" != 'clinic'"
        ).fetchall()
        slow = [f"{table}.{column}" for table, column in keys if column not in leading_columns(database, table)]
    assert len(keys) > 20
    assert slow == []
