"""The table of what patients have consented to."""

from datetime import date, datetime

from sqlalchemy import Date, ForeignKey, Index, String, text
from sqlalchemy.orm import Mapped, mapped_column

from app.store.tables import Table


class PatientConsent(Table):
    """One consent of a patient, from the day when it was given; the row stays when it is withdrawn."""

    __tablename__ = "patient_consent"
    __table_args__ = (
        Index(
            "uq_patient_consent_in_force", "patient_id", "consent", unique=True, sqlite_where=text("withdrawn IS NULL")
        ),
    )
    id: Mapped[int] = mapped_column(primary_key=True)
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"), index=True)
    consent: Mapped[str] = mapped_column(String(16))  # one of CONSENTS (app/store/consent.py)
    given: Mapped[date] = mapped_column(Date)
    person: Mapped[str] = mapped_column(String(80))  # who wrote it down
    written: Mapped[datetime]
    withdrawn: Mapped[datetime | None]
    withdrawn_by: Mapped[str | None] = mapped_column(String(80))
