"""A deleted patient: hidden everywhere, restored within 30 days, then erased, with files, copies and tombstone."""

import json
import shutil
import sqlite3
from contextlib import closing
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa
from store.keeping.filled_clinic import mentions, named_ids, rows_by_table, two_patients

from app.clock import utc_now
from app.refusals import Conflict, NotFound, Unavailable
from app.settings import Settings
from app.store.database import Database
from app.store.keeping import erasure, passed_time
from app.store.keeping.erasure import (
    UNDO_ENDED,
    UNDO_FOR,
    deleted_patients,
    erase_again,
    erase_due,
    erase_patient,
)
from app.store.keeping.incidents import lift_incident, mark_incident
from app.store.keeping.keeping_tables import ErasedPatient
from app.store.keeping.owned_rows import foreign_keys
from app.store.keeping.passed_time import DAY, store_clocks
from app.store.keeping.record_time import set_record_time, years_later
from app.store.keeping.tombstones import add_tombstones, read_tombstones
from app.store.log_chain import verify_log
from app.store.patients import add_patient, delete_patient, restore_patient, start_session
from app.store.schema import metadata
from app.store.tables import LogEntry, Patient, PatientSession, Table

GOES, STAYS = "Zebra", "Heron"
CLINIC = 1


class Filled:
    """A clinic with two patients who have a row in each table, and files; the incident's marks are lifted."""

    def __init__(self, settings: Settings) -> None:
        self.settings = settings
        self.goes, self.stays = two_patients(settings, GOES, STAYS)
        self.database = Database(settings.database)

    def delete(self, patient: int, reason: str = "") -> None:
        with self.database.transaction() as db:
            delete_patient(db, patient, reason)

    def erase(self, patient: int) -> None:
        erase_patient(self.database, self.settings, patient, "Ada")

    def look(self) -> None:
        with self.database.transaction() as db:
            store_clocks(db)

    def log(self) -> list[LogEntry]:
        with self.database.transaction() as db:
            return list(db.query(LogEntry).order_by(LogEntry.id))


@pytest.fixture
def filled(tmp_path: Path) -> Any:
    made = Filled(Settings(state=tmp_path / "state"))
    yield made
    made.database.close()


def later(monkeypatch: pytest.MonkeyPatch, days: float) -> None:
    """Let these days pass, which the machine runs through."""
    now = passed_time._reading()
    after = replace(now, wall=now.wall + timedelta(days=days), count=now.count + days * DAY)
    monkeypatch.setattr(passed_time, "_reading", lambda: after)


def test_an_erased_patient_leaves_no_row_and_no_file_and_the_log_says_so(filled: Filled) -> None:
    settings = filled.settings
    before = rows_by_table(settings.database, filled.stays)
    copy = settings.state / f"{settings.database.name}.schema-0009.2026-01-01T00-00-00-000000Z.backup"
    filled.database.empty_write_ahead_log()
    shutil.copy(settings.database, copy)
    assert len(list(mentions(settings.state, GOES))) > 5
    filled.delete(filled.goes)
    filled.erase(filled.goes)
    assert rows_by_table(settings.database, filled.goes) == {}
    assert filled.goes not in {value for _, value in named_ids(settings.database)}
    assert list(mentions(settings.state, GOES)) == []
    assert rows_by_table(settings.database, filled.stays) == before
    assert len(list(mentions(settings.state, STAYS))) > 5
    with closing(sqlite3.connect(settings.database)) as connection:
        assert connection.execute("PRAGMA foreign_key_check").fetchall() == []
        (patients,) = connection.execute("SELECT patients FROM person WHERE name = 'Rita'").fetchone()
    assert json.loads(patients) == [filled.stays]
    last = filled.log()[-1]
    assert (last.person, last.what, last.details["patient"]) == ("Ada", "patient erased", filled.goes)
    assert last.details["rows"]["trial"] == 1
    assert verify_log(settings.database).whole


def test_every_table_that_can_name_a_patient_was_filled(filled: Filled) -> None:
    naming = {key.table for key in foreign_keys(metadata()) if key.parent in {"patient", "session", "trial", "run"}}
    assert naming <= set(rows_by_table(filled.settings.database, filled.goes))


