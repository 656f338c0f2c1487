"""The tables of the people of a clinic: who may sign in, sign-ins, known browsers, invitations."""

from datetime import datetime

from sqlalchemy import ForeignKey, String, UniqueConstraint
from sqlalchemy.orm import Mapped, mapped_column

from app.store.tables import Table


class Person(Table):
    """A person who may sign in."""

    __tablename__ = "person"
    __table_args__ = (UniqueConstraint("clinic_id", "name"),)
    id: Mapped[int] = mapped_column(primary_key=True)
    clinic_id: Mapped[int] = mapped_column(ForeignKey("clinic.id"))
    name: Mapped[str] = mapped_column(String(80))
    role: Mapped[str] = mapped_column(String(16))  # owner, clinician, reviewer
    patients: Mapped[list[int] | None]  # ids of the patients that are shown to a reviewer; None: all
    password_hash: Mapped[str | None]  # None: invited, or signs in by the link of a demonstration only
    created: Mapped[datetime]
    disabled: Mapped[datetime | None]
    introduced: Mapped[bool] = mapped_column(server_default="0")  # has put the sentences for a first time away
    language: Mapped[str | None] = mapped_column(String(8))  # None: that of the browser


class SignIn(Table):
    """A sign-in that holds until sign-out or its end; the token itself is never stored."""

    __tablename__ = "auth_session"
    id: Mapped[int] = mapped_column(primary_key=True)
    token_hash: Mapped[str] = mapped_column(String(64), unique=True)
    person_id: Mapped[int] = mapped_column(ForeignKey("person.id"), index=True)
    created: Mapped[datetime]
    active: Mapped[datetime]  # the last action of the person; stored at most every few seconds
    expires: Mapped[datetime]


class KnownBrowser(Table):
    """A browser in which a person has signed in before; the token itself is never stored."""

    __tablename__ = "known_browser"
    id: Mapped[int] = mapped_column(primary_key=True)
    person_id: Mapped[int] = mapped_column(ForeignKey("person.id"), index=True)
    token_hash: Mapped[str] = mapped_column(String(64), unique=True)
    created: Mapped[datetime]
    expires: Mapped[datetime]


class Invitation(Table):
    """A link by which a person chooses a password, once; the code itself is never stored."""

    __tablename__ = "invitation"
    id: Mapped[int] = mapped_column(primary_key=True)
    person_id: Mapped[int] = mapped_column(ForeignKey("person.id"), unique=True)
    code_hash: Mapped[str] = mapped_column(String(64), unique=True)
    created: Mapped[datetime]
    expires: Mapped[datetime]
