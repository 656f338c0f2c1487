"""The tables of share links, by which somebody outside the clinic reads."""

from datetime import datetime

from sqlalchemy import ForeignKey, String
from sqlalchemy.orm import Mapped, mapped_column

from app.store.tables import Table


class ShareLink(Table):
    """A link by which somebody outside reads one session or the course of a patient; its token is never stored."""

    __tablename__ = "share_link"
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    patient_id: Mapped[int] = mapped_column(ForeignKey("patient.id"), index=True)
    session_id: Mapped[int | None] = mapped_column(ForeignKey("session.id"), index=True)  # None: all sessions
    token_hash: Mapped[str] = mapped_column(String(64), unique=True)
    pin_hash: Mapped[str]
    person: Mapped[str] = mapped_column(String(80))  # who made it
    created: Mapped[datetime]
    expires: Mapped[datetime]
    revoked: Mapped[datetime | None]
    wrong_pins: Mapped[int]  # tries that were counted and not taken back
    openings: Mapped[int]


class ShareVisit(Table):
    """A browser in which the PIN of a share link was given; the token itself is never stored."""

    __tablename__ = "share_visit"
    id: Mapped[int] = mapped_column(primary_key=True)
    share_id: Mapped[int] = mapped_column(ForeignKey("share_link.id"), index=True)
    token_hash: Mapped[str] = mapped_column(String(64), unique=True)
    expires: Mapped[datetime]
