"""`bodydrive log verify`, and databases that this program does not open, each with a sentence and an exit code."""

import json
import sqlite3
from contextlib import closing

import pytest
from cli.answers import assert_refused

from app.store.database import Database
from app.store.log import write_log


@pytest.fixture
def file(tmp_path):
    file = tmp_path / "clinic" / "bodydrive.sqlite"
    database = Database(file)
    for what in ("one", "two", "three"):
        with database.transaction() as db:
            write_log(db, "Ada", what)
    database.close()
    return file


def change(file, *statements):
    with closing(sqlite3.connect(file)) as connection:
        for statement in statements:
            connection.execute(statement)
        connection.commit()


def test_a_whole_log_is_a_sentence_and_code_0_also_while_the_clinic_is_open(bodydrive, file):
    words = "The log is whole: 3 rows, none edited, moved, put in or removed."
    assert bodydrive("log", "verify", "--state", "clinic") == (0, f"{words}\n", "")
    database = Database(file)
    with database.transaction() as db:
        write_log(db, "Ada", "four")
    code, out, _ = bodydrive("log", "verify", "--state", "clinic", "--json")
    database.close()
    assert (code, json.loads(out)) == (0, {"whole": True, "rows": 4, "message": words.replace("3", "4")})


@pytest.mark.parametrize(
    ("done", "said"),
    [
        ("UPDATE log SET person = 'Bob' WHERE id = 2", "row 2 was edited, moved or put in, or rows before it were rem"),
        ("DELETE FROM log WHERE id = 3", "its newest rows were removed, 2 of 3 are left"),
        ("DELETE FROM log", "its newest rows were removed, 0 of 3 are left"),
    ],
)
def test_a_changed_log_is_a_sentence_and_code_1(bodydrive, file, done, said):
    change(file, "DROP TRIGGER log_no_update", "DROP TRIGGER log_no_delete", done)
    code, out, err = bodydrive("log", "verify", "--state", "clinic")
    assert (code, err) == (1, "")
    assert said in out
    code, out, _ = bodydrive("log", "verify", "--state", "clinic", "--json")
    assert (code, json.loads(out)["whole"]) == (1, False)


def test_what_is_no_log_is_a_sentence_and_code_2(bodydrive, tmp_path, file):
    for content in (b"no database" * 1000, b""):
        file.write_bytes(content)
        assert_refused(bodydrive("log", "verify", "--state", "clinic"))
    assert_refused(bodydrive("log", "verify", "--state", "nowhere"), "no clinic in")
    assert not (tmp_path / "nowhere").exists()


@pytest.mark.parametrize(
    "words", [("serve", "--port", "0"), ("chair", "pair", "--name", "Blue", "--host", "127.0.0.1")], ids=" ".join
)
def test_a_newer_database_is_a_sentence_and_code_2(bodydrive, file, words):
    change(file, "UPDATE alembic_version SET version_num = '9999'")
    before = file.read_bytes()
    assert_refused(bodydrive(*words, "--state", "clinic"), "newer bodydrive")
    assert file.read_bytes() == before
