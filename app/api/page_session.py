"""Refuse a change whose page shows another session than the open one (header `Patient-Session`).

Each route that changes something asks for a `ClinicianInSession`, or says by `any_session` why no session matters to it
(tests/api/test_page_session.py).
"""

import asyncio
import re
from collections.abc import Callable
from typing import Annotated, Final, TypeVar

from fastapi import Depends, Header, HTTPException

from app.api.deps import Clinician, Db
from app.api.sign_in.identity import SignedInPerson
from app.session.page_session import PAGE_SESSION, PageSession, require_page_session
from app.store.database import Database
from app.texts import Text

HEADER = "Patient-Session"
NOBODY = "none"
ID = re.compile(r"[1-9][0-9]{0,9}")

UNNAMED = Text("api-session-unnamed", none=NOBODY, header=HEADER)

SIGN_IN: Final = "It decides who uses this browser, whoever the patient is."
OWN_NAME: Final = "Its address names what it changes, so the open session does not matter."
OF_CLINIC: Final = "It belongs to the clinic and to no patient."
LOOKS: Final = "It changes what one person looks at, and nothing else."

Route = TypeVar("Route", bound=Callable[..., object])
ShownSession = Annotated[
    str, Header(alias=HEADER, description=f"The id of the session that the page shows, or '{NOBODY}' for no session.")
]


def any_session(reason: str) -> Callable[[Route], Route]:
    """Mark a route that changes something whichever session is open, with the reason."""

    def mark(route: Route) -> Route:
        vars(route)["any_session"] = reason
        return route

    return mark


async def clinician_in_session(person: Clinician, database: Db, shown: ShownSession = "") -> SignedInPerson:
    """Return the person who is signed in, whose page shows the open session.

    Refuse a request that names no session (422) or another session than the open one (409).
    """
    await require_open(database, shown)
    return person


async def require_open(database: Database, shown: str) -> None:
    """Read the session that the page of a request shows; Conflict when another one is open."""
    PAGE_SESSION.set(_page_session(shown))

    def check() -> None:
        with database.reading() as db:
            require_page_session(db)

    await asyncio.to_thread(check)


def _page_session(shown: str) -> PageSession:
    if shown == NOBODY:
        return PageSession(None)
    if ID.fullmatch(shown) is None:
        raise HTTPException(422, UNNAMED)
    return PageSession(int(shown))


ClinicianInSession = Annotated[SignedInPerson, Depends(clinician_in_session)]
