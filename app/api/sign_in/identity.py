"""The identity behind a request's cookies: a person who is signed in, or a paired screen of the patient."""

from collections.abc import Mapping
from dataclasses import dataclass

from app.store.database import Database
from app.store.patient_screens import find_screen
from app.store.people import signed_in

COOKIE = "bodydrive_sign_in"
SCREEN_COOKIE = "bodydrive_screen"  # of a paired screen of the patient: it gives access to the patient's picture only


@dataclass(frozen=True, slots=True)
class SignedInPerson:
    """A person with an open sign-in."""

    sign_in_id: int
    person_id: int
    clinic_id: int
    name: str
    role: str


def find_signed_in(database: Database, cookies: Mapping[str, str]) -> SignedInPerson | None:
    """Return the person whose sign-in the cookie opens, None when there is none or it has ended."""
    token = cookies.get(COOKIE)
    if not token:
        return None
    with database.transaction() as db:
        found = signed_in(db, token)
        if found is None:
            return None
        opened, person = found
        return SignedInPerson(opened.id, person.id, person.clinic_id, person.name, person.role)


@dataclass(frozen=True, slots=True)
class PairedScreen:
    """A paired screen of the patient, as long as its session is open."""

    screen_id: int
    session_id: int


def find_paired_screen(database: Database, cookies: Mapping[str, str]) -> PairedScreen | None:
    """Return the patient's screen of the cookie, None when its session has ended or it was unpaired."""
    token = cookies.get(SCREEN_COOKIE)
    if not token:
        return None
    with database.transaction() as db:
        screen, _ = find_screen(db, token)
        return None if screen is None else PairedScreen(screen.id, screen.session_id)


def find_viewer(database: Database, cookies: Mapping[str, str]) -> SignedInPerson | PairedScreen | None:
    """Return who may see the patient's picture: a person who is signed in, or a paired screen of the patient."""
    return find_signed_in(database, cookies) or find_paired_screen(database, cookies)
