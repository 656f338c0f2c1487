"""The clinic, its people, and their sign-ins."""

import hashlib
import secrets
from datetime import timedelta

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict, NotFound
from app.similar_names import require_distinct
from app.store.access.person_tables import Person, SignIn
from app.store.access.visible_patients import own_clinic_id
from app.store.log import write_log
from app.store.tables import Clinic

TOKEN_BYTES = 32
SIGNED_IN_FOR = timedelta(hours=12)  # a working day
IDLE_FOR = timedelta(minutes=10)  # without an action of the person; then the sign-in is locked
ACTION_STORED_EVERY = timedelta(seconds=15)  # so that an action seldom writes to the disk


def add_clinic(db: Session, name: str) -> Clinic:
    """Add the clinic of this database."""
    clinic = Clinic(name=name, created=utc_now(), shirt=None, body=None, unused=[], chair=None, limits=None)
    db.add(clinic)
    db.flush()
    return clinic


def the_clinic(db: Session) -> Clinic | None:
    """Return the clinic of this database, None before the set-up."""
    return db.scalar(select(Clinic).order_by(Clinic.id).limit(1))


def clinic_mark(db: Session) -> str:
    """Return the identity of a clinic, which a restored copy of it shares: see `mark_of`."""
    return mark_of(f"{db.get_one(Clinic, own_clinic_id(db)).created:%Y-%m-%d %H:%M:%S.%f}")


def mark_of(created: str) -> str:
    """Return the hash of when a clinic was set up; `created` as the database has it, to the microsecond."""
    return hashlib.sha256(repr((created,)).encode()).hexdigest()


def add_person(
    db: Session,
    clinic: Clinic,
    name: str,
    role: str,
    password_hash: str | None,
    *,
    patients: list[int] | None = None,
    by: str | None = None,
) -> Person:
    """Add a person who may sign in; without a password, by an invitation or a demonstration's link only.

    `patients` are those that a reviewer is shown, None: all; `by` is the name of who adds them, when somebody else.
    """
    if find_person(db, name) is not None:
        raise Conflict(f"There is already somebody called '{name}': choose another name to sign in with.")
    require_distinct(name, db.scalars(select(Person.name)), "somebody called")
    person = Person(
        clinic_id=clinic.id,
        name=name,
        role=role,
        patients=patients,
        password_hash=password_hash,
        created=utc_now(),
        disabled=None,
        introduced=False,
    )
    db.add(person)
    db.flush()
    write_log(db, by or name, "person added", person=person.id, name=name, role=role, patients=patients)
    return person


def count_people(db: Session) -> int:
    """Return the number of people; 0 before the set-up, which adds the first owner."""
    return db.scalar(select(func.count(Person.id))) or 0


def find_person(db: Session, name: str) -> Person | None:
    """Return the person of this name, also one who may no longer sign in; None when there is none."""
    return db.scalar(select(Person).where(Person.name == name))


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
        raise NotFound("This sign-in has ended: sign in again.")
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
