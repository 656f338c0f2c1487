"""All rows of a patient as one document without this clinic's ids, and the rows of such a document."""

from collections.abc import Callable, Mapping
from datetime import UTC, date, datetime
from functools import cache
from typing import Any, Final

from sqlalchemy import JSON, Boolean, Column, Date, Float, Integer, String, insert, select
from sqlalchemy import Table as SqlTable
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from app.features.archive.row_forms import wrong_value, wrong_versions
from app.features.registration import ArchivedTable, features
from app.store.access.visible_patients import own_clinic_id
from app.store.chairs import chair_elsewhere
from app.store.keeping.last_ids import next_id
from app.store.tables import (
    CalibrationStep,
    Drive,
    InterfaceTest,
    Moment,
    ParameterSet,
    Patient,
    PatientSession,
    Profile,
    Run,
    Table,
    TextColumn,
    Trial,
)
from app.texts import ENGLISH, Text, Value, reader_language

KERNEL: Final = (
    ArchivedTable(Patient, "id"),
    ArchivedTable(PatientSession, "patient_id"),
    ArchivedTable(Run, "session_id"),
    ArchivedTable(CalibrationStep, "session_id"),
    ArchivedTable(Profile, "patient_id"),
    ArchivedTable(ParameterSet, "profile_id"),
    ArchivedTable(Trial, "patient_id"),
    ArchivedTable(Drive, "patient_id"),
    ArchivedTable(InterfaceTest, "patient_id"),
)
"""Each table after those that it refers to."""

LEFT_OUT: Final = {
    "clinic_id": "the clinic that has the rows",
    "folder": "of a recording, which is named by the recording's id",
    "chair_id": "a chair stays in its clinic, with its address and key",
    "person_id": "the people of another clinic do not exist here: the author of a comment goes along by name",
}
"""Columns that do not go along, whichever table has them, each with the reason."""

NOT_IN_ARCHIVE: Final = {
    "patient_screen": "a screen that was paired with this machine for one session",
    "patient_file": "signals that were uploaded to be played; what was recorded of them is a run",
    "patient_import": "where this clinic has the patient from; another clinic notes from whom it has the patient",
    "imported_session": "which sessions came with an archive to this clinic",
    "incident_patient": "a mark of this clinic's owner, under which nothing is erased here",
    "incident": "concerns the machine of this clinic; its own archive is made by another command",
    "erased_patient": "patients that this clinic has erased; it has no word about a person",
    "last_id": "ids that this database gives to no second row",
    "log": "the chain of who did what in this clinic; rows taken out of it could not be verified",
    "clinic": "this clinic and its equipment",
    "person": "the people of this clinic",
    "auth_session": "sign-ins of people of this clinic",
    "known_browser": "browsers of people of this clinic",
    "invitation": "invitations of people of this clinic",
    "chair": "real chairs of this clinic",
    "record_keeping": "settings of this clinic's owner",
    "passed_time": "what the clocks of this clinic's machine said",
}
"""The other tables of the kernel, with the reason why the archive of a patient does not have them."""


@cache
def archived_tables() -> tuple[ArchivedTable, ...]:
    """Return the tables that an archive carries, those of features last."""
    return (*KERNEL, *(table for feature in features().values() for table in feature.archived))


def not_archived() -> Mapping[str, str]:
    """Return every other table by its name, with the reason."""
    return NOT_IN_ARCHIVE | {
        table: why for feature in features().values() for table, why in feature.not_archived.items()
    }


MOST_ROWS = 100_000  # of an archive: far more than a patient has; while they are added, nothing else is stored

Rows = dict[str, list[dict[str, Any]]]
"""Table name -> its rows. The ids are 1, 2, 3 ... in each table, so that every clinic writes the same document."""


class WrongRows(ValueError):  # noqa: N818
    """The rows of a document do not fit the tables; the message says where."""


def patient_rows(db: Session, patient_id: int) -> Rows:
    """Return all rows of a patient."""
    places: dict[str, dict[Any, int]] = {}
    rows_of_tables: Rows = {}
    for archived in archived_tables():
        table, by = table_of(archived.kind), archived.by
        (reference,) = [key.column.table.name for key in table.c[by].foreign_keys] or [table.name]
        ids = [patient_id] if by == "id" else list(places[reference])
        order = list(table.primary_key.columns)
        query = select(table).where(table.c[by].in_(ids)).order_by(*order)
        rows = [dict(row) for row in db.execute(query).mappings()]
        archived.complete(db, rows)
        if "id" in table.c:
            places[table.name] = {row["id"]: place for place, row in enumerate(rows, start=1)}
        rows_of_tables[table.name] = [
            {column.name: _written(column, row[column.name], places) for column in exchanged(table)} for row in rows
        ]
    return rows_of_tables


def add_patient_rows(db: Session, rows: Rows) -> int:
    """Add the rows of a document to a clinic and return the id of the patient; WrongRows when they do not fit.

    A run's folder is named by its id, as that of every other run. A drive refers to a chair of another clinic.
    """
    ids: dict[str, dict[Any, Any]] = {}
    for archived in archived_tables():
        table = table_of(archived.kind)
        ids[table.name] = {}
        for place, row in enumerate(rows[table.name], start=1):
            values = {column.name: read_value(column, row, ids, place) for column in exchanged(table)}
            ids[table.name][values.get("id", place)] = insert_row(db, table, values, place)
    return int(ids["patient"][1])


