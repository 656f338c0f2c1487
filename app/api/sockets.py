"""The open websockets, each with the sign-in or pairing that opened it, whose end closes it at once."""

import asyncio
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager, suppress
from typing import TypeVar

from fastapi import WebSocket, WebSocketDisconnect

from app.api.origin import host_is_ours, origin_is_ours
from app.api.sign_in.identity import PairedScreen, SignedInPerson, find_paired_screen, find_signed_in, find_viewer
from app.settings import Settings
from app.store.database import Database

SIGNED_OUT = 4401  # close code: sign in again
CHECK_EVERY = 2.0  # s until the end of a sign-in is noticed; a sign-out closes at once

Who = TypeVar("Who", bound=SignedInPerson | PairedScreen)
Find = Callable[[Database, Mapping[str, str]], Who | None]


class OpenSockets:
    """Admits and keeps the open websockets; every websocket route uses `admit` and `guarded`."""

    def __init__(self, settings: Settings, database: Database) -> None:
        self._settings = settings
        self._database = database
        self._open: dict[WebSocket, SignedInPerson | PairedScreen] = {}

    async def admit(self, websocket: WebSocket) -> SignedInPerson | None:
        """Return the person who opens a websocket, before it is accepted; None when it was refused and closed."""
        return await self._admit(websocket, find_signed_in)

    async def admit_screen(self, websocket: WebSocket) -> PairedScreen | None:
        """Return the patient's screen that opens a websocket; None when it was refused and closed."""
        return await self._admit(websocket, find_paired_screen)

    async def admit_viewer(self, websocket: WebSocket) -> SignedInPerson | PairedScreen | None:
        """Return who opens a websocket that shows the patient's picture; None when it was refused and closed."""
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
        """Close the accepted websocket within CHECK_EVERY of the end of the sign-in or pairing, however it ends."""
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
            if not await self._is_valid(websocket, who):
                await self._close(websocket)
                return

    async def _is_valid(self, websocket: WebSocket, who: SignedInPerson | PairedScreen) -> bool:
        find: Find[SignedInPerson | PairedScreen] = (
            find_paired_screen if isinstance(who, PairedScreen) else find_signed_in
        )
        return await asyncio.to_thread(find, self._database, websocket.cookies) is not None

    async def close_sign_in(self, sign_in_id: int) -> None:
        """Close every websocket of a sign-in that has ended."""
        for websocket, who in list(self._open.items()):
            if isinstance(who, SignedInPerson) and who.sign_in_id == sign_in_id:
                await self._close(websocket)

    async def close_ended_screens(self) -> None:
        """Close every websocket of a patient's screen that was unpaired or whose session has ended."""

        async def close_if_ended(websocket: WebSocket, who: PairedScreen) -> None:
            if not await self._is_valid(websocket, who):
                await self._close(websocket)

        screens = [(socket, who) for socket, who in self._open.items() if isinstance(who, PairedScreen)]
        await asyncio.gather(*(close_if_ended(socket, who) for socket, who in screens))

    def screens(self) -> set[int]:
        """Return the ids of the patient's screens that are connected."""
        return {who.screen_id for who in list(self._open.values()) if isinstance(who, PairedScreen)}

    async def close_all(self) -> None:
        """Close every websocket: the process is about to end."""
        for websocket in list(self._open):
            await self._close(websocket, 1001)

    async def _close(self, websocket: WebSocket, code: int = SIGNED_OUT) -> None:
        # The websocket may be closed already, or its browser may not answer.
        with suppress(RuntimeError, TimeoutError, WebSocketDisconnect):
            await asyncio.wait_for(websocket.close(code), 1.0)
