"""What the running program does by itself: it makes the backup of the night."""

from pathlib import Path
from typing import Any

import pytest
from api.fake_clinic import until
from api.running_app import running

from app.clock import utc_now
from app.features.backup.backup_file import read_backup
from app.features.backup.made_backups import last_in_folder
from app.features.backup.night_backups import backup_settings
from app.settings import Settings
from app.store.database import Database


@pytest.fixture
def night(settings: Settings, stick: Path) -> Path:
    """A clinic that has ended: a folder is chosen, and the hour is now."""
    for clinic in running(settings):
        with clinic.rows() as rows:
            kept = backup_settings(rows.db)
            kept.folder, kept.hour = str(stick), utc_now().astimezone().hour
            rows.db.add(kept)
    return stick


def test_a_program_that_runs_makes_the_backup_of_the_night(settings: Settings, night: Path) -> None:
    for clinic in running(settings):
        database = clinic.database

        def made(database: Database = database) -> Any:
            with database.transaction() as db:
                return last_in_folder(db, good=True)

        until(made, patience=300.0)  # the process of the backup has the lowest priority
    (backup,) = night.glob("*.backup")
    read_backup(backup, None)
