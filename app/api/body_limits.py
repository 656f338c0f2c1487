"""How large the body of a request may be, how long it may take, and how many large ones are read at once.

Who may send a large body is decided before it is read, because the framework reads a form, onto the disk from 1 MB on,
before it asks who sends it.
"""

import asyncio
import math
from collections.abc import Callable
from typing import Final

from fastapi import HTTPException
from starlette.requests import HTTPConnection
from starlette.types import Message, Receive

from app.api.deps import anyone_signed_in, clinician
from app.api.parts import parts_of
from app.api.routes.signal_uploads import MOST_SIGNAL_BYTES
from app.api.sign_in.identity import find_sign_in
from app.clock import monotonic
from app.scene.models.objects import MOST_BYTES as MOST_OBJECT_BYTES
from app.store.database import Database
from app.texts import Text
from app.world.floorplan import MAX_BYTES
from app.world.imports.file_limits import MOST_PLAN_BYTES

SMALL = 64_000  # bytes: whatever a page sends but files, floor plans and controls; anybody may send so much
BODY_LIMIT = 2_000_000  # bytes
FORM = 1_000_000  # bytes of a form (multipart) around its files
# Bytes by the beginning of the path. docs/proxy/ passes on what is allowed here.
LIMITS: Final = {
    "/api/v1/equipment/files": MOST_SIGNAL_BYTES + FORM,
    "/api/v1/floorplans/import": 2 * MOST_PLAN_BYTES + FORM,  # a ROS map and its image
    "/api/v1/floorplans": MAX_BYTES,  # the document itself
    "/api/v1/models": MOST_OBJECT_BYTES + FORM,
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
