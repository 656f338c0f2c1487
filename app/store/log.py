"""Write the log: who did what, when. Rows are only appended, and each row's hash covers the row before."""

from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.store.log_chain import FIRST, entry_hash
from app.store.tables import LogEntry

HAS_NEW_ROWS = "logged"  # key in `Session.info`: rows were added, so the log's head must be written


def write_log(db: Session, person: str | None, what: str, /, **details: Any) -> None:
    """Append one row; `details` name patients by id or code, never by a name."""
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
