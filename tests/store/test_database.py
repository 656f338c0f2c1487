"""Transactions are whole, durable and refused in a sentence."""

from pathlib import Path

import pytest
from sqlalchemy import text
from sqlalchemy.exc import IntegrityError, OperationalError

from app.clock import utc_now
from app.refusals import DiskFull, Unavailable
from app.store import database as database_module
from app.store.database import PRAGMAS, Database, make_engine
from app.store.patients import add_patient
from app.store.people import add_clinic
from app.store.tables import Clinic, Patient


def test_every_connection_is_durable_and_keeps_references_whole(tmp_path: Path) -> None:
    engine = make_engine(tmp_path / "a.sqlite")
    with engine.connect() as connection:
        asked = ("journal_mode", "synchronous", "foreign_keys")
        answers = [connection.execute(text(f"PRAGMA {name}")).scalar() for name in asked]
    engine.dispose()
    assert answers == ["wal", 2, 1]


def add_clinic_and_break(database: Database) -> None:
    with database.transaction() as db:
        db.add(Clinic(name="Lost", created=utc_now(), unused=[]))
        db.flush()
        db.execute(text("INSERT INTO person (clinic_id) VALUES (NULL)"))


def test_a_broken_transaction_leaves_nothing_and_content_survives_reopening(tmp_path: Path) -> None:
    file = tmp_path / "folder" / "a.sqlite"
    database = Database(file)
    with database.transaction() as db:
        db.add(Clinic(name="Kept", created=utc_now(), unused=[]))
    with pytest.raises(IntegrityError):
        add_clinic_and_break(database)
    database.close()
    reopened = Database(file)
    with reopened.transaction() as db:
        clinics = db.query(Clinic).all()
    reopened.close()
    assert [clinic.name for clinic in clinics] == ["Kept"]
    assert clinics[0].created.utcoffset() is not None


def test_a_patient_of_no_clinic_is_refused(database: Database) -> None:
    with pytest.raises(IntegrityError), database.transaction() as db:
        db.add(Patient(clinic_id=7, code="A", pseudonym="A", note="", created=utc_now(), deleted=None))


def add_many_patients(database: Database) -> None:
    with database.transaction() as db:
        for number in range(100):
            add_patient(db, f"P-{number}", "Heron", "n" * 2000)


def test_a_full_disk_is_a_refusal_in_a_sentence_and_what_was_there_stays(database: Database) -> None:
    with database.transaction() as db:
        add_clinic(db, "Kept")
        pages = db.execute(text("PRAGMA page_count")).scalar_one()
        db.execute(text(f"PRAGMA max_page_count = {pages + 1}"))  # of this connection, which the pool keeps
    with pytest.raises(DiskFull, match="make room"):
        add_many_patients(database)
    with database.transaction() as db:
        assert db.query(Patient).count() == 0
        assert [kept.name for kept in db.query(Clinic)] == ["Kept"]


def test_a_database_that_another_program_holds_is_a_refusal(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(database_module, "PRAGMAS", (*PRAGMAS, "busy_timeout=1"))
    database = Database(tmp_path / "a.sqlite")
    other = make_engine(tmp_path / "a.sqlite")
    with (
        other.begin(),  # takes the file for writing at once
        pytest.raises(Unavailable, match="Another program"),
        database.transaction() as db,
    ):
        add_clinic(db, "Late")
    other.dispose()
    database.close()


def test_who_reads_waits_for_nobody_and_sees_what_was_committed(database: Database) -> None:
    with database.transaction() as db:
        add_clinic(db, "Kept")
        db.flush()
        with database.reading() as beside:
            assert beside.query(Clinic).count() == 0
    with database.reading() as beside:
        assert beside.query(Clinic).count() == 1
        with database.transaction() as db:
            add_patient(db, "P-1", "Heron", "")
        assert beside.query(Patient).count() == 0


def test_who_reads_cannot_write(database: Database) -> None:
    with pytest.raises(OperationalError, match="readonly"), database.reading() as db:
        add_clinic(db, "Lost")
    with database.reading() as db:
        assert db.query(Clinic).count() == 0


def test_who_reads_keeps_the_write_ahead_log_from_being_emptied_and_it_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(database_module, "PRAGMAS", (*PRAGMAS, "busy_timeout=1"))
    database = Database(tmp_path / "a.sqlite")
    with database.reading() as reader:
        reader.query(Clinic).count()
        with database.transaction() as db:
            add_clinic(db, "Kept")
        with pytest.raises(Unavailable, match="they go when the program ends"):
            database.empty_write_ahead_log()
    database.close()
    assert not (tmp_path / "a.sqlite-wal").exists()


def test_a_mistake_of_ours_is_no_full_disk(database: Database) -> None:
    with pytest.raises(OperationalError), database.transaction() as db:
        db.execute(text("SELECT nothing FROM nowhere"))
