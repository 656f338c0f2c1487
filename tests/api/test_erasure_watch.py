"""What the running program does by itself: it erases the patients who were deleted 30 days ago."""

from dataclasses import replace
from datetime import timedelta
from typing import Any

import pytest
from api.fake_clinic import Clinic, until
from api.running_app import running
from clinic_rows import rows_in

from app.clock import utc_now
from app.settings import Settings
from app.store import log
from app.store.access.visible_patients import WITH_DELETED
from app.store.keeping import erasure, erasure_watch, passed_time
from app.store.keeping.erasure import erase_due
from app.store.keeping.passed_time import clock_warning
from app.store.patients import delete_patient, restore_patient
from app.store.tables import Patient


def test_a_program_that_runs_erases_who_was_deleted_31_days_ago(settings: Settings) -> None:
    with rows_in(settings) as rows:
        for days in (31, 29):
            rows.patient(f"P-{days}").deleted = utc_now() - timedelta(days=days)
    for clinic in running(settings):

        def is_erased(clinic: Clinic = clinic) -> bool:
            return "patient erased" in [row.what for row in clinic.log()]

        until(is_erased)
        with clinic.database.transaction() as db:
            codes = {patient.code for patient in db.query(Patient).execution_options(**WITH_DELETED)}
        assert {"P-29", "P-31"} & codes == {"P-29"}
        assert [row.what for row in clinic.log()].count("patient erased") == 1


def test_a_start_with_a_clock_31_days_ahead_erases_nobody_and_says_so(
    settings: Settings, monkeypatch: pytest.MonkeyPatch
) -> None:
    for clinic in running(settings):
        with clinic.rows() as rows:
            patient = delete_patient(rows.db, rows.patient().id)
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
        with clinic.database.transaction() as db:
            assert "31 days" in str(clock_warning(db))
            restore_patient(db, patient.id)
