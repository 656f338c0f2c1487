"""The rows that an incident's archive holds: the log, sessions, trials, drives and parameters of the last hours."""

import json
from datetime import datetime
from typing import Any

from sqlalchemy import Select, inspect, select
from sqlalchemy.orm import Session

from app.store.access.visible_patients import WITH_DELETED
from app.store.log_chain import FIRST
from app.store.tables import Chair, Clinic, Drive, LogEntry, Parameters, PatientSession, Profile, Run, Table, Trial

Rows = dict[str, list[dict[str, Any]]]


def log_lines(db: Session, since: datetime) -> str:
    """Return the rows of the log since a moment, one JSON object a line, with the hashes of their chain."""
    entries = db.scalars(select(LogEntry).where(LogEntry.at >= since).order_by(LogEntry.id))
    return "".join(f"{json.dumps(_document(entry))}\n" for entry in entries)


def newest_log_hash(db: Session) -> str:
    """Return the hash of the log's newest row, which covers all rows before it."""
    return db.scalar(select(LogEntry.hash).order_by(LogEntry.id.desc()).limit(1)) or FIRST


def incident_rows(db: Session, sessions: list[int]) -> Rows:
    """Return everything that describes these sessions: equipment, maps, parameters, runs, trials, drives."""
    own = {
        PatientSession: PatientSession.id.in_(sessions),
        Run: Run.session_id.in_(sessions),
        Trial: Trial.session_id.in_(sessions),
        Drive: Drive.session_id.in_(sessions),
    }
    found: Rows = {kind.__tablename__: _all(db, select(kind).where(condition)) for kind, condition in own.items()}
    patients = {row["patient_id"] for row in found["session"]}
    profiles = _all(db, select(Profile).where(Profile.patient_id.in_(patients)))
    used = {row["parameters_id"] for row in (*found["trial"], *found["drive"])}
    of_profiles = Parameters.profile_id.in_([row["id"] for row in profiles])
    wanted = of_profiles & (Parameters.current | Parameters.id.in_(used))
    return found | {
        "profile": profiles,
        "parameters": _all(db, select(Parameters).where(wanted)),
        "chair": _all(db, select(Chair)),
        "clinic": _all(db, select(Clinic)),
    }


def sessions_since(db: Session, since: datetime) -> list[int]:
    """Return the sessions that were open since a moment."""
    open_then = (PatientSession.ended >= since) | PatientSession.ended.is_(None) | (PatientSession.started >= since)
    return list(db.scalars(select(PatientSession.id).where(open_then), execution_options=WITH_DELETED))


def _all(db: Session, query: Select[Any]) -> list[dict[str, Any]]:
    return [_document(row) for row in db.scalars(query, execution_options=WITH_DELETED)]


def _document(row: Table) -> dict[str, Any]:
    """Return the columns of a row for JSON."""
    values = {column.key: getattr(row, column.key) for column in inspect(type(row)).column_attrs}
    return {name: value.isoformat() if isinstance(value, datetime) else value for name, value in values.items()}
