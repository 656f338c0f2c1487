"""The tables of review from elsewhere: comments on a moment of a trial, and share links."""

from datetime import datetime

from sqlalchemy import Float, ForeignKey, String
from sqlalchemy.orm import Mapped, mapped_column

from app.store.tables import Table


class MomentComment(Table):
    """A comment on a moment of a trial; its text is that of its newest revision."""

    __tablename__ = "moment_comment"
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    trial_id: Mapped[int] = mapped_column(ForeignKey("trial.id"), index=True)
    person_id: Mapped[int | None] = mapped_column(ForeignKey("person.id"), index=True)  # None: an author elsewhere
    author: Mapped[str | None] = mapped_column(String(80))  # name of an author elsewhere: it came with an archive
    t: Mapped[float] = mapped_column(Float)  # s on the time line of the trial
    withdrawn: Mapped[datetime | None]


class CommentRevision(Table):
    """One text of a comment; never changed."""

    __tablename__ = "comment_revision"
    id: Mapped[int] = mapped_column(primary_key=True)
    comment_id: Mapped[int] = mapped_column(ForeignKey("moment_comment.id"), index=True)
    text: Mapped[str] = mapped_column(String(2000))
    written: Mapped[datetime]


class CommentReading(Table):
    """The newest revision of a comment that a person has read."""

    __tablename__ = "comment_reading"
    comment_id: Mapped[int] = mapped_column(ForeignKey("moment_comment.id"), primary_key=True)
    person_id: Mapped[int] = mapped_column(ForeignKey("person.id"), primary_key=True, index=True)
    revision_id: Mapped[int] = mapped_column(ForeignKey("comment_revision.id"), index=True)


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
