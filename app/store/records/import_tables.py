"""The tables of imports: which archive a patient came from, and which sessions came with it."""

from datetime import datetime

from sqlalchemy import ForeignKey, String
from sqlalchemy.orm import Mapped, mapped_column

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
