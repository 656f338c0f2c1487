"""Write the log: who did what, when. Rows are only appended, and each row's hash covers the row before."""

from datetime import timedelta

from sqlalchemy import ColumnElement, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.store.log_chain import FIRST, entry_hash
from app.store.tables import LogEntry

VIEWED = "patient viewed"
LISTED = "patients listed"
SESSION_VIEWED = "session viewed"
VIEWED_EVERY = timedelta(minutes=15)  # a page asks for a patient's records many times while somebody reads them
HAS_NEW_ROWS = "logged"  # key in `Session.info`: rows were added, so the log's head must be written


def write_log(db: Session, person: str | None, what: str, /, **details: object) -> None:
    """Append one row; `details` name patients by id or code, never by a name.

    No row is ever changed, also not when a patient is erased. So what people wrote or measured of a patient is not in
    `details`: they name its rows by their ids.
    """
    previous = db.scalar(select(LogEntry.hash).order_by(LogEntry.id.desc()).limit(1)) or FIRST
    at = utc_now()
    db.add(
        LogEntry(
            at=at,
            person=person,
            what=what,
            details=details,
            previous_hash=previous,
            hash=entry_hash(previous, at, person, what, details),
        )
    )
    db.flush()
    db.info[HAS_NEW_ROWS] = True


def log_once(db: Session, what: str, **details: object) -> None:
    """Append one row that the program itself has found, unless the newest of its kind has these details."""
    last = db.scalar(select(LogEntry.details).where(LogEntry.what == what).order_by(LogEntry.id.desc()).limit(1))
    if last != details:
        write_log(db, None, what, **details)


def log_viewing(db: Session, person: str, patient: int) -> None:
    """Log that a person looks at the records of a patient, once in a quarter of an hour."""
    if not _is_logged(db, person, VIEWED, LogEntry.details["patient"].as_integer() == patient):
        write_log(db, person, VIEWED, patient=patient)


def log_session_viewing(db: Session, person: str, patient: int, session: int) -> None:
    """Log that a person looks at the record of a session, once in a quarter of an hour: a page reads it after news."""
    if not _is_logged(db, person, SESSION_VIEWED, LogEntry.details["session"].as_integer() == session):
        write_log(db, person, SESSION_VIEWED, patient=patient, session=session)


def log_listing(db: Session, person: str) -> None:
    """Log that a person looks at the list of all patients, once in a quarter of an hour."""
    if not _is_logged(db, person, LISTED):
        write_log(db, person, LISTED)


def _is_logged(db: Session, person: str, what: str, *conditions: ColumnElement[bool]) -> bool:
    """Return whether a person has such a row within the last quarter of an hour."""
    now = utc_now()
    since = now - VIEWED_EVERY
    # Backwards from the newest row to the first that is too old: the log is long and only its end is read.
    older = select(LogEntry.id).where(LogEntry.at <= since).order_by(LogEntry.id.desc()).limit(1)
    logged = select(LogEntry.id).where(
        LogEntry.id > (db.scalar(older) or 0),
        LogEntry.at <= now,  # a row from before the clock was set back does not stand for now
        LogEntry.what == what,
        LogEntry.person == person,
        *conditions,
    )
    return db.scalar(logged.limit(1)) is not None
