"""Open websockets by the sign-in or the pairing that opened them, so that its end closes them at once."""

import asyncio
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager, suppress
from typing import TypeVar

from fastapi import WebSocket, WebSocketDisconnect

from app.api.origin import host_is_ours, origin_is_ours
from app.api.sign_in.signed_in import PairedScreen, SignedInPerson, find_paired_screen, find_signed_in, find_viewer
from app.settings import Settings
from app.store.database import Database

SIGNED_OUT = 4401  # close code: sign in again
CHECK_EVERY = 2.0  # s: an ended or disabled sign-in is found out within this, a sign-out at once

Who = TypeVar("Who", bound=SignedInPerson | PairedScreen)
Find = Callable[[Database, Mapping[str, str]], Who | None]


class OpenSockets:
    """Who is connected; every websocket route goes through `admit` and `guarded`."""

    def __init__(self, settings: Settings, database: Database) -> None:
        self._settings = settings
        self._database = database
        self._open: dict[WebSocket, SignedInPerson | PairedScreen] = {}

    async def admit(self, websocket: WebSocket) -> SignedInPerson | None:
        """Return who is behind a websocket before it is accepted; None when it was refused (and closed)."""
        return await self._admit(websocket, find_signed_in)

    async def admit_screen(self, websocket: WebSocket) -> PairedScreen | None:
        """Return which screen of the patient is behind a websocket, as `admit` does."""
        return await self._admit(websocket, find_paired_screen)

    async def admit_viewer(self, websocket: WebSocket) -> SignedInPerson | PairedScreen | None:
        """Return who is behind a websocket that shows the patient's picture, as `admit` does."""
        return await self._admit(websocket, find_viewer)

    async def _admit(self, websocket: WebSocket, find: Find[Who]) -> Who | None:
        if host_is_ours(self._settings, websocket.headers) and origin_is_ours(websocket.headers):
            who = await asyncio.to_thread(find, self._database, websocket.cookies)
            if who is not None:
                return who
        await websocket.close(SIGNED_OUT)
        return None

    @asynccontextmanager
    async def guarded(self, websocket: WebSocket, who: SignedInPerson | PairedScreen) -> AsyncIterator[None]:
        """Close the accepted websocket within seconds of the end of the sign-in or pairing, however that ends."""
        self._open[websocket] = who
        watch = asyncio.create_task(self._watch(websocket, who))
        try:
            yield
        finally:
            watch.cancel()
            self._open.pop(websocket, None)

    async def _watch(self, websocket: WebSocket, who: SignedInPerson | PairedScreen) -> None:
        while True:
            await asyncio.sleep(CHECK_EVERY)
            if not await self._still(websocket, who):
                await self._close(websocket)
                return

    async def _still(self, websocket: WebSocket, who: SignedInPerson | PairedScreen) -> bool:
        find: Find[SignedInPerson | PairedScreen] = (
            find_paired_screen if isinstance(who, PairedScreen) else find_signed_in
        )
        return await asyncio.to_thread(find, self._database, websocket.cookies) is not None

    async def close_session(self, session_id: int) -> None:
        """Close every websocket of a sign-in that has ended."""
        for websocket, who in list(self._open.items()):
            if isinstance(who, SignedInPerson) and who.session_id == session_id:
                await self._close(websocket)

    async def close_ended_screens(self) -> None:
        """Close every websocket of a patient's screen that was unpaired or whose session is over."""

        async def close_if_ended(websocket: WebSocket, who: PairedScreen) -> None:
            if not await self._still(websocket, who):
                await self._close(websocket)

        screens = [(socket, who) for socket, who in self._open.items() if isinstance(who, PairedScreen)]
        await asyncio.gather(*(close_if_ended(socket, who) for socket, who in screens))

    def screens(self) -> set[int]:
        """Return which of the patient's screens are connected."""
        return {who.screen_id for who in list(self._open.values()) if isinstance(who, PairedScreen)}

    async def close_all(self) -> None:
        """Close every websocket: the process is about to end."""
        for websocket in list(self._open):
            await self._close(websocket, 1001)

    async def _close(self, websocket: WebSocket, code: int = SIGNED_OUT) -> None:
        # It may have closed by itself in the meantime, be gone, or not answer at all.
        with suppress(RuntimeError, TimeoutError, WebSocketDisconnect):
            await asyncio.wait_for(websocket.close(code), 1.0)
