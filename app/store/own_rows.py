"""Find a row by its id, in the person's own clinic only."""

from typing import Protocol, TypeVar

from sqlalchemy.orm import Session

from app.refusals import NotFound, OtherClinicRow
from app.store.access.visible_patients import WITH_DELETED


class ClinicRow(Protocol):
    """A row that names its clinic."""

    __tablename__: str

    @property
    def clinic_id(self) -> int:
        """Return the clinic."""


Row = TypeVar("Row", bound=ClinicRow)


def own_row(db: Session, kind: type[Row], clinic_id: int, row_id: int, missing: str, *, deleted: bool = False) -> Row:
    """Return a row of this clinic; what belongs to a deleted patient only with `deleted`.

    Raises
    ------
    NotFound
        With the sentence `missing`, when there is none of this id.
    OtherClinicRow
        With the same sentence, when it belongs to another clinic; the handler of this error logs it.
    """
    row = db.get(kind, row_id, execution_options=WITH_DELETED if deleted else {})
    if row is None:
        raise NotFound(missing)
    if row.clinic_id != clinic_id:
        raise OtherClinicRow(missing, kind.__tablename__, row_id)
    return row
