"""The schema: made by migrations or from the metadata it is the same; databases of older and newer programs."""

import shutil
import sqlite3
import stat
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from alembic.autogenerate import compare_metadata
from alembic.config import Config
from alembic.migration import MigrationContext
from alembic.script import ScriptDirectory
from clinic_rows import rows_in
from store.later_schema import COLUMN, LATER, use_later_schema

from app.refusals import DiskFull, Refusal, Unavailable
from app.store.backup import back_up
from app.store.database import Database, make_engine
from app.store.log import write_log
from app.store.people import the_clinic
from app.store.schema import MIGRATIONS, NEWEST, metadata, migrate, revision_of

CONFIG = Config()
CONFIG.set_main_option("script_location", str(MIGRATIONS))
REVISIONS = [script.revision for script in ScriptDirectory.from_config(CONFIG).walk_revisions()][::-1]
PATIENTS = 3


def migrated(file: Path, revision: str = "head") -> Path:
    """Make a database by the migrations up to `revision`."""
    engine = make_engine(file)
    migrate(engine, revision)
    engine.dispose()
    return file


@pytest.fixture
def file(database: Database, tmp_path: Path) -> Path:
    """Return the database of a clinic with some patients, of this program's schema."""
    with rows_in(database, "Old") as rows:
        for number in range(PATIENTS):
            rows.patient(f"P-{number}", note="n" * 2000)
    database.close()
    return tmp_path / "clinic.sqlite"


