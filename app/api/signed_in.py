"""Who is signed in: the cookie, and what it stands for."""

from collections.abc import Mapping
from dataclasses import dataclass

from app.session.database import Database
from app.session.store_people import signed_in

COOKIE = "bodydrive_session"


@dataclass(frozen=True, slots=True)
class SignedIn:
    """A person with an open sign-in."""

    session_id: int
    person_id: int
    clinic_id: int
    name: str
    role: str


def find_signed_in(database: Database, cookies: Mapping[str, str]) -> SignedIn | None:
    """Return who the cookie belongs to, None when nobody or when the sign-in has ended."""
    token = cookies.get(COOKIE)
    if not token:
        return None
    with database.transaction() as db:
        found = signed_in(db, token)
        if found is None:
            return None
        session, person = found
        return SignedIn(session.id, person.id, person.clinic_id, person.name, person.role)
