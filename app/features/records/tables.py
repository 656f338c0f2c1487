"""The tables of a session's record: notes with their revisions, scales, sign-offs."""

from datetime import date, datetime

from sqlalchemy import Date, Float, ForeignKey, Index, String, text
from sqlalchemy.orm import Mapped, mapped_column

from app.store.tables import Table


class SessionNote(Table):
    """A note about a session; its text is that of its newest revision."""

    __tablename__ = "session_note"
    id: Mapped[int] = mapped_column(primary_key=True)
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), index=True)


class NoteRevision(Table):
    """One text of a note, with its author; never changed."""

    __tablename__ = "note_revision"
    id: Mapped[int] = mapped_column(primary_key=True)
    note_id: Mapped[int] = mapped_column(ForeignKey("session_note.id"), index=True)
    text: Mapped[str] = mapped_column(String(8000))
    person: Mapped[str] = mapped_column(String(80))
    written: Mapped[datetime]


class OutcomeScale(Table):
    """The total of an outcome scale; no items, because most forms are licensed."""

    __tablename__ = "outcome_scale"
    id: Mapped[int] = mapped_column(primary_key=True)
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), index=True)
    name: Mapped[str] = mapped_column(String(80))
    total: Mapped[float] = mapped_column(Float)
    day: Mapped[date] = mapped_column(Date)


class SessionSignOff(Table):
    """One sign-off of a session; the row stays when an owner unlocks the session."""

    __tablename__ = "session_sign_off"
    __table_args__ = (
        # At most one sign-off of a session is in force.
        Index("uq_session_sign_off_in_force", "session_id", unique=True, sqlite_where=text("unlocked IS NULL")),
    )
    id: Mapped[int] = mapped_column(primary_key=True)
    session_id: Mapped[int] = mapped_column(ForeignKey("session.id"), index=True)
    person: Mapped[str] = mapped_column(String(80))
    at: Mapped[datetime]
    unlocked: Mapped[datetime | None]
    unlocked_by: Mapped[str | None] = mapped_column(String(80))
    reason: Mapped[str | None] = mapped_column(String(200))  # why it was unlocked
