"""Refuse a request whose page shows another session than the open one."""

from contextvars import ContextVar
from datetime import datetime
from typing import NamedTuple

from app.refusals import Conflict
from app.store.database import Transaction
from app.store.patients import open_session
from app.store.people import the_clinic
from app.store.tables import Patient, PatientSession
from app.texts import Text


class PageSession(NamedTuple):
    """The session that a page shows when it sends a request."""

    id: int | None  # None: the page shows that no session is open


PAGE_SESSION: ContextVar[PageSession | None] = ContextVar("page session", default=None)
"""The page session of the current request; None outside of requests, and in those that need not name a session."""


def require_page_session(db: Transaction) -> None:
    """Raise Conflict when the current request names another session than the open one; the sentence names both."""
    page, clinic = PAGE_SESSION.get(), the_clinic(db)
    if page is None or clinic is None:
        return
    now = open_session(db)
    if page.id == (None if now is None else now.id):
        return
    before = None if page.id is None else db.get(PatientSession, page.id)
    if before is not None and before.clinic_id != clinic.id:
        before = None
    raise Conflict(Text("visit-another-session", now=_open_sentence(db, now), page=_page_sentence(db, before)))


def _open_sentence(db: Transaction, now: PatientSession | None) -> Text:
    if now is None:
        return Text("visit-session-ended")
    code, time = _code(db, now), _clock(now.started)
    if now.opened_by:
        return Text("visit-session-opened-by", code=code, person=now.opened_by, time=time)
    return Text("visit-session-opened", code=code, time=time)


def _page_sentence(db: Transaction, before: PatientSession | None) -> Text:
    if before is None:
        return Text("visit-page-of-no-session")
    return Text("visit-page-of-session", code=_code(db, before))


def _code(db: Transaction, session: PatientSession) -> str:
    return db.get_one(Patient, session.patient_id).code


def _clock(moment: datetime) -> str:
    return f"{moment.astimezone():%H:%M}"
