"""The session that the page of a request shows, and the refusal when another one is open."""

from contextvars import ContextVar
from datetime import datetime
from typing import NamedTuple

from app.refusals import Conflict
from app.store.database import Transaction
from app.store.patients import open_session
from app.store.people import the_clinic
from app.store.tables import Patient, PatientSession


class ShownSession(NamedTuple):
    """What a page shows when it sends a request."""

    id: int | None  # of the session; None: the page shows that nobody is here


SHOWN_SESSION: ContextVar[ShownSession | None] = ContextVar("shown session", default=None)
"""Of the request under way; None outside of requests, and in those that need not name a session."""


def require_shown(db: Transaction) -> None:
    """Raise Conflict, with who is open now, when the request under way names another session than the open one."""
    shown, clinic = SHOWN_SESSION.get(), the_clinic(db)
    if shown is None or clinic is None:
        return
    now = open_session(db, clinic.id)
    if shown.id == (None if now is None else now.id):
        return
    before = None if shown.id is None else db.get(PatientSession, shown.id)
    if before is not None and before.clinic_id != clinic.id:
        before = None
    raise Conflict(f"{_now(db, now)} {_before(db, before)}")


def _now(db: Transaction, now: PatientSession | None) -> str:
    if now is None:
        return "The session was ended on another screen, and nobody is here now."
    by = f" by {now.opened_by}" if now.opened_by else ""
    return f"{_code(db, now)} was opened on another screen{by} at {_clock(now.started)}."


def _before(db: Transaction, before: PatientSession | None) -> str:
    belongs = "to no session" if before is None else f"to {_code(db, before)}"
    return f"What this page shows belongs {belongs} and can no longer be sent: load the page again."


def _code(db: Transaction, session: PatientSession) -> str:
    return db.get_one(Patient, session.patient_id).code


def _clock(moment: datetime) -> str:
    return f"{moment.astimezone():%H:%M}"
