"""The clinic, and its people."""

import hashlib

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict
from app.similar_names import require_distinct
from app.store.access.person_tables import Person
from app.store.access.visible_patients import own_clinic_id
from app.store.log import write_log
from app.store.tables import Clinic
from app.texts import Text


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
        raise Conflict(Text("store-person-name-taken", name=name))
    require_distinct(name, db.scalars(select(Person.name)), "names-person-taken")
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
