"""What the running program does by itself: it makes the backup of the night."""

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from api.fake_clinic import Clinic
from api.running_app import running

from app.clock import utc_now
from app.features.backup.backup_file import read_backup
from app.features.backup.made_backups import last_in_folder
from app.features.backup.night_backups import backup_settings
from app.settings import Settings
from app.store.database import Database
from app.store.people import add_clinic, the_clinic

PATIENCE = 60.0  # s: another process makes the backup


def until(true: Callable[[], Any]) -> Any:
    """Wait until something is true, and return it."""
    end = time.monotonic() + PATIENCE
    while not (found := true()):
        assert time.monotonic() < end
        time.sleep(0.05)
    return found


def database_of(clinic: Clinic) -> Database:
    return clinic.database


@pytest.fixture
def night(settings: Settings, tmp_path: Path) -> Path:
    """A clinic that has ended: a folder is chosen, and the hour is now."""
    stick = tmp_path / "stick"
    stick.mkdir()
    for clinic in running(settings):
        with database_of(clinic).transaction() as db:
            if the_clinic(db) is None:
                add_clinic(db, "Clinic")
            kept = backup_settings(db)
            kept.folder, kept.hour = str(stick), utc_now().astimezone().hour
            db.add(kept)
    return stick


def test_a_program_that_runs_makes_the_backup_of_the_night(settings: Settings, night: Path) -> None:
    for clinic in running(settings):
        database = database_of(clinic)

        def made(database: Database = database) -> Any:
            with database.transaction() as db:
                return last_in_folder(db, good=True)

        until(made)
    (backup,) = night.glob("*.backup")
    read_backup(backup, None)
