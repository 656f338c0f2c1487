"""The clinic and the people of a database that a test has set up."""

from sqlalchemy.orm import Session

from app.store.access.person_tables import Person
from app.store.people import find_person, the_clinic
from app.store.tables import Clinic


def known_clinic(db: Session) -> Clinic:
    """Return the clinic, which exists."""
    clinic = the_clinic(db)
    assert clinic is not None
    return clinic


def known_person(db: Session, name: str) -> Person:
    """Return the person of this name, who exists."""
    person = find_person(db, name)
    assert person is not None
    return person
