"""Find a row by its id, and say when it is one of another clinic."""

from typing import Protocol, TypeVar

from sqlalchemy.orm import Session

from app.refusals import NotFound, OtherClinicRow
from app.store.access.visible_patients import OF_ANY_CLINIC, WITH_DELETED
from app.texts import Text


class ClinicRow(Protocol):
    """A row that names its clinic."""

    __tablename__: str

    @property
    def clinic_id(self) -> int:
        """Return the clinic."""


Row = TypeVar("Row", bound=ClinicRow)


def own_row(db: Session, kind: type[Row], row_id: int, missing: Text, *, deleted: bool = False) -> Row:
    """Return a row of the own clinic; what belongs to a deleted patient only with `deleted`.

    Raises
    ------
    NotFound
        With the sentence `missing`, when there is none of this id.
    OtherClinicRow
        With the same sentence, when it belongs to another clinic; the handler of this error logs it.
    """
    options = WITH_DELETED if deleted else {}
    row = db.get(kind, row_id, execution_options=options)
    if row is not None:
        return row
    if db.get(kind, row_id, execution_options={**options, **OF_ANY_CLINIC}) is not None:
        raise OtherClinicRow(missing, kind.__tablename__, row_id)
    raise NotFound(missing)
