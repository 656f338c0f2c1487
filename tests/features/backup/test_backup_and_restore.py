"""A clinic that is backed up, in one file or in a folder, and restored: equal by hash, or one sentence."""

import hashlib
import os
import shutil
import sqlite3
import subprocess
import tarfile
from contextlib import closing
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from pyrage import x25519
from store.keeping.filled_clinic import mentions, two_patients

from app.features.backup import backup_folder, contents, service
from app.features.backup.age_files import Secret
from app.features.backup.backup_file import read_backup, sealed_key_of
from app.features.backup.backup_folder import BackupFolder
from app.features.backup.restoration import restore
from app.features.backup.service import make_backup
from app.refusals import Conflict, Refusal
from app.settings import Settings
from app.store.database import Database
from app.store.keeping.erasure import erase_patient
from app.store.keeping.tombstones import read_tombstones
from app.store.log import write_log
from app.store.log_chain import verify_log
from app.store.patients import delete_patient
from app.store.tables import LogEntry

SECRET, OTHER = (Secret(str(x25519.Identity.generate()), f"sealed key {number}") for number in range(2))
GOES, STAYS = "Zebra", "Heron"
NOBODY: frozenset[Any] = frozenset()


@pytest.fixture
def settings(tmp_path: Path) -> Settings:
    made = Settings(state=tmp_path / "clinic")
    two_patients(made, GOES, STAYS)
    for folder, name in (
        *((made.keys, "1.key"), (made.authority, "root.key")),
        *((made.floorplans, "ward.json"), (made.models, "table.glb")),
    ):
        folder.mkdir(exist_ok=True)
        (folder / name).write_bytes(os.urandom(2_000_000 if folder == made.floorplans else 32))
    (made.runs / "empty").mkdir()
    (made.runs / "empty" / "end.json").write_bytes(b"")
    return made


