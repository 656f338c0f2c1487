"""Where sessions were held: in this clinic, or in another one whose archive of the patient was imported here.

A trial of another clinic is no practice before a real chair of this one (`app/store/practice.py`).
"""

from dataclasses import dataclass
from datetime import datetime

from sqlalchemy import ForeignKey, String, select
from sqlalchemy.orm import Mapped, Session, mapped_column

from app.store.tables import Table


class PatientImport(Table):
    """One archive that was imported, and the patient that it brought."""

    __tablename__ = "patient_import"
    id: Mapped[int] = mapped_column(primary_key=True)
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"), index=True)
    archive: Mapped[str] = mapped_column(String(64), unique=True)  # the archive's hash
    clinic: Mapped[str] = mapped_column(String(80))  # name of the clinic that the archive was made in
    person: Mapped[str] = mapped_column(String(80))  # who imported it
    at: Mapped[datetime]


class ImportedSession(Table):
    """A session that came with an archive; all its rows came with it. Other sessions were held here."""

    __tablename__ = "imported_session"
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), primary_key=True)
    import_id: Mapped[int] = mapped_column(ForeignKey("patient_import.id"), index=True)


@dataclass(frozen=True, slots=True)
class Origin:
    """Where an imported session was held, and who imported it when."""

    clinic: str
    person: str
    at: datetime


def origin_of(db: Session, session_id: int) -> PatientImport | None:
    """Return where a session came from, None when it was held in this clinic."""
    query = select(PatientImport).join(ImportedSession, ImportedSession.import_id == PatientImport.id)
    return db.scalar(query.where(ImportedSession.session_id == session_id))


def origins_of(db: Session, patient_id: int) -> dict[int, Origin]:
    """Return where each imported session of a patient came from, by session; sessions held here are not in it."""
    query = (
        select(ImportedSession.session_id, PatientImport)
        .join(PatientImport, PatientImport.id == ImportedSession.import_id)
        .where(PatientImport.patient_id == patient_id)
    )
    return {session: Origin(row.clinic, row.person, row.at) for session, row in db.execute(query)}
