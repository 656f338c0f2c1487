"""Whose calibrations help a new patient: consent, deletion, the owner's switch."""

from datetime import date

import pytest
from clinic_rows import ClinicRows
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.consents.service import give_consent, withdraw_consent
from app.features.prior.entries import entries_of_others, is_prior_on, may_add, put_entry, remove_entries, switch_prior
from app.store.tables import Patient

SHIRT = "a" * 64


@pytest.fixture
def patients(rows: ClinicRows) -> list[Patient]:
    return [rows.patient(f"P-{i}") for i in range(3)]


def others(db: Session, patient: Patient, *, simulated: bool = False, shirt: str = SHIRT) -> list[str]:
    return [entry["of"] for entry in entries_of_others(db, shirt, patient.id, simulated=simulated)]


def test_an_entry_counts_while_its_patient_consents_and_for_others_only(db: Session, patients: list[Patient]) -> None:
    first, second, third = patients
    assert not may_add(db, first, simulated=False)
    give_consent(db, first.id, "clinic_prior", date(2026, 3, 1), "Ada")
    assert may_add(db, first, simulated=False)
    for patient in (first, second):
        put_entry(db, patient.id, SHIRT, {"of": patient.code}, simulated=False)
    assert others(db, third) == ["P-0"]
    assert others(db, first) == []
    assert others(db, third, shirt="b" * 64) == []
    withdraw_consent(db, first.id, "clinic_prior", "Ada")
    assert others(db, third) == []


def test_practice_needs_no_consent_and_is_never_mixed_with_worn_shirts(db: Session, patients: list[Patient]) -> None:
    first, second, _ = patients
    assert may_add(db, first, simulated=True)
    put_entry(db, first.id, SHIRT, {"of": "P-0"}, simulated=True)
    assert others(db, second, simulated=True) == ["P-0"]
    assert others(db, second) == []


def test_a_later_calibration_replaces_an_earlier_one(db: Session, patients: list[Patient]) -> None:
    first, second, _ = patients
    for number in (1, 2):
        put_entry(db, first.id, SHIRT, {"number": number}, simulated=True)
    found = entries_of_others(db, SHIRT, second.id, simulated=True)
    assert found == [{"number": 2}]


def test_what_a_patient_added_can_be_taken_out_again(db: Session, patients: list[Patient]) -> None:
    first = patients[0]
    for simulated in (False, True):
        put_entry(db, first.id, SHIRT, {"of": "P-0"}, simulated=simulated)
    assert remove_entries(db, first.id) == 1
    assert remove_entries(db, first.id) == 0
    assert others(db, patients[1], simulated=True) == ["P-0"]


def test_a_deleted_patient_helps_nobody(db: Session, patients: list[Patient]) -> None:
    first, second, _ = patients
    put_entry(db, first.id, SHIRT, {"of": "P-0"}, simulated=True)
    first.deleted = utc_now()
    db.flush()
    assert others(db, second, simulated=True) == []


def test_the_owner_switches_it_off_and_on(db: Session, patients: list[Patient]) -> None:
    assert is_prior_on(db)
    assert switch_prior(db, on=False)
    assert not switch_prior(db, on=False)
    assert not is_prior_on(db)
    assert not may_add(db, patients[0], simulated=True)
    assert switch_prior(db, on=True)
    assert may_add(db, patients[0], simulated=True)
