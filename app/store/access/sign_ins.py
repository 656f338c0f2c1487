"""Sign-ins of people: how long they last, when they are locked, and their tokens, which only browsers store."""

import hashlib
import secrets
from datetime import timedelta

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import NotFound
from app.store.access.person_tables import Person, SignIn
from app.store.log import write_log
from app.texts import Text

TOKEN_BYTES = 32
SIGNED_IN_FOR = timedelta(hours=12)  # a working day
IDLE_FOR = timedelta(minutes=10)  # without an action of the person; then the sign-in is locked
ACTION_STORED_EVERY = timedelta(seconds=15)  # so that an action seldom writes to the disk


def _token_hash(token: str) -> str:
    return hashlib.sha256(token.encode()).hexdigest()


def sign_in(db: Session, person: Person, how: str) -> str:
    """Add a sign-in and return its token, which only the browser stores."""
    token = secrets.token_urlsafe(TOKEN_BYTES)
    now = utc_now()
    for old in db.scalars(select(SignIn).where(SignIn.expires < now)):
        db.delete(old)
    ends = now + SIGNED_IN_FOR
    db.add(SignIn(token_hash=_token_hash(token), person_id=person.id, created=now, active=now, expires=ends))
    write_log(db, person.name, "sign-in", how=how)
    return token


def signed_in(db: Session, token: str) -> tuple[SignIn, Person] | None:
    """Return the sign-in of a token with its person, None when it has ended."""
    row = db.execute(
        select(SignIn, Person)
        .join(Person, Person.id == SignIn.person_id)
        .where(SignIn.token_hash == _token_hash(token), SignIn.expires > utc_now(), Person.disabled.is_(None))
    ).first()
    return None if row is None else (row[0], row[1])


def is_locked(sign_in: SignIn, person: Person) -> bool:
    """Return whether a sign-in is locked: its person has done nothing for IDLE_FOR, and has a password to unlock it."""
    return person.password_hash is not None and utc_now() - sign_in.active > IDLE_FOR


def store_action(sign_in: SignIn, person: Person) -> None:
    """Store that the person of a sign-in has just done something; a locked sign-in stays locked."""
    now = utc_now()
    if not is_locked(sign_in, person) and now - sign_in.active > ACTION_STORED_EVERY:
        sign_in.active = now


def unlock(db: Session, sign_in_id: int) -> None:
    """Unlock a sign-in, whose person has given the password."""
    row = db.get(SignIn, sign_in_id)
    person = None if row is None else db.get(Person, row.person_id)
    if row is None or person is None:
        raise NotFound(Text("store-sign-in-ended"))
    row.active = utc_now()
    write_log(db, person.name, "unlocked")


def sign_out(db: Session, token: str) -> int | None:
    """End a sign-in; return its id, None when it had ended before."""
    row = signed_in(db, token)
    if row is None:
        return None
    ended, person = row
    db.delete(ended)
    write_log(db, person.name, "sign-out")
    return ended.id