def insert_row(db: Session, table: SqlTable, values: dict[str, Any], place: int) -> Any:
    """Add the row at this place of a document and return its id; WrongRows when it contradicts another one."""
    columns = {name: value for name, value in values.items() if name != "id" or not isinstance(value, int)}
    if "id" in table.c and "id" not in columns and (following := next_id(db.connection(), table.name)) is not None:
        columns["id"] = following
    if "clinic_id" in table.c:
        columns["clinic_id"] = own_clinic_id(db)
    if "folder" in table.c:
        columns["folder"] = columns["id"]
    if "chair_id" in table.c:
        columns["chair_id"] = chair_elsewhere(db).id
    try:
        added: Any = db.execute(insert(table).values(columns))
    except IntegrityError as error:
        raise WrongRows(Text("archive-row-contradicts", row=place, table=table.name)) from error
    return added.inserted_primary_key[0]


def check_rows(rows: Any) -> Rows:
    """Return the rows of a foreign document when it has the tables and columns of this program; WrongRows otherwise."""
    if not isinstance(rows, dict) or set(rows) != {
        kind_of_table.kind.__tablename__ for kind_of_table in archived_tables()
    }:
        raise WrongRows(Text("archive-other-tables"))
    for archived in archived_tables():
        table = table_of(archived.kind)
        names = {column.name for column in exchanged(table)}
        if not isinstance(rows[table.name], list) or any(
            not isinstance(row, dict) or set(row) != names for row in rows[table.name]
        ):
            raise WrongRows(Text("archive-other-columns", table=table.name))
    if sum(map(len, rows.values())) > MOST_ROWS:
        raise WrongRows(Text("archive-rows-most", most=MOST_ROWS))
    if len(rows["patient"]) != 1:
        raise WrongRows(Text("archive-one-patient"))
    wrong = (_wrong_value(kind_of_table, rows) for kind_of_table in archived_tables())
    refusal = next(filter(None, wrong), None) or wrong_versions(rows)
    if refusal is not None:
        raise WrongRows(refusal)
    if any(row["ended"] is None for row in rows["session"]):
        raise WrongRows(Text("archive-session-not-ended"))
    return rows


def _wrong_value(archived: ArchivedTable, rows: Rows) -> Text | None:
    table = table_of(archived.kind)
    return wrong_value(table, exchanged(table), rows[table.name], archived.forms)


def table_of(kind: type[Table]) -> SqlTable:
    """Return the table of a class."""
    table = kind.__table__
    assert isinstance(table, SqlTable)
    return table


def exchanged(table: SqlTable) -> list[Column[Any]]:
    """Return the columns that a document has."""
    return [column for column in table.columns if column.name not in LEFT_OUT]


def referred_table(column: Column[Any]) -> str | None:
    """Return the table whose rows a column names, None for a column that names none."""
    return next((key.column.table.name for key in column.foreign_keys), None)


def _written(column: Column[Any], value: Any, places: dict[str, dict[Any, int]]) -> Any:
    table = referred_table(column) or (column.table.name if column.name == "id" else None)
    if value is not None and table is not None and isinstance(value, int):
        return places[table][value]
    if isinstance(value, datetime):
        return value.astimezone(UTC).isoformat()
    if isinstance(value, Text):  # in one language, so that every clinic writes the same document
        with reader_language(ENGLISH):
            return str(value)
    return value.isoformat() if isinstance(value, date) else value


def read_value(column: Column[Any], row: dict[str, Any], ids: dict[str, dict[Any, Any]], place: int) -> Any:
    """Return a value of a document as the database stores it; `ids` are those that the document's rows have here."""
    value = row[column.name]
    where: dict[str, Value] = {"row": place, "table": column.table.name, "column": column.name}
    if value is None:
        if not column.nullable:
            raise WrongRows(Text("archive-value-empty", **where))
        return None
    if not _has_type(column, value):
        raise WrongRows(Text("archive-value-type", **where))
    length = getattr(column.type, "length", None)
    if isinstance(length, int) and len(value) > length:
        raise WrongRows(Text("archive-value-long", **where))
    if column.name == "id" and isinstance(value, int) and value != place:
        raise WrongRows(Text("archive-value-place", **where))
    table = referred_table(column)
    if table is not None:
        if value not in ids[table]:
            raise WrongRows(Text("archive-value-refers", **where))
        return ids[table][value]
    try:
        read = _READ.get(type(column.type))
        return value if read is None else read(value)
    except (ValueError, OverflowError) as error:
        raise WrongRows(Text("archive-value-date", **where)) from error


def _moment(text: str) -> datetime:
    moment = datetime.fromisoformat(text)
    if moment.tzinfo is None:
        raise ValueError
    return moment.astimezone(UTC)


_READ: dict[type, Callable[[str], Any]] = {Moment: _moment, Date: date.fromisoformat}


def _has_type(column: Column[Any], value: Any) -> bool:
    wrong_bool = isinstance(value, bool) and not isinstance(column.type, Boolean | JSON)
    return isinstance(value, _json_type(column)) and not wrong_bool


def _json_type(column: Column[Any]) -> type | tuple[type, ...]:
    kind = column.type
    if isinstance(kind, JSON):
        return (dict, list)
    if isinstance(kind, Boolean):
        return bool
    if isinstance(kind, Float):
        return (int, float)
    if isinstance(kind, Integer):
        return int
    assert isinstance(kind, String | TextColumn | Moment | Date)
    return str
