"""A row of the database by its id: one of the person's own clinic, or none at all."""

from typing import TypeVar

from sqlalchemy.orm import Session

from app.refusals import NotFound, OtherClinicRow
from app.store.tables import Chair, Drive, Patient, PatientScreen, Trial

Row = TypeVar("Row", Chair, Drive, Patient, PatientScreen, Trial)


def own_row(db: Session, kind: type[Row], clinic_id: int, row_id: int, missing: str) -> Row:
    """Return a row of this clinic.

    Raises
    ------
    NotFound
        With the sentence `missing`, when there is none of this id.
    OtherClinicRow
        With the same sentence, when another clinic has it; whoever answers the person notes it in the log.
    """
    row = db.get(kind, row_id)
    if row is None:
        raise NotFound(missing)
    if row.clinic_id != clinic_id:
        raise OtherClinicRow(missing, kind.__tablename__, row_id)
    return row
