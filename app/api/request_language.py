"""The language of a request: named in its address, the reader's choice in a cookie, or what the browser asks for.

The patient's screen names its language in the address: it may stand in the same browser as the clinician's page.
"""

import asyncio
from collections.abc import Iterator
from typing import Final

from starlette.requests import HTTPConnection
from starlette.responses import Response
from starlette.types import ASGIApp, Receive, Scope, Send

from app.api.sign_in.cookies import read_cookie, set_cookie
from app.texts import ENGLISH, LANGUAGES, load_language, reader_language

COOKIE: Final = "language"
IN_ADDRESS: Final = "language"  # of the query
KEPT_FOR: Final = 31_536_000  # s: a year


class RequestLanguage:
    """Middleware that makes all sentences of a request's answer in the reader's language."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app
        self._loaded = {ENGLISH}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass the request on."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        language = language_of(HTTPConnection(scope))
        if language not in self._loaded:  # in a thread: a Stop waits for no language
            await asyncio.to_thread(load_language, language)
            self._loaded.add(language)
        with reader_language(language):
            await self._app(scope, receive, send)


def language_of(request: HTTPConnection) -> str:
    """Return the language of a request, English where it names none of LANGUAGES."""
    for chosen in (request.query_params.get(IN_ADDRESS), read_cookie(request, COOKIE)):
        if chosen in LANGUAGES:
            return chosen
    return next(_wanted(request.headers.get("accept-language", "")), ENGLISH)


def keep_language(request: HTTPConnection, response: Response, language: str) -> None:
    """Make a language that of this browser's later requests."""
    set_cookie(request, response, COOKIE, language, max_age=KEPT_FOR)


def _wanted(header: str) -> Iterator[str]:
    """Yield the languages of an Accept-Language header (RFC 9110, 12.5.4) that there are, the most wanted first."""
    weights = {}
    for part in header.split(","):
        name, _, weight = part.partition(";q=")
        try:
            weights[name.strip().partition("-")[0].lower()] = float(weight or 1)
        except ValueError:
            continue
    yield from sorted(weights.keys() & set(LANGUAGES), key=weights.__getitem__, reverse=True)
