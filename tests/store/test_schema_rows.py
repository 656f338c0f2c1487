"""Each row goes through every migration since 0.2.0, up and down, with the same content."""

import shutil
import sqlite3
from collections.abc import Iterator
from contextlib import closing
from datetime import UTC, date, datetime
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa
from clinic_rows import rows_in
from exported_clinic import make_clinic
from store.keeping.filled_clinic import fill
from store.later_schema import LATER, use_later_schema
from store.test_schema import REVISIONS, migrated

from app.store.database import Database, make_engine
from app.store.log import write_log
from app.store.schema import NEWEST, migrate, revision_of

FIRST = "0001"  # of 0.2.0
FILLED = {
    *("patient", "session", "trial", "run", "profile", "parameters", "session_note", "note_revision", "outcome_scale"),
    *("moment_comment", "comment_revision", "share_link", "patient_consent", "session_sign_off", "interface_test"),
}
VALUES: dict[type, Any] = {bool: True, int: 1, float: 1.5, str: "word", object: {"word": "Zebra"}}  # object: JSON
VALUES |= {date: date(2026, 3, 1), datetime: datetime(2026, 3, 1, 12, tzinfo=UTC)}
Rows = dict[str, list[dict[str, Any]]]


@pytest.fixture(scope="module")
def filled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the database of a clinic with a recorded patient, two with a row in every table, and a reviewer of two."""
    settings = make_clinic(tmp_path_factory.mktemp("clinic"))
    with rows_in(settings) as rows:
        for word in ("Zebra", "Heron"):
            fill(rows.db, rows.patient(f"{word}-code", f"{word} pseudonym", f"{word} note"), word)
        rows.person("Rita", "reviewer", patients=[1, 2])
        write_log(rows.db, "Ada", "patient added", patient=2)
    return settings.database


@pytest.fixture
def _later(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """A migration after the newest one, so that there is a way up and down also while there is one migration."""
    use_later_schema(tmp_path_factory.mktemp("later"), monkeypatch)


def rows_of(file: Path) -> Rows:
    with closing(sqlite3.connect(file)) as connection:
        connection.row_factory = sqlite3.Row
        tables = [name for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
        assert connection.execute("PRAGMA foreign_key_check").fetchall() == []
        return {
            name: [dict(row) for row in connection.execute(f"SELECT * FROM {name} ORDER BY rowid")]
            for name in tables
            if name not in {"alembic_version", "sqlite_sequence"}
        }


def lost(before: Rows, after: Rows) -> Iterator[str]:
    """Yield what differs in tables and columns that both have."""
    for table in before.keys() & after.keys():
        if len(before[table]) != len(after[table]):
            yield f"{table}: {len(before[table])} rows, then {len(after[table])}"
            continue
        for old, new in zip(before[table], after[table], strict=True):
            yield from (
                f"{table}.{column}: {old[column]!r}, then {new[column]!r}"
                for column in old.keys() & new.keys()
                if old[column] != new[column]
            )


def down_to(file: Path, revision: str) -> None:
    engine = make_engine(file)
    while revision_of(file) != revision:
        migrate(engine, "-1")
    engine.dispose()


def fill_by_its_own_tables(file: Path) -> None:
    """Put a row into each table of a database, as its own schema describes them."""
    engine = make_engine(file)
    tables = sa.MetaData()
    tables.reflect(engine)
    with engine.begin() as connection:
        for table in tables.sorted_tables:
            if table.name != "alembic_version":
                row = {column.name: VALUES[column.type.python_type] for column in table.columns}
                connection.execute(sa.insert(table).values(row))
    engine.dispose()


def test_the_clinic_is_filled(filled: Path) -> None:
    rows = rows_of(filled)
    assert {table for table in FILLED if len(rows[table]) < 2} == set()
    assert len(rows["patient"]) == 3
    assert any(row["goal"] for row in rows["session"])
    assert revision_of(filled) == NEWEST


@pytest.mark.usefixtures("_later")
def test_a_database_of_0_2_0_is_upgraded_with_all_its_rows(tmp_path: Path) -> None:
    file = migrated(tmp_path / "clinic.sqlite", FIRST)
    fill_by_its_own_tables(file)
    before = rows_of(file)
    assert {table for table, rows in before.items() if not rows} == set()
    Database(file).close()
    after = rows_of(file)
    assert revision_of(file) == LATER
    assert (before.keys() - after.keys(), sorted(lost(before, after | {"log": after["log"][:1]}))) == (set(), [])


@pytest.mark.usefixtures("_later")
def test_a_migration_changes_the_database_and_leaves_every_other_file_as_it_is(filled: Path, tmp_path: Path) -> None:
    """So the copy before a migration needs the database only."""
    state = Path(shutil.copytree(filled.parent, tmp_path / "state"))
    file = state / filled.name
    for name in ("files/layout.json", "keys/1.key"):
        (state / name).parent.mkdir()
        (state / name).write_text("{}")
    down_to(file, FIRST)
    before = other_files(state, file.name)
    assert any(name.endswith("run.parquet") for name in before)
    Database(file).close()
    assert revision_of(file) == LATER
    assert other_files(state, file.name) == before
    (copy,) = state.glob(f"{file.name}.schema-{FIRST}.*.backup")
    assert len(rows_of(copy)["patient"]) == 3


def other_files(state: Path, database: str) -> dict[str, tuple[bytes, int]]:
    """Return content and time of change of each file that is no part of the database."""
    return {
        file.relative_to(state).as_posix(): (file.read_bytes(), file.stat().st_mtime_ns)
        for file in state.rglob("*")
        if file.is_file() and not file.name.startswith(database)
    }


@pytest.mark.usefixtures("_later")
@pytest.mark.parametrize("revision", REVISIONS)
def test_no_row_is_changed_by_the_way_down_to_a_version_and_up_again(
    filled: Path, tmp_path: Path, revision: str
) -> None:
    file = migrated(Path(shutil.copy(filled, tmp_path / "clinic.sqlite")))
    newest = rows_of(file)
    down_to(file, revision)
    older = rows_of(file)
    assert sorted(lost(newest, older)) == []
    again = rows_of(migrated(file))
    assert revision_of(file) == LATER
    assert sorted(lost(older, again)) == []
    assert {table: list(rows[0]) for table, rows in again.items() if rows} == {
        table: list(rows[0]) for table, rows in newest.items() if again[table]
    }


def test_the_settings_of_backups_go_with_their_table_and_come_back(tmp_path: Path) -> None:
    file = migrated(tmp_path / "clinic.sqlite", FIRST)
    fill_by_its_own_tables(file)
    with closing(sqlite3.connect(file)) as connection, connection:
        connection.execute("UPDATE record_keeping SET years = 12, folder = '/media/stick', hour = 23, with_keys = 1")
    before = rows_of(file)["record_keeping"]
    after = rows_of(migrated(file))
    assert after["record_keeping"] == [{"clinic_id": 1, "years": 12}]
    assert after["backup_settings"] == [{"clinic_id": 1, "folder": "/media/stick", "hour": 23, "with_keys": 1}]
    assert after["made_backup"][0]["message"] == VALUES[str]
    down_to(file, FIRST)
    assert rows_of(file)["record_keeping"] == before
    with closing(sqlite3.connect(file)) as connection, connection:
        connection.execute("DROP TABLE made_backup")  # of a program that never had the feature
    assert "made_backup" not in rows_of(migrated(file))
    down_to(file, FIRST)
