"""Middleware of every route: whether a request comes from our own page to our own host, and is not too large.

The headers of its answer: response_headers.py. How large a request may be: body_limits.py.
"""

from fastapi import HTTPException
from fastapi.responses import JSONResponse
from starlette.datastructures import MutableHeaders
from starlette.requests import HTTPConnection
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.api.body_limits import Bodies
from app.api.origin import host_is_ours, may_pass
from app.api.response_headers import add_headers
from app.api.sign_in.cookies import is_encrypted
from app.settings import Settings
from app.store.access.visible_patients import NOBODY, VISIBLE_PATIENTS
from app.texts import Text

NOT_OURS = Text("api-address-not-ours")
NOT_OUR_PAGE = Text("api-not-our-page")


class Guard:
    """Checks host, origin and size of a request, and adds the headers of its answer."""

    def __init__(self, app: ASGIApp, settings: Settings) -> None:
        self._app = app
        self._settings = settings
        self._bodies = Bodies()

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Check and answer a request; websockets are checked by their own routes before they are accepted."""
        if scope["type"] != "lifespan":
            VISIBLE_PATIENTS.set(NOBODY)  # until it is known who asks
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        connection, path = HTTPConnection(scope), scope["path"]
        headers = connection.headers
        ours = host_is_ours(self._settings, headers)

        async def with_headers(message: Message) -> None:
            if message["type"] == "http.response.start":
                host = headers.get("host", "") if ours else ""
                add_headers(MutableHeaders(scope=message), path, host, is_encrypted=is_encrypted(connection))
            await send(message)

        if not ours:
            answer = JSONResponse({"detail": str(NOT_OURS)}, 421)
        elif not may_pass(scope["method"], path, connection):
            answer = JSONResponse({"detail": str(NOT_OUR_PAGE)}, 403)
        else:
            body = self._bodies.of(connection, receive)
            try:
                await body.begin()
            except HTTPException as refused:
                answer = JSONResponse({"detail": str(refused.detail)}, refused.status_code)
            else:
                try:
                    await self._app(scope, body.receive, with_headers)
                finally:
                    body.end()
                return
        await answer(scope, receive, with_headers)
