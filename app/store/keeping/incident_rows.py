"""The rows that an incident's archive holds: the log, sessions, what was done in them and with which parameters.

What people wrote about a patient, and who may look at it, is not among them: it stays in the clinic, where the mark of
the incident keeps it from being erased.
"""

import json
from collections.abc import Iterator
from datetime import date, datetime
from typing import Any

from sqlalchemy import Select, inspect, select
from sqlalchemy.orm import Session, undefer

from app.features.registration import features
from app.store.access.visible_patients import WITH_DELETED
from app.store.database import Database
from app.store.log_chain import FIRST
from app.store.origins import ImportedSession, PatientImport
from app.store.tables import (
    CalibrationStep,
    Clinic,
    Drive,
    InterfaceTest,
    LogEntry,
    PairedChair,
    ParameterSet,
    PatientScreen,
    PatientSession,
    Profile,
    Run,
    Table,
    Trial,
)

AT_ONCE = 500  # rows of the log in memory, and read under one lock of the database
SECRET = {"token_hash"}  # columns
WRITTEN = {"goal", "discard_reason"}  # columns with words about a patient

Rows = dict[str, list[dict[str, Any]]]


def log_lines(database: Database, since: datetime, newest: int) -> Iterator[str]:
    """Yield the rows of the log since a moment up to the row `newest`, as JSON lines with the hashes of their chain."""
    last = 0
    while True:
        query = select(LogEntry).where(LogEntry.id > last, LogEntry.id <= newest, LogEntry.at >= since)
        with database.transaction() as db:
            found = [(row.id, _document(row)) for row in db.scalars(query.order_by(LogEntry.id).limit(AT_ONCE))]
        if not found:
            return
        yield from (f"{json.dumps(document)}\n" for _, document in found)
        last = found[-1][0]


def newest_log_row(db: Session) -> tuple[int, str]:
    """Return the id and the hash of the log's newest row; the hash covers all rows before it."""
    row = db.execute(select(LogEntry.id, LogEntry.hash).order_by(LogEntry.id.desc()).limit(1)).first()
    return (0, FIRST) if row is None else (row[0], row[1])


def incident_rows(db: Session, sessions: list[int]) -> Rows:
    """Return everything that describes these sessions: equipment, maps, parameters, runs, trials, drives."""
    own: dict[type[Table], Any] = {
        PatientSession: PatientSession.id.in_(sessions),
        Run: Run.session_id.in_(sessions),
        CalibrationStep: CalibrationStep.session_id.in_(sessions),
        Trial: Trial.session_id.in_(sessions),
        Drive: Drive.session_id.in_(sessions),
        InterfaceTest: InterfaceTest.session_id.in_(sessions),
        PatientScreen: PatientScreen.session_id.in_(sessions),
        ImportedSession: ImportedSession.session_id.in_(sessions),
    }
    found: Rows = {kind.__tablename__: _all(db, select(kind).where(condition)) for kind, condition in own.items()}
    patients = {row["patient_id"] for row in found["session"]}
    of_patients: list[type[Any]] = [PatientImport]
    of_patients += (table for feature in features().values() for table in feature.of_incidents)
    for kind in of_patients:
        found[kind.__tablename__] = _all(db, select(kind).where(kind.patient_id.in_(patients)))
    profiles = _all(db, select(Profile).where(Profile.patient_id.in_(patients)))
    used = {row["parameters_id"] for row in (*found["trial"], *found["drive"], *found["interface_test"])}
    of_profiles = ParameterSet.profile_id.in_([row["id"] for row in profiles])
    wanted = of_profiles & (ParameterSet.current | ParameterSet.id.in_(used))
    return found | {
        "profile": profiles,
        "parameters": _all(db, select(ParameterSet).where(wanted)),
        "chair": _all(db, select(PairedChair)),
        "clinic": _all(db, select(Clinic)),
    }


def sessions_since(db: Session, since: datetime) -> list[int]:
    """Return the sessions that were open since a moment."""
    open_then = (PatientSession.ended >= since) | PatientSession.ended.is_(None) | (PatientSession.started >= since)
    return list(db.scalars(select(PatientSession.id).where(open_then), execution_options=WITH_DELETED))


def _all(db: Session, query: Select[Any]) -> list[dict[str, Any]]:
    return [_document(row) for row in db.scalars(query.options(undefer("*")), execution_options=WITH_DELETED)]


def _document(row: Table) -> dict[str, Any]:
    """Return the columns of a row for JSON, without secrets, and without what people wrote."""
    values = {column.key: getattr(row, column.key) for column in inspect(type(row)).column_attrs}
    return {
        name: value.isoformat() if isinstance(value, date) else value
        for name, value in values.items()
        if name not in SECRET | WRITTEN
    }
