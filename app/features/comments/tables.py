"""The tables of comments on a moment of a trial: the comment, its texts, and who has read which."""

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