@pytest.fixture
def older(file: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return that database, for a program with a later schema."""
    use_later_schema(tmp_path_factory.mktemp("later"), monkeypatch)
    return file


def count(file: Path, table: str) -> int:
    with closing(sqlite3.connect(file)) as connection:
        return int(connection.execute(f"SELECT COUNT(*) FROM {table}").fetchone()[0])


def columns(file: Path, table: str) -> set[str]:
    with closing(sqlite3.connect(file)) as connection:
        return {row[1] for row in connection.execute(f"PRAGMA table_info({table})")}


def contents(folder: Path) -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def change(file: Path, statement: str) -> None:
    with closing(sqlite3.connect(file)) as connection:
        connection.execute(statement)
        connection.commit()


def copies(folder: Path) -> list[Path]:
    return sorted(folder.glob("*.backup"))


def parts(definition: str) -> Iterator[str]:
    """Yield the parts between the outer commas of `a, b(c, d), e`."""
    depth, part = 0, ""
    for letter in " ".join(definition.split()):
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            yield part.strip()
            part = ""
        else:
            part += letter
    yield part.strip()


def structure(file: Path) -> dict[str, set[str]]:
    """Return the columns and constraints of each table and the statement of each index and trigger, by their names.

    SQLite has them as text. Migrations add columns and constraints in another order than the metadata.
    """
    with closing(sqlite3.connect(file)) as connection:
        found = connection.execute("SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL").fetchall()
    return {
        name: set(parts(sql.partition("(")[2].rstrip().removesuffix(")"))) if kind == "table" else {sql}
        for kind, name, sql in found
    }


def test_the_newest_revision_is_that_of_the_last_migration() -> None:
    assert REVISIONS[-1] == NEWEST


def test_the_migrations_make_exactly_the_tables_of_the_metadata(tmp_path: Path) -> None:
    engine = make_engine(migrated(tmp_path / "migrated.sqlite"))
    with engine.connect() as connection:
        context = MigrationContext.configure(connection, opts={"compare_server_default": True})
        assert compare_metadata(context, metadata()) == []
    engine.dispose()


def test_a_new_database_is_equal_to_one_of_the_migrations_in_indexes_constraints_and_triggers(tmp_path: Path) -> None:
    """Alembic compares no triggers, no conditions of indexes and no names of primary keys."""
    Database(tmp_path / "new.sqlite").close()
    new = structure(tmp_path / "new.sqlite")
    assert new == structure(migrated(tmp_path / "migrated.sqlite"))
    assert revision_of(tmp_path / "new.sqlite") == NEWEST
    assert {"log_no_update", "uq_session_open", "ix_trial_counted", "alembic_version"} <= set(new)
    assert "CONSTRAINT uq_patient_clinic_id_code UNIQUE (clinic_id, code)" in new["patient"]


def test_down_leaves_nothing_and_up_again_works(tmp_path: Path) -> None:
    file = migrated(tmp_path / "a.sqlite")
    before = structure(file)
    assert set(structure(migrated(file, "base"))) == {"alembic_version"}
    assert structure(migrated(file)) == before


def test_an_older_database_is_copied_goes_up_and_its_copy_is_the_way_back(older: Path, tmp_path: Path) -> None:
    database = Database(older)
    with database.transaction() as db:
        assert the_clinic(db).name == "Old"  # type: ignore[union-attr]
        write_log(db, None, "opened")
    database.close()
    assert (revision_of(older), count(older, "patient")) == (LATER, PATIENTS)
    assert COLUMN in columns(older, "patient")
    (copy,) = copies(tmp_path)
    assert copy.name.startswith(f"clinic.sqlite.schema-{NEWEST}.2")
    assert stat.S_IMODE(copy.stat().st_mode) == 0o600
    assert (revision_of(copy), count(copy, "patient")) == (NEWEST, PATIENTS)
    assert COLUMN not in columns(copy, "patient")
    copy.replace(older)
    Database(older).close()
    assert count(older, "patient") == PATIENTS


def test_a_database_of_this_schema_is_not_copied(file: Path, tmp_path: Path) -> None:
    Database(file).close()
    assert copies(tmp_path) == []


def test_a_newer_database_is_one_sentence_and_nothing_is_touched(file: Path, tmp_path: Path) -> None:
    change(file, f"UPDATE alembic_version SET version_num = '{LATER}'")
    before = contents(tmp_path)
    with pytest.raises(Refusal, match=rf"newer bodydrive: its schema is {LATER}, .* up to {NEWEST}") as refused:
        Database(file)
    assert "\n" not in str(refused.value)
    assert contents(tmp_path) == before


def test_without_room_for_the_copy_nothing_is_migrated(older: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = contents(older.parent)
    monkeypatch.setattr("app.store.backup.shutil.disk_usage", lambda _folder: SimpleNamespace(free=4_000_000))
    with pytest.raises(DiskFull, match=r"no room for a copy .* free 4 MB .* Nothing was changed"):
        Database(older)
    assert contents(older.parent) == before


def test_a_migration_that_fails_leaves_the_old_database_usable(older: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from alembic import op

    add = op.add_column

    def fails(table: str, column: Any) -> None:
        add(table, column)
        raise OSError("the machine is tired")

    with monkeypatch.context() as patch:
        patch.setattr("alembic.op.add_column", fails)
        said = rf"could not be brought from schema {NEWEST} .*\(the machine is tired\).* as it was"
        with pytest.raises(Refusal, match=said):
            Database(older)
    assert (revision_of(older), count(older, "patient")) == (NEWEST, PATIENTS)
    with closing(sqlite3.connect(older)) as connection:
        assert connection.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    assert COLUMN not in columns(older, "patient")
    Database(older).close()
    assert revision_of(older) == LATER


def test_a_copy_is_of_one_moment_while_somebody_writes(file: Path, tmp_path: Path) -> None:
    with closing(sqlite3.connect(file)) as writer:
        writer.execute("DELETE FROM patient WHERE id = 1")
        copy = back_up(file, tmp_path, "now")
        writer.commit()
    assert copy.rows["patient"] == count(copy.file, "patient") == PATIENTS
    assert [file.name for file in tmp_path.glob("*.backup*")] == [copy.file.name]


def test_a_copy_that_is_not_equal_or_cannot_be_made_is_none(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "copies"
    folder.mkdir()
    counted = iter([{"patient": 3}, {"patient": 4}])
    with monkeypatch.context() as patch:
        patch.setattr("app.store.backup._counts", lambda _connection: next(counted))
        with pytest.raises(Unavailable, match="not equal"):
            back_up(file, folder, "bad")
    assert list(folder.iterdir()) == []
    damaged = Path(shutil.copy(file, tmp_path / "damaged.sqlite"))
    with damaged.open("r+b") as opened:
        opened.seek(4096 * 3)
        opened.write(b"\xff" * 4096 * 4)
    with pytest.raises((Unavailable, sqlite3.DatabaseError)):
        back_up(damaged, folder, "bad")
    assert list(folder.iterdir()) == []


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
