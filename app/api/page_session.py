"""Refuse a change whose page shows another session than the open one (header `Patient-Session`).

The check is made for every route of the API that is not in `without_session()`, also for new ones.
"""

import asyncio
import re
from collections.abc import Mapping
from functools import cache

from fastapi import Depends, HTTPException
from starlette.requests import HTTPConnection

from app.api.deps import Db
from app.api.who_asks import READS, WhoAsks
from app.features.registration import features
from app.session.page_session import PAGE_SESSION, PageSession, require_page_session

HEADER = "Patient-Session"
NOBODY = "none"
ID = re.compile(r"[1-9][0-9]{0,9}")

UNNAMED = (
    f"The request does not name the session that its page shows: send its id, or '{NOBODY}' while no session is open, "
    f"in the header {HEADER}."
)

_SIGN_IN = "It decides who uses this browser, whoever the patient is."
_OWN_NAME = "Its address names what it changes, so the open session does not matter."
_CLINIC = "It belongs to the clinic and to no patient."
_LOOKS = "It changes what one person looks at, and nothing else."

WITHOUT_SESSION = {
    "POST /control/stop": "Stop works at any time, for anybody.",
    "POST /control/dial": "Turning down works at any time; turning up is checked by the route itself.",
    "POST /auth/setup": _SIGN_IN,
    "POST /auth/demo": _SIGN_IN,
    "POST /auth/sign-in": _SIGN_IN,
    "POST /auth/unlock": _SIGN_IN,
    "POST /auth/invitation": _SIGN_IN,
    "POST /auth/invitation/accept": _SIGN_IN,
    "PUT /auth/password": _SIGN_IN,
    "POST /auth/introduction": _LOOKS,
    "POST /auth/sign-out": _SIGN_IN,
    "POST /patient-screen/pair": "The code was made for one session; the patient's screen shows no other.",
    "POST /patients": _OWN_NAME,
    "DELETE /patients/{patient_id}": _OWN_NAME,
    "POST /patients/{patient_id}/restore": _OWN_NAME,
    "POST /trials/{trial_id}/discard": _OWN_NAME,
    "POST /trials/{trial_id}/keep": _OWN_NAME,
    "POST /replays": _LOOKS,
    "POST /replays/{word}/at": _LOOKS,
    "DELETE /replays/{word}": _LOOKS,
    "POST /floorplans": _CLINIC,
    "PUT /floorplans/{name}": _CLINIC,
    "DELETE /floorplans/{name}": _CLINIC,
    "POST /floorplans/{name}/restore": _CLINIC,
    "POST /floorplans/check": _CLINIC,
    "POST /floorplans/import": _CLINIC,
    "POST /models": _CLINIC,
    "POST /equipment/files": _CLINIC,
    "POST /replaced/{kind}/{identity}/restore": _CLINIC,
    "POST /chairs": _CLINIC,
    "DELETE /chairs/{chair_id}": _CLINIC,
    "PUT /limits": _CLINIC,
    "POST /computer/measurement": _CLINIC,
    "POST /people": _CLINIC,
    "PUT /people/{person_id}": _CLINIC,
    "POST /people/{person_id}/link": _CLINIC,
    "POST /people/{person_id}/disable": _CLINIC,
    "POST /people/{person_id}/enable": _CLINIC,
}
"""Routes that change something without naming a session, each with the reason; features have more."""


@cache
def without_session() -> Mapping[str, str]:
    """Return these routes with those of all features."""
    return WITHOUT_SESSION | {route: why for one in features().values() for route, why in one.without_session.items()}


async def require_session(connection: HTTPConnection, database: Db, who: WhoAsks) -> None:
    """Refuse a change that names no session (422) or another session than the open one (409)."""
    method = connection.scope.get("method", "GET")  # a websocket has no method, and opening one changes nothing
    if method in READS or f"{method} {_path(connection)}" in without_session():
        return
    if who is not None and who.drives:  # the route refuses everybody else
        await require_named(connection, database)


async def require_named(connection: HTTPConnection, database: Db) -> None:
    """Read the session that the page of a request shows; Conflict when another one is open."""
    PAGE_SESSION.set(_page_session(connection.headers.get(HEADER, "")))

    def _check() -> None:
        with database.transaction() as db:
            require_page_session(db)

    await asyncio.to_thread(_check)


def _page_session(header: str) -> PageSession:
    if header == NOBODY:
        return PageSession(None)
    if ID.fullmatch(header) is None:
        raise HTTPException(422, UNNAMED)
    return PageSession(int(header))


def _path(connection: HTTPConnection) -> str:
    """Return the path of the route that a request reached, as in `without_session()`."""
    path: str = connection.scope["route"].path
    return path.removeprefix("/api/v1")


SessionRequired = Depends(require_session)
