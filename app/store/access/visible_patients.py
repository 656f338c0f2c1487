"""The patients that exist for who asks: every query of the database leaves out the others, and all that is theirs.

The web application names the person who asks once for each request (`app/api/who_asks.py`), and each transaction of
the request is restricted here. So a route needs no rule of its own, and a new one cannot forget it: for a reviewer of
chosen patients, other patients do not exist.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

from sqlalchemy import ColumnElement, event, inspect, select
from sqlalchemy.orm import Mapper, ORMExecuteState, Session, with_loader_criteria

from app.store.tables import Patient, Table

VisiblePatients = frozenset[int] | None
"""Ids of the patients that exist for somebody; None: all of them."""

VISIBLE_PATIENTS: ContextVar[VisiblePatients] = ContextVar("VISIBLE_PATIENTS", default=None)


@contextmanager
def every_patient() -> Iterator[None]:
    """Let transactions that begin in here see every patient of the clinic.

    For figures of the whole clinic only, in which nobody can be recognised: such a figure must be the same for
    everybody, because a verdict is derived from it. Nothing else that was read in here may be answered.
    """
    before = VISIBLE_PATIENTS.set(None)
    try:
        yield
    finally:
        VISIBLE_PATIENTS.reset(before)


def restrict(db: Session) -> None:
    """Leave out of every later query of `db` what belongs to a patient who is not visible in this context."""
    visible = VISIBLE_PATIENTS.get()
    if visible is None:
        return
    options = [
        with_loader_criteria(kind, condition, include_aliases=True)
        for kind in _mapped_classes()
        if (condition := _belongs_to(kind, visible)) is not None
    ]

    @event.listens_for(db, "do_orm_execute")
    def _leave_out(state: ORMExecuteState) -> None:
        if state.is_select:
            state.statement = state.statement.options(*options)


def _mapped_classes() -> list[type[Table]]:
    return [mapper.class_ for mapper in Table.registry.mappers]


def _belongs_to(kind: type[Table], visible: frozenset[int]) -> ColumnElement[bool] | None:
    """Return the condition that a row belongs to one of these patients, None for a table that names no patient.

    A row belongs to the patient whom its required foreign keys name, directly or by another row.
    """
    if kind is Patient:
        return Patient.id.in_(visible)
    mapper: Mapper[Table] = inspect(kind)
    by_table = {other.__table__: other for other in _mapped_classes()}
    found: ColumnElement[bool] | None = None
    for column in mapper.local_table.columns:
        for key in column.foreign_keys:
            if column.nullable:
                continue
            owner = by_table[key.column.table]
            attribute = getattr(kind, mapper.get_property_by_column(column).key)  # adapted where the table has an alias
            if owner is Patient:
                return attribute.in_(visible)  # type: ignore[no-any-return]
            condition = _belongs_to(owner, visible)
            if condition is not None and found is None:
                found = attribute.in_(select(key.column).where(condition))
    return found
