"""Adds to a patient what a newer archive of the same patient has more: sessions, sets of controls, comments.

A session that is here stays as it is, whatever was written about it elsewhere since. Rows are known again by moments
and names, because ids and numbers differ between clinics; a number that is taken here becomes the next free one.
"""

from typing import Any, Final, NamedTuple

from sqlalchemy import Table as SqlTable
from sqlalchemy import select, update
from sqlalchemy.orm import Session

from app.store.records.archive_kinds import KINDS
from app.store.records.import_tables import ImportedSession
from app.store.records.patient_rows import Rows, exchanged, insert_row, read_value, referred_table, table_of
from app.store.tables import ParameterSet, PatientSession

# By which columns a row that is here is known again. Rows of other tables come with a new session only.
KNOWN_BY: Final = {
    "session": ("started",),
    "run": ("id",),
    "profile": ("session_id", "created"),
    "parameters": ("profile_id", "created", "hash"),
    "trial": ("run_id", "started"),
    "moment_comment": ("trial_id", "author", "t"),
    "comment_revision": ("comment_id", "written"),
}
# The column that numbers the rows of a patient, and the columns by which they are counted apart.
NUMBERED: Final[dict[str, tuple[str, tuple[str, ...]]]] = {
    "session": ("number", ()),
    "profile": ("version", ()),
    "trial": ("number", ("floorplan", "path")),
    "interface_test": ("number", ()),
}
STAY: Final = frozenset({"patient", "patient_consent"})  # the patient's own row, and what was consented to here
UNDONE: Final = ("current", "abandoned")  # columns of a set of controls that undo and redo change


class Added(NamedTuple):
    """What was added to a patient."""

    sessions: frozenset[int] = frozenset()  # ids
    runs: frozenset[str] = frozenset()
    trials: int = 0  # finished and kept
    comments: int = 0


def add_missing_rows(db: Session, clinic_id: int, patient_id: int, rows: Rows) -> Added:
    """Add the rows of a checked document that a patient does not have; WrongRows when they do not fit.

    While the clinic has held no session of its own with the patient, the set of controls that is current in the
    document becomes the current one.
    """
    merge = _Merge(db, clinic_id, patient_id)
    for kind, by in KINDS:
        if kind.__tablename__ not in STAY:
            merge.add_table(table_of(kind), by, rows[kind.__tablename__])
    trials = sum(row["status"] == "done" and row["kept"] is True for row in merge.trials)
    new = merge.new
    return Added(frozenset(new["session"]), frozenset(new["run"]), trials, len(new["moment_comment"]))


class _Merge:
    """A merge under way: which id each row of the document has here."""

    def __init__(self, db: Session, clinic_id: int, patient_id: int) -> None:
        self.new: dict[str, set[Any]] = {}  # ids of added rows, by table
        self.trials: list[dict[str, Any]] = []  # rows of the document that were added
        self._db, self._clinic_id = db, clinic_id
        self._ids: dict[str, dict[Any, Any]] = {"patient": {1: patient_id}}
        self._skipped: dict[str, set[Any]] = {"patient": set()}  # ids in the document of rows that are not added
        self._versions: dict[int, int] = {}  # of maps: in the document -> here
        self._agrees = not _has_own_sessions(db, patient_id)

    def add_table(self, table: SqlTable, by: str, rows: list[dict[str, Any]]) -> None:
        """Add the missing rows of a table; `by` is the column that leads to the patient."""
        name = table.name
        here = self._rows_here(table, by)
        ids, new = self._ids.setdefault(name, {}), self.new.setdefault(name, set())
        skipped = self._skipped.setdefault(name, set())
        for place, row in enumerate(rows, start=1):
            own = row.get("id", place)
            if self._refers_to_skipped(table, row):
                skipped.add(own)
                continue
            values = {column.name: read_value(column, row, self._ids, place) for column in exchanged(table)}
            known = here.take(values)
            if known is not None:
                ids[own] = known["id"]
                self._agree(table, values, known)
            elif "session_id" in values and values["session_id"] not in self.new["session"]:
                skipped.add(own)
            else:
                self._adapt(table, values, here)
                ids[own] = insert_row(self._db, self._clinic_id, table, values, place)
                new.add(ids[own])
                if name == "trial":
                    self.trials.append(row)
            if name == "profile" and own in ids:
                self._versions[row["version"]] = values["version"] if known is None else known["version"]

    def _rows_here(self, table: SqlTable, by: str) -> "_RowsHere":
        """Return the patient's rows of a table, before any is added."""
        parent = referred_table(table.c[by]) or ""
        known = [one for one in self._ids[parent].values() if one not in self.new.get(parent, ())]
        query = select(table).where(table.c[by].in_(known)).order_by(*table.primary_key.columns)
        return _RowsHere(table.name, [dict(row) for row in self._db.execute(query).mappings()])

    def _refers_to_skipped(self, table: SqlTable, row: dict[str, Any]) -> bool:
        named = ((referred_table(column), row[column.name]) for column in exchanged(table))
        return any(parent is not None and value in self._skipped[parent] for parent, value in named)

    def _agree(self, table: SqlTable, values: dict[str, Any], known: dict[str, Any]) -> None:
        """Let a set of controls be current or undone as it is elsewhere, when nobody has worked with it here."""
        if table.name != "parameters" or not self._agrees:
            return
        changed = {name: values[name] for name in UNDONE if known[name] != values[name]}
        if changed:
            self._db.execute(update(ParameterSet).where(ParameterSet.id == known["id"]).values(changed))

    def _adapt(self, table: SqlTable, values: dict[str, Any], here: "_RowsHere") -> None:
        """Give values that are added the numbers that they have here."""
        here.number(values)
        if table.name == "profile" and values["parent"] is not None:
            values["parent"] = self._versions.get(values["parent"])
        if table.name == "parameters" and not self._agrees and values["profile_id"] not in self.new["profile"]:
            values["current"] = False  # the map has its current set here


class _RowsHere:
    """Rows of one table that a patient has: each is known again once, and each number is given once."""

    def __init__(self, table: str, rows: list[dict[str, Any]]) -> None:
        self._known_by = KNOWN_BY.get(table, ())
        self._left: dict[tuple[Any, ...], list[dict[str, Any]]] = {}
        for row in rows:
            self._left.setdefault(tuple(row[name] for name in self._known_by), []).append(row)
        self._number, self._apart = NUMBERED.get(table, ("", ()))
        self._taken: dict[tuple[Any, ...], set[int]] = {}
        for row in rows if self._number else ():
            self._numbers(row).add(row[self._number])

    def take(self, values: dict[str, Any]) -> dict[str, Any] | None:
        """Return the row that has these values, None when it is not here."""
        left = self._left.get(tuple(values[name] for name in self._known_by)) if self._known_by else None
        return left.pop(0) if left else None

    def number(self, values: dict[str, Any]) -> None:
        """Give values another number when theirs is taken."""
        if not self._number:
            return
        taken = self._numbers(values)
        if values[self._number] in taken:
            values[self._number] = max(taken) + 1
        taken.add(values[self._number])

    def _numbers(self, values: dict[str, Any]) -> set[int]:
        return self._taken.setdefault(tuple(values[name] for name in self._apart), set())


def _has_own_sessions(db: Session, patient_id: int) -> bool:
    """Return whether the clinic has held a session with the patient itself."""
    imported = select(ImportedSession.session_id)
    own = select(PatientSession.id).where(PatientSession.patient_id == patient_id, PatientSession.id.not_in(imported))
    return db.scalar(own.limit(1)) is not None
