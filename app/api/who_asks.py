"""Who asks: found once for each request, before its route; the request then sees the patients of this person only."""

import asyncio
from typing import Annotated

from fastapi import Depends
from starlette.requests import HTTPConnection

from app.api.parts import parts_of
from app.api.sign_in.cookies import read_cookie
from app.api.sign_in.identity import COOKIE, SignedInPerson, find_sign_in
from app.store.access.visible_patients import OWN_CLINIC, VISIBLE_PATIENTS
from app.store.database import Database

AT_ONCE = frozenset({"/control/stop"})  # it asks nobody's name, and must not wait for the database
READS = frozenset({"GET", "HEAD", "OPTIONS"})
BY_THEMSELVES = frozenset({"/replays/{word}/at"})  # changes that a page sends without an action of a person


async def who_asks(connection: HTTPConnection) -> SignedInPerson | None:
    """Return the person who is signed in, locked or not; None for nobody. Every later query shows their patients only.

    For nobody, no patient exists (`app/api/guard.py`). Async, so that what it sets holds for the route, too. A request
    that changes something counts as an action. A websocket is admitted by its own route (`app/api/sockets.py`), and
    reads no patient from the database.
    """
    if connection.scope["type"] != "http" or not read_cookie(connection, COOKIE) or _route_path(connection) in AT_ONCE:
        return None
    method = connection.scope["method"]
    acts = method not in READS and _route_path(connection) not in BY_THEMSELVES
    database = parts_of(connection.app)[Database]
    person = await asyncio.to_thread(find_sign_in, database, connection, acts=acts)
    if person is not None:
        VISIBLE_PATIENTS.set(person.patients)
        OWN_CLINIC.set(person.clinic_id)
    return person


def _route_path(connection: HTTPConnection) -> str:
    return str(getattr(connection.scope.get("route"), "path", "")).removeprefix("/api/v1")


WhoAsks = Annotated[SignedInPerson | None, Depends(who_asks)]
