"""Middleware of every route: the security headers of its answer, and the check of origin and size of a request.

Who may send a large body is decided before it is read, because the framework reads a form, onto the disk from 1 MB on,
before it asks who sends it; size, time and number of large bodies are limited.
"""

import asyncio
import math
from collections.abc import Callable

from fastapi import HTTPException
from fastapi.responses import JSONResponse
from starlette.datastructures import MutableHeaders
from starlette.requests import HTTPConnection
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from app.api.deps import anyone_signed_in, clinician
from app.api.origin import host_is_ours, may_pass
from app.api.parts import parts_of
from app.api.sign_in.cookies import is_encrypted
from app.api.sign_in.identity import find_sign_in
from app.clock import monotonic
from app.settings import Settings
from app.store.access.visible_patients import NOBODY, VISIBLE_PATIENTS
from app.store.database import Database
from app.texts import Text
from app.world.imports.file_limits import MOST_PLAN_BYTES

# Our pages run only scripts of this program. The 3D view has its own policy (view_bridge.py).
PAGE_POLICY = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "worker-src 'self'",
        "style-src 'self' 'unsafe-inline'",
        "img-src 'self' data: blob:",
        "font-src 'self'",
        "connect-src 'self' {sockets}",
        "frame-src 'self'",
        "frame-ancestors 'self'",
        "form-action 'self'",
        "base-uri 'none'",
        "manifest-src 'self'",
        "media-src 'self'",
    )
)
HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "X-Frame-Options": "SAMEORIGIN",
}

# A browser that was here over https asks for no page of this name over http for 30 days (decisions/0041).
ONLY_HTTPS = "max-age=2592000"

NOT_OURS = Text("api-address-not-ours")
NOT_OUR_PAGE = Text("api-not-our-page")

SMALL = 64_000  # bytes: whatever a page sends but files, floor plans and controls; anybody may send so much
BODY_LIMIT = 2_000_000  # bytes
# Bytes by the beginning of the path: the largest file, plus the parts of its form.
LIMITS = {
    "/api/v1/equipment/files": 65_000_000,
    "/api/v1/floorplans/import": 2 * MOST_PLAN_BYTES + 1_000_000,  # a ROS map and its image
    "/api/v1/floorplans": 8_100_000,
    "/api/v1/models": 21_000_000,
    "/api/v1/archives": 8_000_000_000,  # a hundred hours of recordings
}
MOST_AT_ONCE = 4  # large bodies, which together need 260 MB of temporary disk; archives look for room themselves
FIRST, SLOWEST = 20.0, 100_000.0  # s, and bytes/s: a body takes FIRST, and longer by its length over SLOWEST

TOO_MANY = Text("api-too-many-files")
TOO_SLOW = Text("api-too-slow")


class Bodies:
    """Passes on the bodies of requests; counts the large ones that are being read."""

    def __init__(self, now: Callable[[], float] = monotonic) -> None:
        self._now = now
        self._large: set[RequestBody] = set()

    def of(self, connection: HTTPConnection, receive: Receive) -> "RequestBody":
        """Return the body of a request; the caller ends it when the request has been answered."""
        return RequestBody(connection, receive, self._large, self._now)


class RequestBody:
    """The body of a request, which raises HTTPException in place of what may not be read."""

    def __init__(
        self, connection: HTTPConnection, receive: Receive, large: "set[RequestBody]", now: Callable[[], float]
    ) -> None:
        self._connection = connection
        self._receive = receive
        self._large = large
        self._now = now
        self._limit = _limit(connection.scope["path"])
        announced = connection.headers.get("content-length", "")
        self._length = int(announced) if announced.isdecimal() else None
        self._received = 0
        self._is_read = False
        self._until = math.inf  # monotonic s

    async def begin(self) -> None:
        """Refuse a body that is announced as too large, or whose sender may not send that much."""
        if self._length is not None:
            await self._judge(self._length)
        expected = self._limit if self._length is None else self._length
        self._until = self._now() + FIRST + (expected - min(expected, SMALL)) / SLOWEST

    async def receive(self) -> Message:
        """Return the next message of the request."""
        if self._is_read:
            return await self._receive()  # waits until the browser has gone
        try:
            async with asyncio.timeout(self._until - self._now()):
                message = await self._receive()
        except TimeoutError as error:
            raise HTTPException(408, TOO_SLOW) from error
        self._received += len(message.get("body", b""))
        self._is_read = not message.get("more_body", False)
        await self._judge(self._received)
        return message

    def end(self) -> None:
        """Give room to the next large body."""
        self._large.discard(self)

    async def _judge(self, size: int) -> None:
        if size > self._limit:
            raise HTTPException(413, Text("api-too-large", megabytes=self._limit // 1_000_000))
        if size <= SMALL or self in self._large:
            return
        database = parts_of(self._connection.app)[Database]
        await clinician(await anyone_signed_in(await asyncio.to_thread(find_sign_in, database, self._connection)))
        if len(self._large) >= MOST_AT_ONCE:
            raise HTTPException(503, TOO_MANY)
        self._large.add(self)


def _limit(path: str) -> int:
    return next((limit for start, limit in LIMITS.items() if path.startswith(start)), BODY_LIMIT)


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
                given = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    given.setdefault(name, value)
                host = headers.get("host", "")
                sockets = f"{'wss' if is_encrypted(connection) else 'ws'}://{host}" if ours else ""
                given.setdefault("Content-Security-Policy", PAGE_POLICY.format(sockets=sockets))
                if is_encrypted(connection):
                    given.setdefault("Strict-Transport-Security", ONLY_HTTPS)
                if path.startswith("/api/"):
                    given["Cache-Control"] = "no-store"
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
