"""Changes of the log in the database are detected, also of its newest rows; a crash raises no alarm."""

import os
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
from collections.abc import Callable
from contextlib import closing
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from app.store.database import Database
from app.store.log import write_log
from app.store.log_chain import FIRST, HeadFile, entry_hash, verify_log
from folders import ROOT

ROWS = 6
COLUMNS = ("at", "person", "what", "details", "previous_hash", "hash")
NAMES = ", ".join(("id", *COLUMNS))
Rows = list[tuple[Any, ...]]


def write_rows(database: Database, count: int) -> None:
    for number in range(count):
        with database.transaction() as db:
            write_log(db, "Ada", f"deed {number}", patient=number)


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a closed database and its log."""
    folder = tmp_path_factory.mktemp("written")
    database = Database(folder / "clinic.sqlite")
    write_rows(database, ROWS)
    database.close()
    return folder


def rewrite(file: Path, change: Callable[[Rows], Rows]) -> None:
    """Replace the rows of the log without the program."""
    with closing(sqlite3.connect(file)) as connection:
        connection.execute("DROP TRIGGER IF EXISTS log_no_update")
        connection.execute("DROP TRIGGER IF EXISTS log_no_delete")
        rows = connection.execute(f"SELECT {NAMES} FROM log ORDER BY id").fetchall()
        connection.execute("DELETE FROM log")
        connection.executemany(f"INSERT INTO log ({NAMES}) VALUES (?, ?, ?, ?, ?, ?, ?)", change(rows))
        connection.commit()


def row_after(previous: str, number: int, what: str) -> tuple[Any, ...]:
    """Return a row that follows on the hash `previous`."""
    at = datetime(2026, 1, 2, 3, 4, 5, 6, tzinfo=UTC)
    own = entry_hash(previous, at, "Eve", what, {})
    return (number, at.strftime("%Y-%m-%d %H:%M:%S.%f"), "Eve", what, "{}", previous, own)


def chained(rows: Rows) -> Rows:
    """Return rows with all hashes computed anew, as a skilled attacker would."""
    made: Rows = []
    previous = FIRST
    for number, _, _, what, *_ in rows:
        made.append(row_after(previous, number, what))
        previous = made[-1][-1]
    return made


@st.composite
def edited(draw: st.DrawFn) -> Callable[[Rows], Rows]:
    place, column = draw(st.integers(0, ROWS - 1)), draw(st.integers(0, len(COLUMNS) - 1))
    nothing = [st.none()] if COLUMNS[column] == "person" else []  # the others may not be null
    value = draw(st.one_of(st.text(st.characters(codec="utf-8", exclude_characters="\0")), st.binary(), *nothing))

    def change(rows: Rows) -> Rows:
        number, *cells = rows[place]
        cells[column] = value
        return [*rows[:place], (number, *cells), *rows[place + 1 :]]

    return change


@st.composite
def removed(draw: st.DrawFn) -> Callable[[Rows], Rows]:
    gone = draw(st.sets(st.integers(0, ROWS - 1), min_size=1))
    return lambda rows: [row for place, row in enumerate(rows) if place not in gone]


@st.composite
def reordered(draw: st.DrawFn) -> Callable[[Rows], Rows]:
    order = draw(st.permutations(range(ROWS)).filter(lambda order: list(order) != list(range(ROWS))))
    return lambda rows: [(number + 1, *rows[place][1:]) for number, place in enumerate(order)]


@st.composite
def put_in(draw: st.DrawFn) -> Callable[[Rows], Rows]:
    place, chains = draw(st.integers(0, ROWS)), draw(st.booleans())

    def change(rows: Rows) -> Rows:
        previous = rows[place - 1][-1] if place else FIRST
        new = row_after(previous if chains and place < ROWS else "f" * 64, 0, "forged")
        whole = [*rows[:place], new, *rows[place:]]
        return [(number + 1, *row[1:]) for number, row in enumerate(whole)]

    return change


@st.composite
def made_anew(draw: st.DrawFn) -> Callable[[Rows], Rows]:
    """Cut the log somewhere, append other rows, and compute every hash anew."""
    left, more = draw(st.integers(0, ROWS)), draw(st.integers(0, 2 * ROWS))
    return lambda rows: chained(rows[:left] + [(ROWS + 1 + i, "", "", "other") for i in range(more)])


@settings(deadline=None, max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(change=st.one_of(edited(), removed(), reordered(), put_in(), made_anew()))
def test_any_edit_removal_reordering_or_insertion_shows(
    written: Path, tmp_path_factory: pytest.TempPathFactory, change: Callable[[Rows], Rows]
) -> None:
    folder = tmp_path_factory.getbasetemp() / "changed"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(written, folder)
    file = folder / "clinic.sqlite"
    assert verify_log(file).whole
    with closing(sqlite3.connect(file)) as connection:
        before = connection.execute(f"SELECT {NAMES} FROM log ORDER BY id").fetchall()
    rewrite(file, change)
    with closing(sqlite3.connect(file)) as connection:
        connection.text_factory = bytes
        after = connection.execute(f"SELECT {NAMES} FROM log ORDER BY id").fetchall()
    as_bytes = [tuple(cell.encode() if isinstance(cell, str) else cell for cell in row) for row in before]
    check = verify_log(file)
    assert check.whole == (after == as_bytes), check.message


@pytest.mark.parametrize("gone", [[1], [3], [ROWS], [ROWS - 1, ROWS], list(range(1, ROWS + 1))])
def test_first_middle_newest_and_all_removed_rows_show_and_stay_shown(written: Path, tmp_path: Path, gone: Any) -> None:
    file = shutil.copytree(written, tmp_path / "copy") / "clinic.sqlite"
    rewrite(file, lambda rows: [row for row in rows if row[0] not in gone])
    assert "was changed" in str(verify_log(file).message)
    database = Database(file)  # the head must not follow what was changed
    write_rows(database, ROWS + 1)
    database.close()
    assert not verify_log(file).whole


CRASHING = """
import os, signal, sys
from pathlib import Path
from app.store.database import Database
from app.store.log_chain import HeadFile
from app.store.log import write_log

