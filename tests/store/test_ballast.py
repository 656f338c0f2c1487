"""On a full disk a session can be ended and people can sign out; on a mounted full disk where that is possible."""

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from clinic_rows import rows_in
from sqlalchemy import text
from store.small_disk import fill, small_disk

from app.refusals import DiskFull
from app.store.access.sign_ins import sign_out, signed_in
from app.store.database import Database
from app.store.files.ballast import HEADROOM, PART, SIZE, Ballast
from app.store.log import write_log
from app.store.log_chain import verify_log
from app.store.patients import add_patient, end_session, open_session
from app.store.people import add_clinic
from folders import ROOT


@pytest.fixture
def disk(tmp_path: Path) -> Iterator[Path]:
    with small_disk(tmp_path / "disk", SIZE + HEADROOM + (12 << 20)) as mounted:
        if mounted is None:
            pytest.skip("no disk may be mounted here, so none can be filled: run as root, or see `make drills`")
        yield mounted


def fill_all(database: Database, disk: Path) -> None:
    """Fill the disk, and the free pages within SQLite's files."""
    fill(disk)
    with pytest.raises(DiskFull, match="disk is full"):
        add_without_end(database)


def add_without_end(database: Database) -> None:
    while True:
        with database.transaction() as db:
            for _ in range(50):
                add_patient(db, os.urandom(8).hex(), "Heron", "n" * 2000)


def test_a_session_ends_and_people_sign_out_on_a_full_disk(disk: Path) -> None:
    file = disk / "clinic.sqlite"
    database = Database(file)
    database.ballast.refill()
    assert database.ballast.file.stat().st_blocks * 512 >= SIZE
    with rows_in(database) as rows:
        rows.open_session()
        token = rows.sign_in("Ada")
    fill_all(database, disk)

    with database.transaction(closing=True) as db:
        end_session(db)
        write_log(db, "Ada", "session ended")
    with database.transaction(closing=True) as db:
        assert sign_out(db, token) is not None
    assert SIZE - 2 * PART <= database.ballast.size < SIZE
    with database.transaction() as db:  # what was written is readable
        assert open_session(db) is None
        assert signed_in(db, token) is None
        assert db.execute(text("PRAGMA integrity_check")).scalar() == "ok"
    assert verify_log(file).whole
    database.close()

    fill(disk)
    again = Database(file)  # the program starts on a full disk, too
    for _ in range(300):
        with again.transaction(closing=True) as db:
            write_log(db, "Ada", "patient viewed", patient=1)
    assert again.ballast.size > 0
    again.ballast.refill()
    assert again.ballast.size < SIZE, "there is no room yet"
    (disk / "filler").unlink()
    again.ballast.refill()
    assert again.ballast.size == SIZE
    again.close()
    assert verify_log(file).whole


def test_another_program_that_takes_what_becomes_free_does_not_take_all(disk: Path) -> None:
    database = Database(disk / "clinic.sqlite")
    database.ballast.refill()
    with database.transaction() as db:
        add_clinic(db, "Clinic")
    for _ in range(4):
        fill_all(database, disk)
        with database.transaction(closing=True) as db:
            write_log(db, "Ada", "session ended")
    database.close()


def test_another_fault_of_the_folder_is_no_full_disk(tmp_path: Path) -> None:
    ballast = Ballast(tmp_path / "nowhere" / "ballast")
    assert (ballast.has_room(), ballast.size) == (True, 0)
    ballast.make_room()


def test_where_zeros_take_no_room_it_is_filled_with_noise(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def sparse(descriptor: int, start: int, size: int) -> None:
        os.ftruncate(descriptor, start + size)

    monkeypatch.setattr(os, "posix_fallocate", sparse)
    ballast = Ballast(tmp_path / "ballast")
    ballast.refill()
    status = ballast.file.stat()
    assert (status.st_size, status.st_mode & 0o077) == (SIZE, 0)
    assert status.st_blocks * 512 >= SIZE


QUOTA = """
import resource, sys
from pathlib import Path
from app.store.database import Database
from app.refusals import DiskFull
from app.store.log import write_log

database = Database(Path(sys.argv[1]))
with database.transaction() as db:
    write_log(db, "Ada", "before")
resource.setrlimit(resource.RLIMIT_FSIZE, (1, 1))
try:
    with database.transaction() as db:
        write_log(db, "Ada", "after")
except DiskFull as full:
    print(full)
database.close()
"""


def test_a_limit_on_the_size_of_files_is_a_full_disk_too(tmp_path: Path) -> None:
    """For machines on which no disk can be mounted: a limit on the size of files."""
    file = tmp_path / "clinic.sqlite"
    command = [sys.executable, "-c", QUOTA, str(file)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    ended = subprocess.run(command, capture_output=True, text=True, env=environment, check=True)
    assert "disk is full" in ended.stdout
    check = verify_log(file)
    assert (check.whole, check.rows) == (True, 1)
