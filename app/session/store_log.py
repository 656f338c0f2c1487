"""The log: who did what, when; append-only, each row's hash covering the row before."""

import hashlib
import json
from datetime import datetime
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.session.tables import LogEntry

FIRST = "0" * 64


def _hash(previous: str, at: datetime, person: str | None, what: str, details: dict[str, Any]) -> str:
    content = json.dumps([previous, at.isoformat(), person, what, details], sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(content.encode()).hexdigest()


def write_log(db: Session, person: str | None, what: str, **details: Any) -> None:
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
            hash=_hash(previous, at, person, what, details),
        )
    )
    db.flush()


def first_broken_row(db: Session) -> int | None:
    """Return the id of the first row that was edited, or that follows a removed one; None when all is whole."""
    previous = FIRST
    for row in db.scalars(select(LogEntry).order_by(LogEntry.id)):
        if row.previous_hash != previous or row.hash != _hash(previous, row.at, row.person, row.what, row.details):
            return row.id
        previous = row.hash
    return None
