"""What the running program does by itself: it makes the backup of the night, and erases patients deleted long ago."""

import time
from collections.abc import Callable
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from fake_clinic import Clinic
from running_app import running

from app.backup import sealing
from app.backup.restoring import check_backup
from app.clock import utc_now
from app.settings import Settings
from app.store.access.visible_patients import WITH_DELETED
from app.store.database import Database
from app.store.keeping.made_backups import last_in_folder
from app.store.keeping.record_time import record_keeping
from app.store.patients import add_patient
from app.store.people import add_clinic, the_clinic
from app.store.tables import Patient

PATIENCE = 60.0  # s: another process makes the backup


def until(true: Callable[[], Any]) -> Any:
    """Wait until something is true, and return it."""
    end = time.monotonic() + PATIENCE
    while not (found := true()):
        assert time.monotonic() < end
        time.sleep(0.05)
    return found


def database_of(clinic: Clinic) -> Database:
    return clinic.client.app.state.people.database  # type: ignore[attr-defined,no-any-return]


@pytest.fixture
def night(settings: Settings, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A clinic that has ended: a folder is chosen, the hour is now, patients were deleted 31 and 29 days ago."""
    monkeypatch.setattr(sealing, "COST", {"n": 2, "r": 1, "p": 1})
    stick = tmp_path / "stick"
    stick.mkdir()
    for clinic in running(settings):
        with database_of(clinic).transaction() as db:
            known = the_clinic(db) or add_clinic(db, "Clinic")
            for days in (31, 29):
                patient = add_patient(db, known.id, f"P-{days}", "Heron", "")
                patient.deleted = utc_now() - timedelta(days=days)
            kept = record_keeping(db, known.id)
            kept.folder, kept.hour = str(stick), utc_now().astimezone().hour
    return stick


def test_a_program_that_runs_makes_the_backup_and_erases(settings: Settings, night: Path) -> None:
    for clinic in running(settings):
        database = database_of(clinic)

        def made(database: Database = database) -> Any:
            with database.transaction() as db:
                return last_in_folder(db, good=True)

        until(made)
        with database.transaction() as db:
            codes = {patient.code for patient in db.query(Patient).execution_options(**WITH_DELETED)}
        assert "P-29" in codes
        assert "P-31" not in codes
        assert [row.what for row in clinic.log()].count("patient erased") == 1
    (backup,) = night.glob("*.backup")
    check_backup(backup, None)
