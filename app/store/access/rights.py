"""Who may use the clinic: the list of people, their roles, and disabling them."""

from typing import Final, Literal

from sqlalchemy import delete, func, or_, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.refusals import Conflict, NotFound
from app.store.access.person_tables import Invitation, KnownBrowser, Person, SignIn
from app.store.log import write_log
from app.store.own_rows import own_row
from app.store.patients import find_patient
from app.texts import Text

PersonRole = Literal["owner", "clinician", "reviewer"]
# What each role may do; a route names the right that it needs (`app/api/deps.py`), also that of owners alone.
DRIVERS: Final[frozenset[PersonRole]] = frozenset({"owner", "clinician"})
"""Who may change what drives; a reviewer reads and comments."""
EXPORTERS: Final[frozenset[PersonRole]] = frozenset({"owner", "clinician"})
"""Who may take reports and exports out of the clinic."""


def find_person_by_id(db: Session, person_id: int) -> Person:
    """Return one of the clinic's people."""
    return own_row(db, Person, person_id, Text("store-no-person", person=person_id))


def people_of(db: Session) -> list[Person]:
    """Return the clinic's people, by name."""
    return list(db.scalars(select(Person).order_by(func.lower(Person.name))))


def checked_patients(db: Session, role: str, patients: list[int] | None) -> list[int] | None:
    """Return the patients of a reviewer, each once; None: all. Refuse a choice for another role, and unknown ones."""
    if patients is None:
        return None
    if role != "reviewer":
        raise Conflict(Text("store-patients-of-reviewers"))
    return sorted({find_patient(db, patient).id for patient in patients})


def change_rights(db: Session, person: Person, role: PersonRole, patients: list[int] | None, by: str | None) -> None:
    """Give a person another role, or show a reviewer other patients; the person's sign-ins end."""
    if (person.role, person.patients) == (role, patients):
        return
    if role != "owner":
        _require_another_owner(db, person)
    before = {"role": person.role, "patients": person.patients}
    person.role, person.patients = role, patients
    end_sign_ins(db, person)
    now = {"role": role, "patients": patients}
    write_log(db, by, "rights changed", person=person.id, name=person.name, before=before, now=now)


def disable(db: Session, person: Person, by: str | None) -> None:
    """Let a person sign in no longer: sign-ins, known browsers and an open link end."""
    if person.disabled is not None:
        return
    _require_another_owner(db, person)
    person.disabled = utc_now()
    end_sign_ins(db, person)
    for kind in (KnownBrowser, Invitation):
        db.execute(delete(kind).where(kind.person_id == person.id))
    write_log(db, by, "person disabled", person=person.id, name=person.name)


def enable(db: Session, person: Person, by: str | None) -> None:
    """Let a disabled person sign in again, with the password of before."""
    if person.disabled is None:
        return
    person.disabled = None
    write_log(db, by, "person enabled", person=person.id, name=person.name)


def end_sign_ins(db: Session, person: Person, but: int | None = None) -> None:
    """End the sign-ins of a person, all but the one with the id `but`."""
    db.flush()
    db.execute(delete(SignIn).where(SignIn.person_id == person.id, SignIn.id != (but or 0)))


def _require_another_owner(db: Session, person: Person) -> None:
    """Refuse when this person is the only owner who can sign in."""
    able = select(Person.id).where(
        Person.clinic_id == person.clinic_id,
        Person.role == "owner",
        Person.disabled.is_(None),
        # Without a password, an owner of a demonstration is signed in by its link; an invited one cannot sign in yet.
        or_(Person.password_hash.is_not(None), Person.id.in_(select(SignIn.person_id))),
    )
    owners = set(db.scalars(able))
    if owners == {person.id}:
        raise Conflict(Text("store-last-owner", name=person.name))


def needed_person(person: Person | None, name: str) -> Person:
    """Return a person who was looked up by name; NotFound when there is none."""
    if person is None:
        raise NotFound(Text("store-nobody-called", name=name))
    return person
