"""Known browsers, in which a person has signed in before: wrong passwords from elsewhere do not lock them out."""

import hashlib
import secrets
from datetime import timedelta

from sqlalchemy import delete, select
from sqlalchemy.orm import Session

from app.clock import utc_now
from app.store.access.person_tables import KnownBrowser, Person

TOKEN_BYTES = 32
KNOWN_FOR = timedelta(days=180)  # since the last sign-in there
MOST = 20  # of one person


def _hash(person: Person, token: str) -> str:
    # The hash includes the stored hash of the password: after a change of password, every browser is unknown.
    return hashlib.sha256(f"{person.password_hash} {token}".encode()).hexdigest()


def find_browser(db: Session, person: Person | None, token: str | None) -> KnownBrowser | None:
    """Return the known browser of a token, None when this person has not signed in there."""
    if person is None or person.disabled is not None or token is None:
        return None
    return db.scalar(
        select(KnownBrowser).where(
            KnownBrowser.person_id == person.id,
            KnownBrowser.token_hash == _hash(person, token),
            KnownBrowser.expires > utc_now(),
        )
    )


def remember_browser(db: Session, person: Person, token: str | None) -> str:
    """Make the browser in which a person has just signed in a known one; return its token, which only it stores."""
    now = utc_now()
    browser = find_browser(db, person, token)
    if browser is not None and token is not None:
        browser.expires = now + KNOWN_FOR
        return token
    new = secrets.token_urlsafe(TOKEN_BYTES)
    db.add(KnownBrowser(person_id=person.id, token_hash=_hash(person, new), created=now, expires=now + KNOWN_FOR))
    db.flush()
    newest = select(KnownBrowser.id).where(KnownBrowser.person_id == person.id).order_by(KnownBrowser.id.desc())
    db.execute(
        delete(KnownBrowser).where(KnownBrowser.person_id == person.id, KnownBrowser.id.not_in(newest.limit(MOST)))
    )
    return new
