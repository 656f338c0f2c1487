"""Invitations: links by which a person chooses a password, valid once and for VALID_FOR."""

import hashlib
import secrets
from dataclasses import dataclass
from datetime import datetime, timedelta

from sqlalchemy import delete, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict
from app.store.access.person_tables import Invitation, Person
from app.store.access.rights import end_sign_ins
from app.store.log import write_log
from app.texts import Text

CODE_BYTES = 32
VALID_FOR = timedelta(hours=24)


@dataclass(frozen=True, slots=True)
class MadeInvitation:
    """A new link's code, which is shown once and stored nowhere, and when it ends."""

    code: str
    expires: datetime


def _hash(code: str) -> str:
    return hashlib.sha256(code.encode()).hexdigest()


def invite(db: Session, person: Person, by: str | None) -> MadeInvitation:
    """Make a link by which a person chooses a password; an earlier link of this person becomes invalid.

    `by` is the name of the owner who asks, None for the command line.
    """
    if person.disabled is not None:
        raise Conflict(Text("store-invited-disabled", name=person.name))
    forget_invitation(db, person)
    code, now = secrets.token_urlsafe(CODE_BYTES), utc_now()
    expires = now + VALID_FOR
    db.add(Invitation(person_id=person.id, code_hash=_hash(code), created=now, expires=expires))
    write_log(db, by, "invitation made", person=person.id, name=person.name, new=person.password_hash is None)
    return MadeInvitation(code, expires)


def find_invited(db: Session, code: str) -> Person | None:
    """Return the person for whom a code is valid, None for a code that is wrong, used or too old."""
    return db.scalar(
        select(Person)
        .join(Invitation, Invitation.person_id == Person.id)
        .where(Invitation.code_hash == _hash(code), Invitation.expires > utc_now(), Person.disabled.is_(None))
    )


def open_invitation(db: Session, person: Person) -> Invitation | None:
    """Return the invitation of a person that is still valid, None when there is none."""
    return db.scalar(select(Invitation).where(Invitation.person_id == person.id, Invitation.expires > utc_now()))


def accept_invitation(db: Session, person: Person, password_hash: str) -> None:
    """Give the invited person the password; the link and all sign-ins of the person end."""
    forget_invitation(db, person)
    end_sign_ins(db, person)
    person.password_hash = password_hash
    db.flush()
    write_log(db, person.name, "invitation accepted", person=person.id)


def forget_invitation(db: Session, person: Person) -> None:
    """Make the link of a person invalid."""
    db.execute(delete(Invitation).where(Invitation.person_id == person.id))