@pytest.fixture(params=["file", "folder"])
def target(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    if request.param == "folder":
        return Path(request.getfixturevalue("stick"))
    return tmp_path / "clinic.backup"


def made(settings: Settings, target: Path, secret: Secret | None = None, *, with_keys: bool = False) -> Path:
    report = make_backup(settings, target, secret, with_keys=with_keys, progress=lambda *_: None)
    return target / report.name if target.is_dir() else target


def places_in(archive: Path) -> list[int]:
    """Return places within the contents of some files: bytes that fill an archive up mean nothing."""
    with tarfile.open(archive) as tar:
        return [member.offset_data + member.size // 2 for member in tar if member.size][-3:]


def files_of(settings: Settings) -> dict[str, str]:
    """Return the hash of each file that belongs into a backup, but the database."""
    left_out = ("bodydrive.sqlite", "keys/", "authority/", "backup/")
    names = {file.relative_to(settings.state).as_posix(): file for file in settings.state.rglob("*") if file.is_file()}
    return {
        name: hashlib.sha256(file.read_bytes()).hexdigest()
        for name, file in names.items()
        if not name.startswith(left_out)
    }


def rows_of(file: Path) -> dict[str, str]:
    """Return the hash of the content of each table but the log's, which names the restoring."""
    with closing(sqlite3.connect(file)) as connection:
        names = [row[0] for row in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
        return {
            name: hashlib.sha256(repr(connection.execute(f"SELECT * FROM {name}").fetchall()).encode()).hexdigest()
            for name in names
            if name != "log"
        }


def log_of(settings: Settings) -> list[str]:
    with closing(Database(settings.database)) as database, database.transaction() as db:
        return [row.what for row in db.query(LogEntry).order_by(LogEntry.id)]


@pytest.mark.parametrize("secret", [None, SECRET], ids=["plain", "sealed"])
def test_a_restored_clinic_is_equal_by_hash(settings: Settings, target: Path, secret: Secret | None) -> None:
    other = Settings(state=settings.state.parent / "other")
    file = made(settings, target, secret)
    assert sealed_key_of(file) == (None if secret is None else secret.sealed)
    done = restore(file, other, secret, NOBODY)
    assert done.erased_again == 0
    assert files_of(other) == files_of(settings)
    assert len(files_of(other)) == 11
    assert rows_of(other.database) == rows_of(settings.database)
    assert log_of(other) == [*log_of(settings), "clinic restored"]
    assert verify_log(other.database).whole
    assert not other.keys.exists()
    assert not other.authority.exists()
    assert [place.name for place in settings.backup.iterdir()] == ["lock"]
    readable = [place for place in other.state.rglob("*") if place.stat().st_mode & 0o077]
    assert readable == []
    places = [target] if target.is_file() else [each for each in target.rglob("*") if each.is_file()]
    if secret is not None:
        assert not any(GOES.encode() in each.read_bytes() for each in places)


def test_the_keys_are_in_it_only_on_request_and_it_says_so(settings: Settings, target: Path) -> None:
    other = Settings(state=settings.state.parent / "other")
    done = restore(made(settings, target, with_keys=True), other, None, NOBODY)
    assert done.manifest.with_keys
    for name in ("keys/1.key", "authority/root.key"):
        assert (other.state / name).read_bytes() == (settings.state / name).read_bytes()


def test_a_place_that_is_not_empty_stays_as_it_is(settings: Settings, target: Path) -> None:
    file = made(settings, target)
    before = files_of(settings), rows_of(settings.database)
    with pytest.raises(Refusal, match=r"is not empty, it holds .*: restore into an empty folder"):
        restore(file, settings, None, NOBODY)
    assert (files_of(settings), rows_of(settings.database)) == before


def test_any_changed_or_missing_byte_is_found_and_nothing_is_restored(settings: Settings, target: Path) -> None:
    for secret in (None, SECRET):
        place = target if target.is_dir() else target.with_name(f"{target.name}-{secret is None}")
        if target.is_dir():
            shutil.rmtree(target)
            target.mkdir()
        file = made(settings, place, secret)
        full = [part for part in place.glob("parts/*") if "recording-empty" not in part.name]  # that one has no content
        parts = [file, *full] if target.is_dir() else [file]
        for part in sorted(parts, key=lambda each: -each.stat().st_size)[:5]:
            whole = part.read_bytes()
            for at in places_in(part) if secret is None else (len(whole) // 3, len(whole) * 2 // 3):
                part.write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1 :])
                with pytest.raises(Refusal):
                    read_backup(file, secret)
            part.write_bytes(whole[:at])
            with pytest.raises(Refusal):
                restore(file, Settings(state=settings.state.parent / "other"), secret, NOBODY)
            assert not any((settings.state.parent / "other").iterdir())
            part.write_bytes(whole)
        read_backup(file, secret)


def test_another_passphrase_is_one_sentence(settings: Settings, target: Path) -> None:
    file = made(settings, target, SECRET)
    with pytest.raises(Refusal, match="passphrase is wrong"):
        read_backup(file, OTHER)
    if target.is_dir():
        for secret in (None, OTHER):
            with pytest.raises(Refusal, match="passphrase"):
                made(settings, target, secret)


def test_a_backup_in_one_file_is_read_by_tar(settings: Settings, tmp_path: Path) -> None:
    file = made(settings, tmp_path / "clinic.tar")
    listed = subprocess.run(["tar", "tf", str(file)], capture_output=True, text=True, check=True).stdout.split("\n")
    assert listed[-2] == "manifest.json"
    assert "bodydrive.sqlite" in listed
    with tarfile.open(file) as tar:
        assert {member.mode for member in tar} == {0o600}


def test_a_recording_is_copied_once_and_so_are_uploads_until_one_is_changed(
    settings: Settings, stick: Path, tmp_path: Path
) -> None:
    made(settings, stick)

    def parts() -> dict[str, int]:
        return {file.name: file.stat().st_mtime_ns for file in stick.glob("parts/*")}

    first = parts()
    assert sorted(name.partition("-")[0] for name in first) == ["database", *["recording"] * 3, "uploads"]
    made(settings, stick)
    new = parts().items() - first.items()
    assert [name.partition("-")[0] for name, _ in new] == ["database"]
    (settings.floorplans / "ward.json").write_bytes(b"changed")
    file = made(settings, stick)
    assert len([name for name in parts() if name.startswith("uploads")]) == 1  # of one day the newest backup stays
    restore(file, Settings(state=tmp_path / "other"), None, NOBODY)
    assert (tmp_path / "other" / "floorplans" / "ward.json").read_bytes() == b"changed"


def test_a_damaged_part_is_stored_again(settings: Settings, stick: Path) -> None:
    first = made(settings, stick)
    (uploads,) = stick.glob("parts/uploads-*")
    uploads.write_bytes(b"rotten")
    with pytest.raises(Refusal, match=f"{uploads.name} is missing or was changed"):
        read_backup(first, None)
    read_backup(made(settings, stick), None)


def test_what_a_killed_backup_has_left_goes_with_the_next_one(settings: Settings, stick: Path) -> None:
    (stick / ".bodydrive-2026-01-01T02-00-00-000000Z.backup.part").write_bytes(b"cut off")
    made(settings, stick)
    assert list(stick.rglob(".*")) == []


def test_only_the_backups_to_keep_stay_with_their_contents(settings: Settings, stick: Path, monkeypatch: Any) -> None:
    start = datetime(2026, 1, 1, 2, tzinfo=UTC)
    for day in range(12):
        (settings.files / "changing.csv").write_bytes(f"day {day}".encode())
        monkeypatch.setattr(backup_folder, "utc_now", lambda day=day: start + timedelta(days=day))
        monkeypatch.setattr(contents, "passed_of", lambda _, day=day: start + timedelta(days=day))
        made(settings, stick)
    names = BackupFolder(stick, None).names()
    assert len(names) == 8  # 7 daily ones, and that of Sunday 4 January, the newest of its week
    for name in names:
        read_backup(stick / name, None)
    stored = set()
    for part in stick.glob("parts/uploads-*"):
        with tarfile.open(part) as tar:
            stored.add(tar.extractfile("files/changing.csv").read())  # type: ignore[union-attr]
    assert stored == {f"day {day}".encode() for day in (3, *range(5, 12))}


def test_no_backup_goes_because_the_clock_was_set_forward(settings: Settings, stick: Path, monkeypatch: Any) -> None:
    names = []
    for start in range(9):
        ahead = datetime.now(UTC) + timedelta(days=31 * start)
        monkeypatch.setattr(backup_folder, "utc_now", lambda ahead=ahead: ahead)
        names.append(made(settings, stick).name)
    assert BackupFolder(stick, None).names() == sorted(names)


def test_a_recording_that_goes_on_is_left_out_and_said_and_a_broken_one_is_not(
    settings: Settings, tmp_path: Path
) -> None:
    for name, age in (("goes-on", 0), ("killed", 3600)):
        folder = settings.runs / name
        folder.mkdir()
        (folder / "segment-0000.arrows").write_bytes(b"rows")
        moment = datetime.now(UTC).timestamp() - age
        os.utime(folder / "segment-0000.arrows", (moment, moment))
    report = make_backup(settings, tmp_path / "a.backup", None, with_keys=False, progress=lambda *_: None)
    assert str(report.message) == "One recording was going on and left out: the next backup holds it."
    paths = {file.path for file in read_backup(tmp_path / "a.backup", None).files}
    assert "runs/killed/segment-0000.arrows" in paths
    assert not any(path.startswith("runs/goes-on") for path in paths)


def test_somebody_may_write_to_the_database_meanwhile(settings: Settings, tmp_path: Path) -> None:
    """Rows are added between any two steps of the copy; the backup is of one moment, and the log's head fits."""
    database = Database(settings.database)
    head = contents._head_of

    def then_write(known: Settings) -> Path:
        file = shutil.copy(head(known), tmp_path / "head")
        with database.transaction() as db:
            write_log(db, "Ada", "something happened")
        return Path(file).rename(tmp_path / head(known).name)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(contents, "_head_of", then_write)
        file = made(settings, tmp_path / "a.backup")
    database.close()
    other = Settings(state=tmp_path / "other")
    restore(file, other, None, NOBODY)
    assert log_of(other)[-3:] == ["something happened", "log head behind", "clinic restored"]
    assert verify_log(other.database).whole


def test_no_room_or_no_folder_is_a_sentence_and_leaves_nothing(settings: Settings, tmp_path: Path) -> None:
    with pytest.raises(Refusal, match=r"no folder .*: make it"):
        made(settings, tmp_path / "missing" / "a.backup")
    file = made(settings, tmp_path / "a.backup")
    with pytest.raises(Refusal, match="already: choose another name"):
        made(settings, file)
    with pytest.raises(Refusal, match="There is no clinic in"):
        made(Settings(state=tmp_path / "nothing"), tmp_path / "b.backup")
    with service._one_at_a_time(settings), pytest.raises(Conflict, match="Another backup"):
        made(settings, tmp_path / "c.backup")
    assert sorted(each.name for each in tmp_path.iterdir()) == ["a.backup", "clinic", "nothing"]


def test_who_was_erased_stays_erased_whatever_is_restored(
    settings: Settings, target: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = made(settings, target)
    (settings.state.parent / "older").mkdir()
    older = made(settings, settings.state.parent / "older" / "clinic.backup")
    database = Database(settings.database)
    with database.transaction() as db:
        delete_patient(db, 1)
    erase_patient(database, settings, 1, "Ada")
    database.close()
    tomorrow = datetime.now(UTC) + timedelta(days=1)
    monkeypatch.setattr(backup_folder, "utc_now", lambda: tomorrow)
    newer = made(settings, target if target.is_dir() else target.with_name("newer.backup"))
    assert list(mentions(settings.state, GOES)) == []
    first, second, third = (Settings(state=settings.state.parent / name) for name in ("one", "two", "three"))
    # The list lies in the folder of the backups, is given, or was left in the state folder.
    restore(file, first, None, NOBODY if target.is_dir() else read_tombstones(settings.erased))
    third.state.mkdir()
    shutil.copy(settings.erased, third.erased)
    assert restore(older, third, None, NOBODY).erased_again == 1
    assert restore(newer, second, None, NOBODY).erased_again == 0
    for restored in (first, second, third):
        assert list(mentions(restored.state, GOES)) == []
        assert list(mentions(restored.state, STAYS))
        assert read_tombstones(restored.erased) == read_tombstones(settings.erased)
        assert verify_log(restored.database).whole
