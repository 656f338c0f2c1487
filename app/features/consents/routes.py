"""The consents of a patient: recording, use for the clinic's prior, sharing outside."""

from datetime import date

from fastapi import APIRouter

from app.api.answers import Answer, MomentText
from app.api.deps import Anyone, Clinician, Db, LivePart, RowId
from app.api.page_session import OWN_NAME, any_session
from app.features.consents.service import consent_history, give_consent, withdraw_consent
from app.features.registration import features
from app.news import News
from app.quantities import Document
from app.store.consent import CONSENTS, Consent
from app.store.database import Transaction
from app.store.log import log_viewing, write_log
from app.store.patients import find_patient

router = APIRouter(tags=["records"])


class GivenConsent(Document):
    """The day on which a patient consented."""

    given: date


class ConsentRow(Answer):
    """A consent of a patient, in force while `withdrawn` is null."""

    given: date
    person: str  # who entered it
    written: MomentText
    withdrawn: MomentText | None
    withdrawn_by: str | None


class ConsentView(Document):
    """One kind of consent, with its history, the newest first."""

    consent: Consent
    given: date | None
    history: list[ConsentRow]


class ConsentsView(Document):
    """The consents of a patient."""

    patient_id: int
    code: str
    consents: list[ConsentView]


@router.get("/patients/{patient_id}/consents")
def consents(patient_id: RowId, person: Anyone, database: Db) -> ConsentsView:
    """Return the consents of a patient."""
    with database.transaction(closing=True) as db:
        find_patient(db, patient_id)
        log_viewing(db, person.name, patient_id)
        return _view(db, patient_id)


@router.put("/patients/{patient_id}/consents/{consent}")
@any_session(OWN_NAME)
def give(
    patient_id: RowId, consent: Consent, body: GivenConsent, person: Clinician, database: Db, live: LivePart
) -> ConsentsView:
    """Enter the day on which a patient consented; another day replaces the one before.

    Without consent to `recording`, each run in a worn shirt is refused with 409.
    """
    with database.transaction() as db:
        find_patient(db, patient_id)
        if give_consent(db, patient_id, consent, body.given, person.name):
            given = body.given.isoformat()
            write_log(db, person.name, "consent given", patient=patient_id, consent=consent, given=given)
        answer = _view(db, patient_id)
    live.notify(News(what="consent", patient=patient_id))
    return answer


@router.delete("/patients/{patient_id}/consents/{consent}")
@any_session(OWN_NAME)
def withdraw(patient_id: RowId, consent: Consent, person: Clinician, database: Db, live: LivePart) -> ConsentsView:
    """Enter that a patient has withdrawn a consent."""
    with database.transaction() as db:
        find_patient(db, patient_id)
        if withdraw_consent(db, patient_id, consent, person.name):
            write_log(db, person.name, "consent withdrawn", patient=patient_id, consent=consent)
        for feature in features().values():
            feature.consent_withdrawn(db, patient_id, consent)
        answer = _view(db, patient_id)
    live.notify(News(what="consent", patient=patient_id))
    return answer


def _view(db: Transaction, patient_id: int) -> ConsentsView:
    rows = consent_history(db, patient_id)[::-1]
    kinds = []
    for consent in CONSENTS:
        rows_of_consent = [row for row in rows if row.consent == consent]
        now = next((row for row in rows_of_consent if row.withdrawn is None), None)
        kinds.append(
            ConsentView(
                consent=consent,
                given=None if now is None else now.given,
                history=[ConsentRow.of(row) for row in rows_of_consent],
            )
        )
    return ConsentsView(patient_id=patient_id, code=find_patient(db, patient_id).code, consents=kinds)
