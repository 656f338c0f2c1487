"""`bodydrive chair`: a pairing that is complete or not made, and the receiver as a subcommand."""

import io
import re
import shlex
import sqlite3
import stat
from contextlib import closing

import pytest
from cli.answers import assert_refused, output_of

from app.cli.clinic_folder import lock_folder
from app.cli.qr import terminal_code
from app.hardware.chair.key import LARGEST_ID, new_key, read_key
from app.hardware.chair.receive import _parser
from app.session.equipment import pairing
from app.speed_limits import Speeds
from app.store.chairs import chairs_of
from app.store.database import PRAGMAS, Database
from app.store.people import add_clinic, add_person, the_clinic
from app.store.tables import LogEntry

BLUE = ("chair", "pair", "--name", "Blue", "--host", "10.0.0.7", "--state", "clinic")


def in_database(tmp_path, read):
    with closing(Database(tmp_path / "clinic" / "bodydrive.sqlite")) as database, database.transaction() as db:
        return read(db, the_clinic(db))


def paired(tmp_path):
    return in_database(tmp_path, lambda db, clinic: [] if clinic is None else chairs_of(db))


def kept_keys(tmp_path):
    return sorted(file.name for file in (tmp_path / "clinic" / "keys").glob("*"))


def test_pairing_keeps_the_chair_and_its_key_and_says_what_to_start_there(bodydrive, tmp_path):
    out = output_of(bodydrive(*BLUE, "--port", 6000, "--forward", 0.5, "--turn", 0.9))
    (chair,) = paired(tmp_path)
    assert (chair.name, chair.host, chair.port) == ("Blue", "10.0.0.7", 6000)
    assert Speeds.model_validate(chair.speeds) == Speeds(forward=0.5, turn=0.9)
    file = tmp_path / "clinic" / "keys" / f"{chair.key_id}.key"
    key = read_key(file)
    assert key.id == chair.key_id
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert stat.S_IMODE(file.parent.stat().st_mode) == 0o700
    assert str(file) in out
    line = out.splitlines()[-1]
    assert line.startswith("bodydrive chair receive ")
    given = _parser("receiver").parse_args(shlex.split(line)[3:])
    assert (given.port, given.v_max, given.omega_max, given.output) == (6000, 0.5, 0.9, "ros2")
    assert str(given.key_file) == f"{key.id}.key"


def test_the_code_says_the_line_of_the_key_file_and_no_word_does(bodydrive, tmp_path, monkeypatch):
    coded = []
    segno = pytest.importorskip("segno")
    make = segno.make_qr
    monkeypatch.setattr(segno, "make_qr", lambda content, **options: coded.append(content) or make(content, **options))
    _, out, _ = bodydrive(*BLUE)
    line = (tmp_path / "clinic" / "keys" / "1.key").read_text().strip()
    assert coded == [line]
    assert out.count("█") > 400
    assert line.split()[1] not in out
    stored = b"".join(file.read_bytes() for file in (tmp_path / "clinic").glob("bodydrive.sqlite*"))
    assert line.split()[1].encode() not in stored
    assert bytes.fromhex(line.split()[1]) not in stored


def test_a_terminal_without_blocks_gets_the_code_in_plain_letters(monkeypatch, tmp_path):
    plain = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    monkeypatch.setattr("sys.stdout", plain)
    drawn = terminal_code(new_key(1).line)
    assert drawn.isascii()
    assert re.search(r"\x1b\[\d+m", drawn)


def test_pairing_is_logged_and_makes_the_clinic_only_once(bodydrive, tmp_path):
    bodydrive(*BLUE)
    bodydrive("chair", "pair", "--name", "Red", "--host", "chair.local", "--state", "clinic")

    def look(db, clinic):
        rows = db.query(LogEntry).order_by(LogEntry.id).all()
        return [row.what for row in rows], [row.details for row in rows], clinic.id

    what, details, _ = in_database(tmp_path, look)
    assert what == ["chair paired", "chair paired"]
    assert details[1] == {"chair": 2, "key_id": 2, "host": "chair.local", "port": 5354}
    assert bodydrive("log", "verify", "--state", "clinic")[0] == 0
    assert [chair.clinic_id for chair in paired(tmp_path)] == [1, 1]
    assert kept_keys(tmp_path) == ["1.key", "2.key"]


