"""Restrict every query of a transaction to the clinic of the signed-in person, and to the patients they may see.

Nobody's patients exist for a request until the web application has found its person (`app/api/who_asks.py`); each
transaction of the request is restricted here. So a route needs no rule of its own, and a new one cannot forget it: for
a reviewer of chosen patients, other patients do not exist. The program's own work sees every patient.
"""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache
from typing import Final

from sqlalchemy import ColumnElement, and_, event, inspect, select
from sqlalchemy.orm import InstrumentedAttribute, Mapper, ORMExecuteState, Session, with_loader_criteria
from sqlalchemy.orm.util import LoaderCriteriaOption

from app.store.tables import Clinic, Patient, Table

VisiblePatients = frozenset[int] | None
"""Ids of the patients that exist for somebody; None: all of them."""

NOBODY: Final[frozenset[int]] = frozenset()

_WITH_DELETED, _OF_ANY_CLINIC, _DELETED = "with_deleted_patients", "of_any_clinic", "deleted_patients"
WITH_DELETED: Final[Mapping[str, bool]] = {_WITH_DELETED: True}
"""Execution options of a query that finds deleted patients, too."""
OF_ANY_CLINIC: Final[Mapping[str, bool]] = {_OF_ANY_CLINIC: True}
"""Execution options of a query that finds rows of other clinics, too."""

VISIBLE_PATIENTS: ContextVar[VisiblePatients] = ContextVar("VISIBLE_PATIENTS", default=None)
OWN_CLINIC: ContextVar[int | None] = ContextVar("OWN_CLINIC", default=None)
"""The id of the clinic of who asks; None for the program's own work."""


@contextmanager
def of_clinic(clinic_id: int) -> Iterator[None]:
    """Let transactions that begin in here be those of somebody of this clinic, also in another thread or process."""
    before = OWN_CLINIC.set(clinic_id)
    try:
        yield
    finally:
        OWN_CLINIC.reset(before)


def own_clinic_id(db: Session) -> int:
    """Return the id of the clinic to which new rows belong: that of who asks, or the database's first one."""
    clinic_id = OWN_CLINIC.get()
    return db.scalars(select(Clinic.id).order_by(Clinic.id).limit(1)).one() if clinic_id is None else clinic_id


@contextmanager
def every_patient() -> Iterator[None]:
    """Let transactions that begin in here see every patient of the clinic.

    For a row that a secret names (a patient's screen, a share link), and for figures of the whole clinic in which
    nobody can be recognised: such a figure must be the same for everybody, because a verdict is derived from it.
    Nothing else that was read in here may be answered.
    """
    before = VISIBLE_PATIENTS.set(None)
    try:
        yield
    finally:
        VISIBLE_PATIENTS.reset(before)


def restrict(db: Session) -> None:
    """Leave out of every later query of `db` other clinics, and what is of a patient not visible in this context.

    Deleted patients are left out for everybody: only a query with the execution options `WITH_DELETED` finds them.
    """
    visible, clinic_id = VISIBLE_PATIENTS.get(), OWN_CLINIC.get()
    if clinic_id is not None and _has_one_clinic(db):
        clinic_id = None  # the usual case, without a condition in each query
    read_deleted(db)

    @event.listens_for(db, "do_orm_execute")
    def _leave_out(state: ORMExecuteState) -> None:
        deleted = NOBODY if state.execution_options.get(_WITH_DELETED) else db.info[_DELETED]
        clinic = None if state.execution_options.get(_OF_ANY_CLINIC) else clinic_id
        if state.is_select and (deleted or visible is not None or clinic is not None):
            state.statement = state.statement.options(*_loader_criteria(visible, deleted, clinic))


def _has_one_clinic(db: Session) -> bool:
    return len(db.connection().exec_driver_sql("SELECT id FROM clinic LIMIT 2").all()) < 2


def read_deleted(db: Session) -> None:
    """Read which patients are deleted; again after a deletion was undone within this transaction."""
    rows = db.connection().exec_driver_sql("SELECT id FROM patient WHERE deleted IS NOT NULL")
    db.info[_DELETED] = frozenset(row[0] for row in rows)


@lru_cache(maxsize=32)
def _loader_criteria(
    visible: VisiblePatients, deleted: frozenset[int], clinic: int | None
) -> tuple[LoaderCriteriaOption, ...]:
    def permits(patient: InstrumentedAttribute[int]) -> ColumnElement[bool]:
        conditions = [patient.not_in(deleted)] if deleted else []
        return and_(*conditions, *([] if visible is None else [patient.in_(visible)]))

    conditions: list[tuple[type[Table], ColumnElement[bool] | None]] = []
    if deleted or visible is not None:
        conditions += [(kind, _belongs_to(kind, permits)) for kind in _mapped_classes()]
    if clinic is not None:
        conditions += [(kind, kind.clinic_id == clinic) for kind in _mapped_classes() if hasattr(kind, "clinic_id")]
    return tuple(
        with_loader_criteria(kind, condition, include_aliases=True)
        for kind, condition in conditions
        if condition is not None
    )


def _mapped_classes() -> list[type[Table]]:
    return [mapper.class_ for mapper in Table.registry.mappers]


def _belongs_to(
    kind: type[Table], permits: Callable[[InstrumentedAttribute[int]], ColumnElement[bool]]
) -> ColumnElement[bool] | None:
    """Return the condition that a row belongs to a patient that `permits`, None for a table that names no patient.

    A row belongs to the patient whom its required foreign keys name, directly or by another row.
    """
    if kind is Patient:
        return permits(Patient.id)
    mapper: Mapper[Table] = inspect(kind)
    by_table = {other.__table__: other for other in _mapped_classes()}
    by_owner: ColumnElement[bool] | None = None
    for column in mapper.local_table.columns:
        for key in column.foreign_keys:
            if column.nullable:
                continue
            owner = by_table[key.column.table]
            attribute = getattr(kind, mapper.get_property_by_column(column).key)  # adapted where the table has an alias
            if owner is Patient:
                return permits(attribute)
            condition = _belongs_to(owner, permits)
            if condition is not None and by_owner is None:
                by_owner = attribute.in_(select(key.column).where(condition))
    return by_owner