database = Database(Path(sys.argv[1]))
if sys.argv[2] == "before the head":
    HeadFile.write = lambda *_: os.kill(os.getpid(), signal.SIGKILL)
while True:
    with database.transaction() as db:
        for number in range(3):
            write_log(db, "Ada", "deed", number=number)
    print("written", flush=True)
"""


def crash(file: Path, when: str, after: int = 0) -> None:
    """Let a process write rows, and kill it between row and head, or after `after` writes."""
    command = [sys.executable, "-c", CRASHING, str(file), when]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, env={**os.environ, "PYTHONPATH": str(ROOT)})
    try:
        assert process.stdout is not None
        for _ in range(after):
            assert process.stdout.readline()
        if after:
            process.send_signal(signal.SIGKILL)
        process.wait()
    finally:
        process.kill()
        process.communicate()
    assert process.returncode == -signal.SIGKILL


def test_a_crash_between_row_and_head_is_no_alarm_and_stands_in_the_log(tmp_path: Path) -> None:
    file = tmp_path / "clinic.sqlite"
    crash(file, "before the head")
    check = verify_log(file)
    assert check.whole
    assert "newest 3 rows are not in its head" in str(check.message)
    Database(file).close()
    assert str(verify_log(file).message) == "The log is whole: 4 rows, none edited, moved, put in or removed."
    rewrite(file, lambda rows: rows[:-1])
    assert not verify_log(file).whole


def test_kills_at_any_moment_are_no_alarm(tmp_path: Path) -> None:
    file, dice = tmp_path / "clinic.sqlite", random.Random(1)
    for _ in range(4):
        crash(file, "at any moment", dice.randrange(1, 40))
        assert verify_log(file).whole
    rewrite(file, lambda rows: rows[:-4])  # more than the last transaction, which the head may not have met
    assert not verify_log(file).whole


def test_a_head_that_is_missing_or_no_head_shows_and_is_begun_anew(written: Path, tmp_path: Path) -> None:
    file = shutil.copytree(written, tmp_path / "copy") / "clinic.sqlite"
    head = HeadFile(file).file
    for content in (None, b"", b"[1]", b"9 9 head" * 20):
        head.unlink(missing_ok=True)
        if content is not None:
            head.write_bytes(content)
        assert "head of the log is missing" in str(verify_log(file).message)
    Database(file).close()
    check = verify_log(file)
    assert check.whole
    assert f"noticed from row {ROWS + 1} on" in str(check.message)


def test_a_head_that_cannot_be_written_loses_no_row(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "clinic.sqlite"
    database = Database(file)

    def full(*_given: Any) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(HeadFile, "write", full)
        write_rows(database, 2)
    assert "newest 2 rows are not in its head" in str(verify_log(file).message)
    write_rows(database, 1)
    database.close()
    assert str(verify_log(file).message) == "The log is whole: 3 rows, none edited, moved, put in or removed."
