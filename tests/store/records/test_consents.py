"""Consents of a patient: off until given, withdrawn, and carried over for those who were recorded before."""

import sqlite3
from contextlib import closing
from datetime import date, timedelta
from pathlib import Path

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict
from app.store.database import Database, make_engine
from app.store.patients import add_patient
from app.store.people import add_clinic
from app.store.records.consents import (
    CONSENTS,
    Consent,
    Consents,
    consent_history,
    consents_of,
    give_consent,
    has_consented,
    require_consent,
    withdraw_consent,
)
from app.store.schema import migrate
from app.store.tables import Patient

DAY = date(2026, 3, 1)


@pytest.fixture
def patient(db: Session) -> Patient:
    return add_patient(db, add_clinic(db, "Clinic").id, "P-01", "Heron", "")


@pytest.mark.parametrize("consent", CONSENTS)
def test_a_consent_is_off_until_given_and_after_it_was_withdrawn(
    db: Session, patient: Patient, consent: Consent
) -> None:
    def refused() -> None:
        with pytest.raises(Conflict, match="P-01 has not consented"):
            require_consent(db, patient.id, consent)
        assert db.scalars(select(Patient.id).where(has_consented(consent))).all() == []

    assert consents_of(db, patient.id) == Consents()
    refused()
    assert give_consent(db, patient.id, consent, DAY, "Ada")
    assert not give_consent(db, patient.id, consent, DAY, "Ada")
    require_consent(db, patient.id, consent)
    assert consents_of(db, patient.id) == Consents(**{consent: DAY})
    assert db.scalars(select(Patient.id).where(has_consented(consent))).all() == [patient.id]
    assert withdraw_consent(db, patient.id, consent, "Ben")
    assert not withdraw_consent(db, patient.id, consent, "Ben")
    refused()
    (row,) = consent_history(db, patient.id)
    assert (row.given, row.person, row.withdrawn_by) == (DAY, "Ada", "Ben")


def test_another_day_replaces_the_day_and_the_future_is_refused(db: Session, patient: Patient) -> None:
    give_consent(db, patient.id, "sharing", DAY, "Ada")
    give_consent(db, patient.id, "sharing", DAY + timedelta(days=1), "Ada")
    assert consents_of(db, patient.id).sharing == DAY + timedelta(days=1)
    assert len(consent_history(db, patient.id)) == 2
    with pytest.raises(Conflict, match="not in the future"):
        give_consent(db, patient.id, "sharing", (utc_now() + timedelta(days=2)).date(), "Ada")


def test_who_was_recorded_in_a_worn_shirt_before_keeps_that_consent_and_no_other(tmp_path: Path) -> None:
    file = tmp_path / "clinic.sqlite"
    engine = make_engine(file)
    migrate(engine, "0009")
    engine.dispose()
    with closing(sqlite3.connect(file)) as old:
        old.execute("INSERT INTO clinic (id, name, created, unused) VALUES (1, 'Old', '2025-01-01', '[]')")
        for patient, simulated in ((1, 0), (2, 1), (3, None)):
            old.execute(
                "INSERT INTO patient (id, clinic_id, code, pseudonym, note, created) "
                f"VALUES ({patient}, 1, 'P-{patient}', 'Heron', '', '2025-01-01 00:00:00.000000')"
            )
            old.execute(
                "INSERT INTO session (id, clinic_id, patient_id, number, started, ended, accepted) VALUES "
                f"({patient}, 1, {patient}, 1, '2025-02-03 10:00:00.000000', '2025-02-03 11:00:00.000000', 1)"
            )
            for run, day in (("a", 3), ("b", 4)):
                old.execute(
                    "INSERT INTO run (id, session_id, kind, folder, started, simulated) "
                    f"VALUES ('{run}{patient}', {patient}, 'rest', 'f', '2025-02-0{day} 10:30:00.000000', ?)",
                    (simulated,),
                )
        old.commit()
    database = Database(file)
    carried = Consents(recording=date(2025, 2, 3))
    with database.transaction() as db:
        assert [consents_of(db, patient) for patient in (1, 2, 3)] == [carried, Consents(), carried]
        (row,) = consent_history(db, 1)
        assert row.person is None  # to be confirmed
        assert give_consent(db, 1, "recording", row.given, "Ada")  # the confirmation
        assert consent_history(db, 1)[-1].person == "Ada"
    database.close()
