"""Who is signed in, and which screens of the patient are paired: the cookies, and what they stand for."""

from collections.abc import Mapping
from dataclasses import dataclass

from app.store.database import Database
from app.store.patient_screens import find_screen
from app.store.people import signed_in

COOKIE = "bodydrive_session"
SCREEN_COOKIE = "bodydrive_screen"  # of a screen that the patient looks at: it opens nothing else than that picture


@dataclass(frozen=True, slots=True)
class SignedInPerson:
    """A person with an open sign-in."""

    session_id: int
    person_id: int
    clinic_id: int
    name: str
    role: str


def find_signed_in(database: Database, cookies: Mapping[str, str]) -> SignedInPerson | None:
    """Return who the cookie belongs to, None when nobody or when the sign-in has ended."""
    token = cookies.get(COOKIE)
    if not token:
        return None
    with database.transaction() as db:
        found = signed_in(db, token)
        if found is None:
            return None
        session, person = found
        return SignedInPerson(session.id, person.id, person.clinic_id, person.name, person.role)


@dataclass(frozen=True, slots=True)
class PairedScreen:
    """A screen of the patient, as long as its session goes on."""

    screen_id: int
    session_id: int


def find_paired_screen(database: Database, cookies: Mapping[str, str]) -> PairedScreen | None:
    """Return which of the patient's screens the cookie belongs to, None when its session is over or it was unpaired."""
    token = cookies.get(SCREEN_COOKIE)
    if not token:
        return None
    with database.transaction() as db:
        screen, _ = find_screen(db, token)
        return None if screen is None else PairedScreen(screen.id, screen.session_id)


def find_viewer(database: Database, cookies: Mapping[str, str]) -> SignedInPerson | PairedScreen | None:
    """Return who may look at the patient's picture: whoever is signed in, and the patient's screens."""
    return find_signed_in(database, cookies) or find_paired_screen(database, cookies)
