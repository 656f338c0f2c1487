"""The table of the layouts that a clinic has made."""

from datetime import datetime

from sqlalchemy import ForeignKey, String, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.json_values import JsonDocument
from app.store.tables import Table


class ClinicLayout(Table):
    """A layout that was made by hand.

    Nothing refers to its row: the configuration of a shirt and the profile of a calibration have copies of the document
    as it was, so that a change here changes neither of them.
    """

    __tablename__ = "clinic_layout"
    __table_args__ = (UniqueConstraint("clinic_id", "name"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    name: Mapped[str] = mapped_column(String(80))  # that of the document
    version: Mapped[int]  # 1, 2, 3 ... with each change that was saved
    document: Mapped[JsonDocument]  # app.layout.ShirtLayout
    saved: Mapped[datetime]
