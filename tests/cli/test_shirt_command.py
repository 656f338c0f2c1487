"""`bodydrive shirt`: a key for a shirt, and the sender of signed frames."""

import os
import shlex
import socket
import sqlite3
import stat
import subprocess
import sys
from contextlib import closing

import pytest
from cli.answers import assert_refused, output_of

from app.file_modes import NOT_OWNER
from app.hardware.chair.key import read_key
from app.hardware.shirt import sender
from app.hardware.shirt.newest_frame import newest_file, read_newest
from app.hardware.shirt.packet import decode_signed
from app.store.database import Database
from app.store.tables import LogEntry
from folders import ROOT

PAIR = ("shirt", "pair", "--state", "clinic")


@pytest.fixture
def key_file(bodydrive, tmp_path):
    assert bodydrive(*PAIR)[0] == 0
    return tmp_path / "clinic" / "keys" / "shirt-1.key"


@pytest.fixture
def listening():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as made:
        made.bind(("127.0.0.1", 0))
        made.settimeout(10.0)
        yield made, f"127.0.0.1:{made.getsockname()[1]}"


def test_pairing_keeps_a_key_and_says_what_to_do_with_it(bodydrive, tmp_path):
    out = output_of(bodydrive(*PAIR))
    file = tmp_path / "clinic" / "keys" / "shirt-1.key"
    key = read_key(file)
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert stat.S_IMODE(file.parent.stat().st_mode) == 0o700
    assert read_newest(newest_file(file)) == (0, 0)
    assert out.count("█") > 400
    assert key.secret.hex() not in out
    given = sender._parser("sender").parse_args(shlex.split(out.splitlines()[-1].replace("HOST", "10.0.0.7"))[3:])
    assert (str(given.key_file), given.to) == ("shirt-1.key", ("10.0.0.7", 5252))
    with closing(Database(tmp_path / "clinic" / "bodydrive.sqlite")) as database, database.transaction() as db:
        assert [(row.what, row.details) for row in db.query(LogEntry)] == [("shirt paired", {"key_id": 1})]


def test_a_pairing_writes_nothing_that_others_can_read(bodydrive, tmp_path):
    before = os.umask(0o022)
    try:
        assert bodydrive(*PAIR)[0] == 0
    finally:
        os.umask(before)
    files = (tmp_path / "clinic").rglob("*")
    assert [file.name for file in files if stat.S_IMODE(file.stat().st_mode) & NOT_OWNER] == []


def test_a_number_of_a_key_is_never_used_again(bodydrive, key_file):
    key_file.unlink()  # out of use
    assert bodydrive(*PAIR)[0] == 0
    assert sorted(file.name for file in key_file.parent.glob("*.key")) == ["shirt-2.key"]


def test_a_pairing_that_cannot_be_logged_leaves_no_key(bodydrive, tmp_path, monkeypatch):
    def fails(*_words, **_details):
        raise sqlite3.OperationalError("disk I/O error")

    monkeypatch.setattr("app.store.log.write_log", fails)
    with pytest.raises(sqlite3.OperationalError):
        bodydrive(*PAIR)
    assert list((tmp_path / "clinic" / "keys").iterdir()) == []


def test_each_start_counts_one_further_and_the_frames_are_signed(bodydrive, key_file, listening):
    end, to = listening
    key = read_key(key_file)
    for start in (1, 2, 3):
        assert bodydrive("shirt", "send", "--key-file", key_file, "--to", to, "--rate", 2000, "--frames", 3)[0] == 0
        for seq in range(3):
            content = end.recv(4096)
            boot, (found, microseconds, values) = decode_signed(content, len(content), 52, key)
            assert (boot, found, microseconds, len(values)) == (start, seq, 500 * seq, 52)


def test_a_file_is_sent_at_its_own_times_and_again(bodydrive, key_file, listening, tmp_path):
    end, to = listening
    file = tmp_path / "signals.csv"
    file.write_text("a,t,b\n1,5.0,10\n2,5.01,20\n3,5.02,30\n")
    words = ("shirt", "send", "--key-file", key_file, "--to", to, "--file", file)
    assert bodydrive(*words)[0] == 0
    assert bodydrive(*words, "--loop", "--frames", 5)[0] == 0
    found = []
    for _ in range(8):
        content = end.recv(4096)
        boot, (seq, microseconds, values) = decode_signed(content, len(content), 2, read_key(key_file))
        found.append((boot, seq, microseconds, *values.tolist()))
    assert found[:3] == [(1, 0, 0, 1.0, 10.0), (1, 1, 10_000, 2.0, 20.0), (1, 2, 20_000, 3.0, 30.0)]
    assert found[6:] == [(2, 3, 30_000, 1.0, 10.0), (2, 4, 40_000, 2.0, 20.0)]


def test_it_needs_nothing_but_python(key_file, listening):
    """As on a shirt's own computer: `-S` excludes every installed library."""
    end, to = listening
    command = [sys.executable, "-S", "-m", "app.hardware.shirt.sender", "--key-file", str(key_file), "--to", to]
    said = subprocess.run([*command, "--frames", "1"], cwd=ROOT, capture_output=True, text=True, check=True)
    assert "1 frames sent" in said.stderr
    content = end.recv(4096)
    assert decode_signed(content, len(content), 52, read_key(key_file)) is not None


BAD_OPTIONS = [
    (("--to", "here"), "HOST:PORT"),
    (("--to", "127.0.0.1:0"), "HOST:PORT"),
    (("--to", "a..b:5252"), "no host of the name"),
    (("--rate", "0"), "out of range"),
    (("--rate", "nan"), "out of range"),
    (("--channels", "65"), "out of range"),
    (("--frames", "-1"), "--frames"),
    (("--file", "missing.csv"), "is no CSV file"),
    (("--file", "/dev/zero"), "is no CSV file"),
    (("--file", "words.csv"), "cannot be sent"),
    (("--file", "huge.csv"), "too large for a float32"),
    (("--file", "falls.csv"), "do not rise"),
    (("--file", "short.csv"), "give two rows or more"),
    (("--boot-file", "words.csv"), "no boot counter"),
    (("--boot-file", "/dev/null/x"), "cannot be kept"),
    (("--key-file", "words.csv"), "words.csv"),
    (("--colour", "blue"), "--colour"),
]


def test_bad_input_is_one_sentence(bodydrive, key_file, tmp_path):
    (tmp_path / "words.csv").write_text("t,a\n0,one\n")
    (tmp_path / "huge.csv").write_text("t,a\n0,1\n1,1e300\n")
    (tmp_path / "falls.csv").write_text("t,a\n1,1\n0,1\n")
    (tmp_path / "short.csv").write_text("t,a\n1,1\n")
    for options, word in BAD_OPTIONS:
        assert_refused(bodydrive("shirt", "send", "--key-file", key_file, "--frames", 1, *options), word)
