"""Refuse a request whose page shows another session than the open one."""

from contextvars import ContextVar
from datetime import datetime
from typing import NamedTuple

from app.refusals import Conflict
from app.store.database import Transaction
from app.store.patients import open_session
from app.store.people import the_clinic
from app.store.tables import Patient, PatientSession


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
    raise Conflict(f"{_open_sentence(db, now)} {_page_sentence(db, before)}")


def _open_sentence(db: Transaction, now: PatientSession | None) -> str:
    if now is None:
        return "The session was ended on another screen, and no session is open now."
    by = f" by {now.opened_by}" if now.opened_by else ""
    return f"{_code(db, now)} was opened on another screen{by} at {_clock(now.started)}."


def _page_sentence(db: Transaction, before: PatientSession | None) -> str:
    belongs = "to no session" if before is None else f"to {_code(db, before)}"
    return f"What this page shows belongs {belongs} and can no longer be sent: load the page again."


def _code(db: Transaction, session: PatientSession) -> str:
    return db.get_one(Patient, session.patient_id).code


def _clock(moment: datetime) -> str:
    return f"{moment.astimezone():%H:%M}"
