"""What the running program does by itself: it erases the patients who were deleted 30 days ago."""

import time
from collections.abc import Callable
from dataclasses import replace
from datetime import timedelta
from typing import Any

import pytest
from api.fake_clinic import Clinic
from api.running_app import running

from app.clock import utc_now
from app.settings import Settings
from app.store import log
from app.store.access.visible_patients import WITH_DELETED
from app.store.database import Database
from app.store.keeping import erasure, erasure_watch, passed_time
from app.store.keeping.erasure import erase_due
from app.store.keeping.passed_time import clock_warning
from app.store.patients import add_patient, delete_patient, restore_patient
from app.store.people import add_clinic, the_clinic
from app.store.tables import Patient

PATIENCE = 60.0  # s


def until(true: Callable[[], Any]) -> Any:
    """Wait until something is true, and return it."""
    end = time.monotonic() + PATIENCE
    while not (found := true()):
        assert time.monotonic() < end
        time.sleep(0.05)
    return found


def database_of(clinic: Clinic) -> Database:
    return clinic.database


def test_a_program_that_runs_erases_who_was_deleted_31_days_ago(settings: Settings) -> None:
    for clinic in running(settings):
        with database_of(clinic).transaction() as db:
            if the_clinic(db) is None:
                add_clinic(db, "Clinic")
            for days in (31, 29):
                patient = add_patient(db, f"P-{days}", "Heron", "")
                patient.deleted = utc_now() - timedelta(days=days)
    for clinic in running(settings):

        def is_erased(clinic: Clinic = clinic) -> bool:
            return "patient erased" in [row.what for row in clinic.log()]

        until(is_erased)
        with database_of(clinic).transaction() as db:
            codes = {patient.code for patient in db.query(Patient).execution_options(**WITH_DELETED)}
        assert "P-29" in codes
        assert "P-31" not in codes
        assert [row.what for row in clinic.log()].count("patient erased") == 1


def test_a_start_with_a_clock_31_days_ahead_erases_nobody_and_says_so(
    settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    for clinic in running(settings):
        with database_of(clinic).transaction() as db:
            if the_clinic(db) is None:
                add_clinic(db, "Clinic")
            patient = add_patient(db, "P-1", "Heron", "")
            delete_patient(db, patient.id)
    now = passed_time._reading()
    ahead = replace(now, wall=now.wall + timedelta(days=31))
    monkeypatch.setattr(passed_time, "_reading", lambda: ahead)
    for module in (log, erasure):
        monkeypatch.setattr(module, "utc_now", lambda: ahead.wall)
    looked_after: list[str] = []

    def erase_and_note(*given: Any) -> None:
        erase_due(*given)
        looked_after.append("erased")

    monkeypatch.setattr(erasure_watch, "erase_due", erase_and_note)
    for clinic in running(settings):
        until(lambda: looked_after)
        assert [row.what for row in clinic.log()].count("clock jumped") == 1
        with database_of(clinic).transaction() as db:
            assert "31 days" in clock_warning(db)
            restore_patient(db, patient.id)
