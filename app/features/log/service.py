"""Read the log: its newest rows, filtered by person and patient, and all of its rows for an export."""

import json
from collections.abc import Iterator
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.csv_cells import SPREADSHEET_BEGIN, csv_line
from app.store.database import Database
from app.store.tables import Drive, LogEntry, PatientScreen, PatientSession, Trial

AT_ONCE = 500  # rows of an export in memory
COLUMNS = ("id", "at", "person", "what", "details", "previous_hash", "hash")


def read_log(
    db: Session, limit: int, *, person: str | None = None, patient: int | None = None, before: int | None = None
) -> list[LogEntry]:
    """Return the newest rows, the newest first: of a person, of a patient, and older than the row `before`."""
    query = select(LogEntry).order_by(LogEntry.id.desc()).limit(limit)
    if person is not None:
        query = query.where(LogEntry.person == person)
    if before is not None:
        query = query.where(LogEntry.id < before)
    if patient is not None:
        query = query.where(_of_patient(patient))
    return list(db.scalars(query))


def _of_patient(patient: int) -> Any:
    """Return the condition that a row names a patient, or a session, trial, drive or screen of this patient."""
    sessions = select(PatientSession.id).where(PatientSession.patient_id == patient)
    owned = {
        "session": sessions,
        "trial": select(Trial.id).where(Trial.patient_id == patient),
        "drive": select(Drive.id).where(Drive.patient_id == patient),
        "screen": select(PatientScreen.id).where(PatientScreen.session_id.in_(sessions)),
    }
    named = LogEntry.details["patient"].as_integer() == patient
    for name, ids in owned.items():
        named |= LogEntry.details[name].as_integer().in_(ids)
    return named


def people_in_log(db: Session) -> list[str]:
    """Return the names of all who did something, by name; also of those who are no longer there."""
    people = db.scalars(
        select(LogEntry.person).where(LogEntry.person.is_not(None)).distinct().order_by(LogEntry.person)
    )
    return [name for name in people if name is not None]


def exported_lines(database: Database, as_csv: bool) -> Iterator[str]:
    """Yield the whole log as lines of CSV or JSON, with the hashes of its chain, the oldest row first.

    A JSON line holds what the row's hash covers, as `app/store/log_chain.py` computes it.
    """
    if as_csv:
        yield SPREADSHEET_BEGIN + csv_line(COLUMNS)
    last = 0
    while True:
        with database.reading() as db:
            query = select(LogEntry).where(LogEntry.id > last).order_by(LogEntry.id).limit(AT_ONCE)
            entries = list(db.scalars(query))
        if not entries:
            return
        for entry in entries:
            yield _csv(entry) if as_csv else f"{json.dumps(_document(entry))}\n"
        last = entries[-1].id


def _document(entry: LogEntry) -> dict[str, Any]:
    return {name: getattr(entry, name) for name in COLUMNS} | {"at": entry.at.isoformat()}


def _csv(entry: LogEntry) -> str:
    cells = _document(entry) | {"details": json.dumps(entry.details, sort_keys=True), "person": entry.person or ""}
    return csv_line([str(cells[name]) for name in COLUMNS])
