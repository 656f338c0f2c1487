"""`bodydrive backup` and `bodydrive restore`, with and without a running program."""

import json
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from cli.answers import assert_refused, output_of
from features.backup.light_key import WORDS, make_light_keys
from store.keeping.filled_clinic import two_patients

from app import realtime
from app.cli.clinic_folder import lock_folder
from app.features.backup import quiet_files
from app.features.backup.tables import MadeBackup
from app.settings import Settings
from app.store.database import Database
from app.store.tables import LogEntry


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(realtime, "take_lowest_priority", lambda: None)  # this process goes on with other tests
    monkeypatch.setattr(quiet_files, "WORKING", 1.0)


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    made = Settings(state=tmp_path / "clinic")
    two_patients(made, "Zebra", "Heron")
    return made


def test_a_disk_died_and_the_clinic_is_there_again(bodydrive: Any, settings: Settings, tmp_path: Path) -> None:
    with lock_folder(settings.state):  # while the program runs
        out = output_of(bodydrive("backup", "clinic.backup", "--state", "clinic"))
    assert "every hash is right" in out
    assert "without the keys" in out
    digest = json.loads(output_of(bodydrive("backup", "clinic.backup", "--check", "--json")))["hash"]
    assert digest in out
    out = output_of(bodydrive("restore", "clinic.backup", "--state", "new", "--json"))
    assert json.loads(out)["hash"] == digest
    with closing(Database(settings.database)) as database, database.transaction() as db:
        last = db.query(LogEntry).order_by(LogEntry.id.desc()).first()
        row = db.query(MadeBackup).order_by(MadeBackup.id.desc()).first()
        assert last is not None
        assert row is not None
        assert (last.person, last.what, last.details["hash"]) == ("command line", "backup made", digest)
        assert (row.name, row.good, row.in_folder) == ("clinic.backup", True, False)
    assert_refused(bodydrive("restore", "clinic.backup", "--state", "new"), "is not empty")


def test_a_folder_with_a_passphrase(
    bodydrive: Any, settings: Settings, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    make_light_keys(monkeypatch)
    (tmp_path / "stick").mkdir()
    monkeypatch.setenv("BODYDRIVE_PASSPHRASE", "short")
    assert "too short" in bodydrive("backup", "stick", "--encrypt", "--state", "clinic")[2]
    monkeypatch.setenv("BODYDRIVE_PASSPHRASE", WORDS)
    code, out, _ = bodydrive("backup", "stick", "--encrypt", "--state", "clinic", "--json")
    assert (code, json.loads(out)["encrypted"]) == (0, True)
    assert bodydrive("backup", "stick", "--state", "clinic")[0] == 0  # the folder says that it is encrypted
    (file,) = [f"stick/{one.name}" for one in (tmp_path / "stick").glob("*.backup")]
    for words in (("restore", "stick", "--state", "new"), ("backup", "stick", "--check")):
        newest = f"stick is a folder of backups: name one of its files; the newest is {file}.\n"
        assert_refused(bodydrive(*words), newest)
    assert bodydrive("restore", file, "--state", "new")[0] == 0
    monkeypatch.setenv("BODYDRIVE_PASSPHRASE", "this is another one")
    assert "passphrase is wrong" in bodydrive("restore", file, "--state", "newer")[2]
    monkeypatch.delenv("BODYDRIVE_PASSPHRASE")
    assert "BODYDRIVE_PASSPHRASE" in bodydrive("restore", file, "--state", "newer")[2]


def test_bad_input_is_one_sentence(bodydrive: Any, settings: Settings) -> None:
    for words, sentence in (
        (("backup", "a.backup", "--state", "nothing"), "There is no clinic in"),
        (("backup", "none/a.backup", "--state", "clinic"), "make it, or choose another place"),
        (("restore", "a.backup"), "There is no backup a.backup: name a file"),
        (("restore", "clinic/bodydrive.sqlite", "--state", "new"), "This file is damaged or was cut off"),
        (("backup", "clinic/bodydrive.sqlite", "--check"), "This file is damaged or was cut off"),
        (("restore", "clinic/bodydrive.sqlite", "--erased", "none.json"), "There is no file none.json"),
    ):
        assert_refused(bodydrive(*words), sentence)


def test_the_folder_of_another_clinic_is_one_sentence(bodydrive: Any, settings: Settings, tmp_path: Path) -> None:
    two_patients(Settings(state=tmp_path / "neighbour"), "Zebra")
    (tmp_path / "stick").mkdir()
    assert bodydrive("backup", "stick", "--state", "neighbour")[0] == 0
    assert_refused(
        bodydrive("backup", "stick", "--state", "clinic"),
        "stick holds the backups of another clinic: choose a folder of its own for this one.",
    )
