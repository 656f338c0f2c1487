"""The table of the clinic's own prior, and the clinics that have switched it off."""

from datetime import datetime
from typing import Any

from sqlalchemy import ForeignKey, String, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.store.tables import Table


class PriorEntry(Table):
    """What one patient adds to the clinic's prior for one shirt; erased with the patient."""

    __tablename__ = "prior_entry"
    __table_args__ = (UniqueConstraint("patient_id", "shirt", "simulated"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"))
    shirt: Mapped[str] = mapped_column(String(64))  # hash of its layout, its group, and which simulated shirt it is
    simulated: Mapped[bool]  # whether nobody wore the shirt
    document: Mapped[dict[str, Any]]
    made: Mapped[datetime]


class PriorSwitch(Table):
    """Whether a clinic learns from its accepted calibrations; without a row it does."""

    __tablename__ = "prior_switch"
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"), primary_key=True)
    on: Mapped[bool]