def test_a_deleted_patient_is_in_no_query_until_the_deletion_is_undone(filled: Filled) -> None:
    tables = rows_by_table(filled.settings.database, filled.goes)
    owned = [kind.class_ for kind in Table.registry.mappers if kind.class_.__tablename__ in tables]

    def counts() -> dict[str, int]:
        with filled.database.transaction() as db:
            return {kind.__tablename__: len(list(db.scalars(sa.select(kind)))) for kind in owned}

    both = counts()
    filled.delete(filled.goes)
    assert counts() == {table: count // 2 for table, count in both.items()}
    with filled.database.transaction() as db:
        assert db.get(PatientSession, 1) is None
        (listed,) = deleted_patients(db)
        assert (listed.id, listed.recordings, listed.why_not) == (filled.goes, 1, None)
        assert listed.until - listed.deleted == timedelta(days=30)
        restore_patient(db, filled.goes)
        assert db.get(PatientSession, 1) is not None
    assert counts() == both


def test_after_30_days_and_not_before_the_patient_is_erased(filled: Filled, monkeypatch: pytest.MonkeyPatch) -> None:
    filled.look()
    filled.delete(filled.goes)
    later(monkeypatch, 29.9)
    erase_due(filled.database, filled.settings)
    assert rows_by_table(filled.settings.database, filled.goes)
    later(monkeypatch, 0.2)
    erase_due(filled.database, filled.settings)
    assert rows_by_table(filled.settings.database, filled.goes) == {}
    assert list(mentions(filled.settings.state, GOES)) == []


def test_an_erasure_that_was_interrupted_is_finished(filled: Filled, monkeypatch: pytest.MonkeyPatch) -> None:
    filled.delete(filled.goes)
    with monkeypatch.context() as patch:
        patch.setattr(erasure, "_remove", lambda _place: (_ for _ in ()).throw(OSError("the power went")))
        with pytest.raises(OSError, match="power"):
            filled.erase(filled.goes)
    assert rows_by_table(filled.settings.database, filled.goes) == {}
    assert list(mentions(filled.settings.runs, GOES))
    erase_due(filled.database, filled.settings)
    assert list(mentions(filled.settings.state, GOES)) == []
    with filled.database.transaction() as db:
        assert db.get_one(ErasedPatient, filled.goes).files == []


def test_no_id_of_an_erased_row_is_given_again(filled: Filled) -> None:
    filled.delete(filled.stays)  # has the highest ids
    filled.erase(filled.stays)
    with filled.database.transaction() as db:
        first, second = (add_patient(db, f"N-{i}", "New", "") for i in (1, 2))
        session = start_session(db, first.id)
        assert (first.id, second.id, session.id) == (filled.stays + 1, filled.stays + 2, 3)


def test_records_that_must_be_kept_are_deleted_early_only_for_a_reason(filled: Filled) -> None:
    with filled.database.transaction() as db:
        set_record_time(db, 10)
    with pytest.raises(Conflict, match=r"must be kept until 20\d\d-\d\d-\d\d: give a reason"):
        filled.delete(filled.goes)
    filled.delete(filled.goes, "The patient's own wish")
    filled.erase(filled.goes)
    with filled.database.transaction() as db:
        erased = db.query(LogEntry).where(LogEntry.what == "patient erased").one()
    assert (erased.details["reason_given"], erased.details["reason"]) == (True, "")


def test_a_setting_that_came_after_the_deletion_holds_as_well(filled: Filled, monkeypatch: pytest.MonkeyPatch) -> None:
    filled.delete(filled.goes)
    with filled.database.transaction() as db:
        set_record_time(db, 10)
    with pytest.raises(Conflict, match="undo the deletion"):
        filled.erase(filled.goes)
    filled.look()
    later(monkeypatch, 31)
    erase_due(filled.database, filled.settings)
    assert rows_by_table(filled.settings.database, filled.goes)


def test_who_is_part_of_an_incident_stays_until_the_mark_is_lifted(filled: Filled) -> None:
    with filled.database.transaction() as db:
        incident = mark_incident(db, utc_now(), "0" * 64, [filled.goes], "Ada").id
    filled.delete(filled.goes)
    with pytest.raises(Conflict, match="part of the incident of"):
        filled.erase(filled.goes)
    with filled.database.transaction() as db:
        lift_incident(db, incident, "The report is closed", "Ada")
    filled.erase(filled.goes)
    lifted, erased = filled.log()[-2:]
    assert (lifted.what, erased.what) == ("incident mark lifted", "patient erased")
    assert lifted.details == {"incident": incident}  # the words stay with the incident


def test_a_restored_database_loses_the_erased_patients_and_nobody_else(filled: Filled, tmp_path: Path) -> None:
    filled.database.empty_write_ahead_log()
    restored = Settings(state=tmp_path / "restored")
    shutil.copytree(filled.settings.state, restored.state)
    filled.delete(filled.goes)
    filled.erase(filled.goes)
    tombstones = read_tombstones(filled.settings.erased)
    other = Database(restored.database)
    before = rows_by_table(restored.database, filled.stays)
    assert erase_again(other, restored, tombstones) == [filled.goes]
    assert erase_again(other, restored, tombstones) == []
    assert list(mentions(restored.state, GOES)) == []
    assert rows_by_table(restored.database, filled.stays) == before
    assert verify_log(restored.database).whole
    assert read_tombstones(restored.erased) == tombstones
    with other.transaction() as db:  # another patient with the same id is not the one that was erased
        patient = db.get_one(Patient, filled.stays)
        unlike = {type(one)(patient.id, "2001-01-01 00:00:00.000000+00:00", one.erased) for one in tombstones}
    assert erase_again(other, restored, frozenset(unlike)) == []
    other.close()


def test_only_a_deleted_patient_is_erased(filled: Filled) -> None:
    for patient in (filled.goes, 99):
        with pytest.raises(NotFound, match="no deleted patient"):
            filled.erase(patient)


def test_tombstones_are_only_added_and_a_damaged_list_is_said(tmp_path: Path) -> None:
    file = tmp_path / "erased-patients.json"
    assert read_tombstones(file) == frozenset()
    file.write_text('{"erased": [{"patient": 1}]}')
    with pytest.raises(Unavailable, match="cannot be read: put a copy"):
        add_tombstones(file, [])


def test_years_are_counted_also_from_29_february() -> None:
    leap = datetime(2024, 2, 29, tzinfo=UTC)
    assert years_later(leap, 1) == datetime(2025, 3, 1, tzinfo=UTC)
    assert years_later(leap, 4) == datetime(2028, 2, 29, tzinfo=UTC)


def test_the_log_says_after_how_many_days_a_deleted_patient_is_erased() -> None:
    assert f"{UNDO_FOR.days} days after the deletion" == UNDO_ENDED
