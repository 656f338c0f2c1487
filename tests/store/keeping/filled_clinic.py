"""A clinic with one row for a patient in every table that can belong to a patient, generated from the tables."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing
from datetime import timedelta
from importlib import import_module
from pathlib import Path
from typing import Any, cast

import sqlalchemy as sa
from clinic_rows import rows_in
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.settings import Settings
from app.store.keeping.owned_rows import foreign_keys, rows_of_patient, tables_in
from app.store.log import write_log
from app.store.tables import Patient, Table
from folders import ROOT

# A table is known once its module is imported, whatever other tests have imported.
for file in sorted((ROOT / "app" / "store").rglob("*_tables.py")):
    import_module(".".join(file.relative_to(ROOT).with_suffix("").parts))

NOT_FILLED = {"log", "erased_patient", "last_id", "record_keeping", "backup_settings", "passed_time"}


def fill(db: Session, patient: Patient, word: str) -> None:
    """Add one row to every table that refers to a patient, with `word` in each text of it."""
    row = db.execute(sa.select(Patient.__table__).where(Patient.id == patient.id)).mappings().one()
    made: dict[str, dict[str, Any]] = {"patient": dict(row), "clinic": {"id": patient.clinic_id}}
    owned = _owned_tables()
    for table in Table.metadata.sorted_tables:
        if table.name not in {*made, *NOT_FILLED}:
            existing = db.execute(sa.select(table).limit(1)).mappings().first()
            if table.name not in owned and existing is not None:
                made[table.name] = dict(existing)
                continue
            text = word if table.name in owned else "Anybody"
            values = {column.name: _value(column, made, text) for column in table.columns if _is_needed(column)}
            key = cast(sa.CursorResult[Any], db.execute(sa.insert(table).values(values))).inserted_primary_key
            assert key is not None
            made[table.name] = values | dict(zip(table.primary_key.columns.keys(), key, strict=True))


def _owned_tables() -> set[str]:
    """Return the tables whose required foreign keys lead to a patient."""
    found = {"patient"}
    while more := {
        table.name
        for table in Table.metadata.sorted_tables
        for column in table.columns
        for key in column.foreign_keys
        if key.column.table.name in found and not column.nullable and table.name not in found
    }:
        found |= more
    return found


def _is_needed(column: sa.Column[Any]) -> bool:
    return not (column.primary_key and isinstance(column.type, sa.Integer) and not column.foreign_keys)


def _value(column: sa.Column[Any], made: dict[str, dict[str, Any]], word: str) -> Any:
    for key in column.foreign_keys:
        return made.get(key.column.table.name, {}).get(key.column.name)
    kind = column.type
    if isinstance(kind, sa.types.TypeDecorator):
        return utc_now() - timedelta(days=1)
    if isinstance(kind, sa.Date):
        return utc_now().date()
    if isinstance(kind, sa.String):
        return f"{word}-{column.table.name}-{column.name}"
    if isinstance(kind, sa.JSON):
        return {"word": word} if column.name not in {"files", "patients"} else []
    return True if isinstance(kind, sa.Boolean) else 1


def two_patients(settings: Settings, *words: str) -> list[int]:
    """Make a clinic with an owner and a filled patient for each word, with recordings and uploads; return their ids."""
    with rows_in(settings) as clinic:
        clinic.person("Ada", "owner", "a hash")
        ids = []
        for word in words:
            patient = clinic.patient(f"{word}-code", f"{word} pseudonym", f"{word} note")
            fill(clinic.db, patient, word)
            write_log(clinic.db, "Ada", "patient added", patient=patient.id)
            ids.append(patient.id)
        clinic.person("Rita", "reviewer", patients=ids)
        names = [row.name for row in clinic.db.execute(sa.text("SELECT name FROM patient_file ORDER BY id"))]
        runs = [row.folder for row in clinic.db.execute(sa.text("SELECT folder FROM run ORDER BY rowid"))]
    for word, name, run in zip(words, names, runs, strict=True):
        for place in (
            settings.runs / run / "run.parquet",
            settings.runs / run / "end.json",
            settings.files / name,
            settings.replaced / "file" / f"20260101T000000.000000Z--{name}",
        ):
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(f"a recording of {word}".encode() * 50)
    return ids


def mentions(folder: Path, word: str) -> Iterator[Path]:
    """Yield the files below a folder with a word in their name or content."""
    for file in sorted(folder.rglob("*")):
        if word in file.name or (file.is_file() and word.encode() in file.read_bytes()):
            yield file


def rows_by_table(file: Path, patient: int) -> dict[str, list[Any]]:
    """Return the content of the rows that belong to a patient."""
    with closing(sqlite3.connect(file)) as connection:
        rows = rows_of_patient(connection, tables_in(file), patient)
        return {
            table: [connection.execute(f"SELECT * FROM {table} WHERE rowid = {one}").fetchone() for one in sorted(ids)]
            for table, ids in rows.items()
        }


def named_ids(file: Path) -> set[tuple[str, int]]:
    """Return (column, value) of every whole number that a row holds in a column that names a patient."""
    with closing(sqlite3.connect(file)) as connection:
        of_patients = {(key.table, key.column) for key in foreign_keys(tables_in(file)) if key.parent == "patient"}
        assert of_patients
        return {
            (table, row[0])
            for table, column in of_patients
            for row in connection.execute(f"SELECT {column} FROM {table}")
        }
