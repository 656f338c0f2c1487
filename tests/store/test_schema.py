"""Databases of older and newer programs: copied and migrated completely, or left unchanged."""

import shutil
import sqlite3
import stat
from contextlib import closing
from pathlib import Path
from types import SimpleNamespace

import pytest
from alembic.config import Config
from alembic.script import ScriptDirectory
from sqlalchemy import text
from store.newest_schema import newest_schema, statements

from app.refusals import DiskFull, Refusal, Unavailable
from app.store.backup import back_up
from app.store.database import Database, make_engine
from app.store.log import write_log
from app.store.migrations.versions import v0005_learning
from app.store.people import the_clinic
from app.store.schema import MIGRATIONS, NEWEST, NEWEST_SCHEMA, migrate, revision_of

CONFIG = Config()
CONFIG.set_main_option("script_location", str(MIGRATIONS))
REVISIONS = [script.revision for script in ScriptDirectory.from_config(CONFIG).walk_revisions()][::-1]
PATIENTS = 3


def make_old(file: Path, revision: str) -> Path:
    """Make a database of an older program, with content."""
    engine = make_engine(file)
    migrate(engine, REVISIONS[0])
    with engine.begin() as connection:
        connection.execute(
            text("INSERT INTO clinic (name, created, unused) VALUES ('Old', '2025-01-01 00:00:00.000000', '[]')")
        )
        for number in range(PATIENTS):
            connection.execute(
                text(
                    "INSERT INTO patient (clinic_id, code, pseudonym, note, created) "
                    f"VALUES (1, 'P-{number}', 'Heron', '{'n' * 2000}', '2025-01-01 00:00:00.000000')"
                )
            )
    if revision != REVISIONS[0]:
        migrate(engine, revision)
    engine.dispose()
    return file


def count(file: Path, table: str) -> int:
    with closing(sqlite3.connect(file)) as connection:
        found: int = connection.execute(f"SELECT COUNT(*) FROM {table}").fetchone()[0]
        return found


def contents(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def change(file: Path, statement: str) -> None:
    with closing(sqlite3.connect(file)) as connection:
        connection.execute(statement)
        connection.commit()


def copies(folder: Path) -> list[Path]:
    return sorted(folder.glob("*.backup"))


def test_the_newest_revision_is_that_of_the_last_migration() -> None:
    assert REVISIONS[-1] == NEWEST


def test_a_new_database_has_exactly_the_tables_that_all_migrations_make(tmp_path: Path) -> None:
    assert NEWEST_SCHEMA.read_text() == newest_schema(tmp_path), "a migration is newer: run `make schema`"
    Database(tmp_path / "clinic.sqlite").close()
    assert statements(tmp_path / "clinic.sqlite") == statements(tmp_path / "newest.sqlite")
    assert revision_of(tmp_path / "clinic.sqlite") == NEWEST


@pytest.mark.parametrize("revision", REVISIONS)
def test_a_database_of_any_version_is_copied_and_goes_up_and_down(tmp_path: Path, revision: str) -> None:
    file = make_old(tmp_path / "clinic.sqlite", revision)
    database = Database(file)
    with database.transaction() as db:
        assert the_clinic(db).name == "Old"  # type: ignore[union-attr]
        write_log(db, None, "opened")
    database.close()
    assert revision_of(file) == NEWEST
    assert count(file, "patient") == PATIENTS
    if revision == REVISIONS[-1]:
        assert copies(tmp_path) == []
        return
    (copy,) = copies(tmp_path)
    assert copy.name.startswith(f"clinic.sqlite.schema-{revision}.2")
    assert stat.S_IMODE(copy.stat().st_mode) == 0o600
    assert (revision_of(copy), count(copy, "patient")) == (revision, PATIENTS)
    engine = make_engine(file)
    for _ in range(REVISIONS.index(revision), len(REVISIONS) - 1):
        migrate(engine, "-1")
    engine.dispose()
    assert (revision_of(file), count(file, "patient")) == (revision, PATIENTS)
    copy.replace(file)  # the way back: the copy takes the place of the database
    Database(file).close()
    assert count(file, "patient") == PATIENTS


def test_a_newer_database_is_one_sentence_and_nothing_is_touched(tmp_path: Path) -> None:
    file = tmp_path / "clinic.sqlite"
    Database(file).close()
    change(file, "UPDATE alembic_version SET version_num = '9999'")
    before = contents(tmp_path)
    with pytest.raises(Refusal, match=rf"newer bodydrive: its schema is 9999, .* up to {NEWEST}") as refused:
        Database(file)
    assert "\n" not in str(refused.value)
    assert contents(tmp_path) == before


def test_without_room_for_the_copy_nothing_is_migrated(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = make_old(tmp_path / "clinic.sqlite", REVISIONS[0])
    before = contents(tmp_path)
    monkeypatch.setattr("app.store.backup.shutil.disk_usage", lambda _folder: SimpleNamespace(free=4_000_000))
    with pytest.raises(DiskFull, match=r"no room for a copy .* free 4 MB .* Nothing was changed"):
        Database(file)
    assert contents(tmp_path) == before


def test_a_migration_that_fails_midway_leaves_the_old_database_usable(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = make_old(tmp_path / "clinic.sqlite", "0003")
    add = v0005_learning.op.add_column

    def fails(table: str, column: object) -> None:
        add(table, column)
        if table == "patient":
            raise OSError("the machine is tired")

    with monkeypatch.context() as patch:
        patch.setattr("alembic.op.add_column", fails)
        with pytest.raises(
            Refusal, match=r"could not be brought from schema 0003 .*\(the machine is tired\).* as it was"
        ):
            Database(file)
    assert (revision_of(file), count(file, "patient")) == ("0003", PATIENTS)
    with closing(sqlite3.connect(file)) as connection:
        columns = {row[1] for row in connection.execute("PRAGMA table_info(profile)")}
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    assert "origin" not in columns
    Database(file).close()
    assert revision_of(file) == NEWEST


def test_a_copy_is_of_one_moment_while_somebody_writes(tmp_path: Path) -> None:
    file = make_old(tmp_path / "clinic.sqlite", REVISIONS[-1])
    writer = sqlite3.connect(file)
    writer.execute("DELETE FROM patient WHERE id = 1")
    try:
        copy = back_up(file, tmp_path, "now")
        writer.commit()
    finally:
        writer.close()
    assert copy.rows["patient"] == count(copy.file, "patient") == PATIENTS
    assert [file.name for file in tmp_path.glob("*.backup*")] == [copy.file.name]


def test_a_copy_that_is_not_equal_or_cannot_be_made_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = make_old(tmp_path / "clinic.sqlite", REVISIONS[-1])
    folder = tmp_path / "copies"
    folder.mkdir()
    counted = iter([{"patient": 3}, {"patient": 4}])
    with monkeypatch.context() as patch:
        patch.setattr("app.store.backup._counts", lambda _connection: next(counted))
        with pytest.raises(Unavailable, match="not equal"):
            back_up(file, folder, "bad")
    assert list(folder.iterdir()) == []
    damaged = shutil.copy(file, tmp_path / "damaged.sqlite")
    with damaged.open("r+b") as opened:
        opened.seek(4096 * 3)
        opened.write(b"\xff" * 4096 * 4)
    with pytest.raises((Unavailable, sqlite3.DatabaseError)):
        back_up(damaged, folder, "bad")
    assert list(folder.iterdir()) == []
