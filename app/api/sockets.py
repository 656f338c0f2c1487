"""Open websockets by the sign-in that opened them, so that sign-out closes them at once."""

import asyncio
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager, suppress

from fastapi import WebSocket

from app.api.origin import host_is_ours, origin_is_ours
from app.api.signed_in import SignedIn, find_signed_in
from app.session.database import Database
from app.settings import Settings

SIGNED_OUT = 4401  # close code: sign in again
CHECK_EVERY = 2.0  # s: an ended or disabled sign-in is found out within this, a sign-out at once


class OpenSockets:
    """Who is connected; every websocket route goes through `admit` and `guarded`."""

    def __init__(self, settings: Settings, database: Database) -> None:
        self._settings = settings
        self._database = database
        self._open: dict[WebSocket, SignedIn] = {}

    async def admit(self, websocket: WebSocket) -> SignedIn | None:
        """Return who is behind a websocket before it is accepted; None when it was refused (and closed)."""
        if host_is_ours(self._settings, websocket.headers) and origin_is_ours(websocket.headers):
            who = await asyncio.to_thread(find_signed_in, self._database, websocket.cookies)
            if who is not None:
                return who
        await websocket.close(SIGNED_OUT)
        return None

    @asynccontextmanager
    async def guarded(self, websocket: WebSocket, who: SignedIn) -> AsyncIterator[None]:
        """Close the accepted websocket within seconds of the end of the sign-in, however that ends."""
        self._open[websocket] = who
        watch = asyncio.create_task(self._watch(websocket))
        try:
            yield
        finally:
            watch.cancel()
            self._open.pop(websocket, None)

    async def _watch(self, websocket: WebSocket) -> None:
        while True:
            await asyncio.sleep(CHECK_EVERY)
            if await asyncio.to_thread(find_signed_in, self._database, websocket.cookies) is None:
                await self._close(websocket)
                return

    async def close_session(self, session_id: int) -> None:
        """Close every websocket of a sign-in that has ended."""
        for websocket, who in list(self._open.items()):
            if who.session_id == session_id:
                await self._close(websocket)

    async def close_all(self) -> None:
        """Close every websocket: the process is about to end."""
        for websocket in list(self._open):
            await self._close(websocket, 1001)

    async def _close(self, websocket: WebSocket, code: int = SIGNED_OUT) -> None:
        # It may have closed by itself in the meantime, or not answer at all.
        with suppress(RuntimeError, TimeoutError):
            await asyncio.wait_for(websocket.close(code), 1.0)
