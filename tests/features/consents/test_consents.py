"""Consents of a patient: off until given, and withdrawn."""

from datetime import date, timedelta

import pytest
from clinic_rows import ClinicRows
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.features.consents.service import consent_history, give_consent, withdraw_consent
from app.refusals import Conflict
from app.store.consent import CONSENTS, Consent, consented, has_consented, require_consent
from app.store.tables import Patient

DAY = date(2026, 3, 1)


@pytest.fixture
def patient(rows: ClinicRows) -> Patient:
    return rows.patient()


@pytest.mark.parametrize("consent", CONSENTS)
def test_a_consent_is_off_until_given_and_after_it_was_withdrawn(
    db: Session, patient: Patient, consent: Consent
) -> None:
    def refused() -> None:
        with pytest.raises(Conflict, match="P-1 has not consented"):
            require_consent(db, patient.id, consent)
        assert db.scalars(select(Patient.id).where(consented(consent))).all() == []

    assert not has_consented(db, patient.id, consent)
    refused()
    assert give_consent(db, patient.id, consent, DAY, "Ada")
    assert not give_consent(db, patient.id, consent, DAY, "Ada")
    require_consent(db, patient.id, consent)
    assert [one for one in CONSENTS if has_consented(db, patient.id, one)] == [consent]
    assert db.scalars(select(Patient.id).where(consented(consent))).all() == [patient.id]
    assert withdraw_consent(db, patient.id, consent, "Ben")
    assert not withdraw_consent(db, patient.id, consent, "Ben")
    refused()
    (row,) = consent_history(db, patient.id)
    assert (row.given, row.person, row.withdrawn_by) == (DAY, "Ada", "Ben")


def test_another_day_replaces_the_day_and_the_future_is_refused(db: Session, patient: Patient) -> None:
    give_consent(db, patient.id, "sharing", DAY, "Ada")
    give_consent(db, patient.id, "sharing", DAY + timedelta(days=1), "Ada")
    before, now = consent_history(db, patient.id)
    assert before.withdrawn is not None
    assert (now.given, now.withdrawn) == (DAY + timedelta(days=1), None)
    with pytest.raises(Conflict, match="not in the future"):
        give_consent(db, patient.id, "sharing", (utc_now() + timedelta(days=2)).date(), "Ada")