def test_a_clinic_that_is_served_meanwhile_gets_the_chair(bodydrive, tmp_path):
    folder = tmp_path / "clinic"
    with lock_folder(folder):
        serving = Database(folder / "bodydrive.sqlite")
        with serving.transaction() as db:
            add_person(db, add_clinic(db, "Clinic"), "Ada", "owner", None)
        assert bodydrive(*BLUE)[0] == 0
        with serving.transaction() as db:
            assert [chair.name for chair in chairs_of(db)] == ["Blue"]
        serving.close()


@pytest.mark.parametrize(
    ("options", "word"),
    [
        (("--forward", "nan"), "forward"),
        (("--forward", "9"), "forward"),
        (("--turn", "0"), "turn"),
        (("--jerk", "-1"), "jerk"),
        (("--turn-jerk", "1e999"), "turn_jerk"),
        (("--port", "0"), "--port"),
        (("--port", "65536"), "--port"),
        (("--port", "x"), "--port"),
        (("--name", ""), "name"),
        (("--name", "x" * 81), "name"),
        (("--host", ""), "host"),
        (("--colour", "blue"), "--colour"),
    ],
)
def test_bad_input_is_one_sentence_and_changes_nothing(bodydrive, tmp_path, options, word):
    assert_refused(bodydrive(*BLUE, *options), word)
    assert not (tmp_path / "clinic").exists()


def test_a_name_is_given_once(bodydrive, tmp_path):
    bodydrive(*BLUE)
    assert_refused(bodydrive(*BLUE), "Blue")
    assert len(paired(tmp_path)) == 1
    assert kept_keys(tmp_path) == ["1.key"]


@pytest.mark.parametrize(
    ("file", "content", "word", "left"),
    [
        ("keys", "no folder", "key", paired),
        ("bodydrive.sqlite", "this is no database at all" * 100, "damaged", kept_keys),
    ],
)
def test_where_key_or_database_cannot_be_written_nothing_is_paired(bodydrive, tmp_path, file, content, word, left):
    (tmp_path / "clinic").mkdir()
    (tmp_path / "clinic" / file).write_text(content)
    assert_refused(bodydrive(*BLUE), word)
    assert left(tmp_path) == []


def test_a_database_that_keeps_nothing_leaves_no_key(bodydrive, tmp_path, monkeypatch):
    def fails(*_words, **_details):
        raise sqlite3.OperationalError("disk I/O error")

    monkeypatch.setattr("app.store.log.write_log", fails)
    with pytest.raises(sqlite3.OperationalError):
        bodydrive(*BLUE)
    assert kept_keys(tmp_path) == []
    assert paired(tmp_path) == []


def test_a_database_that_another_program_holds_is_said_so(bodydrive, tmp_path, monkeypatch):
    bodydrive(*BLUE)
    monkeypatch.setattr("app.store.database.PRAGMAS", (*PRAGMAS, "busy_timeout=50"))
    holding = sqlite3.connect(tmp_path / "clinic" / "bodydrive.sqlite", isolation_level=None)
    holding.execute("BEGIN EXCLUSIVE")
    assert_refused(bodydrive(*BLUE[:3], "Red", *BLUE[4:]), "Another program")
    holding.close()
    assert kept_keys(tmp_path) == ["1.key"]


def test_a_key_file_that_was_left_behind_is_not_used_again(bodydrive, tmp_path):
    (tmp_path / "clinic" / "keys").mkdir(parents=True)
    left = pairing.key_file(tmp_path / "clinic" / "keys", 1)
    left.write_text("left")
    assert bodydrive(*BLUE)[0] == 0
    assert left.read_text() == "left"
    assert kept_keys(tmp_path) == ["1.key", "2.key"]
    assert LARGEST_ID == 65_535


def test_receive_is_the_receiver_itself(bodydrive, tmp_path):
    out = output_of(bodydrive("chair", "receive", "--help"))
    assert out.startswith("usage: bodydrive chair receive")
    assert "--omega-max" in out
    assert_refused(bodydrive("chair", "receive"), "--key-file")
    assert_refused(bodydrive("chair", "receive", "--key-file", "none", "--output", "sim", "--port", 0), "none")
    assert_refused(bodydrive("chair", "receive", "--key-file", "none", "--output", "trumpet"), "trumpet")
