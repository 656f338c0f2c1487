"""The open websockets, each with the sign-in or pairing that opened it, whose end closes it at once."""

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager, suppress
from typing import TypeVar

from fastapi import WebSocket, WebSocketDisconnect
from starlette.requests import HTTPConnection

from app.api.origin import host_is_ours, origin_is_ours
from app.api.sign_in.identity import PairedScreen, SignedInPerson, find_paired_screen, find_sign_in, find_viewer
from app.settings import Settings
from app.store.database import Database

SIGNED_OUT = 4401  # close code: sign in again
NOT_VISIBLE = 4409  # close code: there is nothing to see for this person at the moment
CHECK_EVERY = 2.0  # s until the end of a sign-in is noticed; a sign-out closes at once

Who = TypeVar("Who", bound=SignedInPerson | PairedScreen)
Find = Callable[[Database, HTTPConnection], Who | None]
Sees = Callable[[SignedInPerson | PairedScreen], bool]
"""Returns whether somebody may see what a websocket shows, which may change while it is open."""
Busy = Callable[[], bool]


class OpenSockets:
    """Admits and keeps the open websockets; every websocket route uses `admit` and `guarded`."""

    def __init__(self, settings: Settings, database: Database, busy: Busy = lambda: False) -> None:
        """`busy` returns whether a chair is armed or something is recorded: then nobody here is idle."""
        self._settings = settings
        self._database = database
        self._busy = busy
        self._open: dict[WebSocket, SignedInPerson | PairedScreen] = {}

    async def admit(self, websocket: WebSocket) -> SignedInPerson | None:
        """Return the person who opens a websocket, before it is accepted; None when it was refused and closed.

        The person's sign-in may be locked: what the websocket shows must ask `may_see`.
        """
        return await self._admit(websocket, find_sign_in)

    async def admit_screen(self, websocket: WebSocket) -> PairedScreen | None:
        """Return the patient's screen that opens a websocket; None when it was refused and closed."""
        return await self._admit(websocket, find_paired_screen)

    async def admit_viewer(self, websocket: WebSocket) -> SignedInPerson | PairedScreen | None:
        """Return who opens a websocket that shows the patient's picture; None when it was refused and closed."""
        return await self._admit(websocket, find_viewer)

    async def _admit(self, websocket: WebSocket, find: Find[Who]) -> Who | None:
        if host_is_ours(self._settings, websocket.headers) and origin_is_ours(websocket):
            who = await asyncio.to_thread(find, self._database, websocket)
            if who is not None:
                return who
        await websocket.close(SIGNED_OUT)
        return None

    @asynccontextmanager
    async def guarded(
        self, websocket: WebSocket, who: SignedInPerson | PairedScreen, sees: Sees = lambda _who: True
    ) -> AsyncIterator[None]:
        """Close the accepted websocket within CHECK_EVERY of the end of the sign-in or pairing, however it ends.

        It is closed, too, when the person may no longer see (`sees`) what it shows.
        """
        self._open[websocket] = who
        watch = asyncio.create_task(self._watch(websocket, sees))
        try:
            yield
        finally:
            watch.cancel()
            self._open.pop(websocket, None)

    async def _watch(self, websocket: WebSocket, sees: Sees) -> None:
        while True:
            await asyncio.sleep(CHECK_EVERY)
            code = await self._check(websocket, sees)
            if code is not None:
                await self._close(websocket, code)
                return

    async def _check(self, websocket: WebSocket, sees: Sees) -> int | None:
        """Find anew who opened a websocket; return the code to close it with, None when it stays open."""
        who = await self._find_again(websocket)
        if who is None:
            return SIGNED_OUT
        self._open[websocket] = who
        return None if sees(who) else NOT_VISIBLE

    async def _find_again(self, websocket: WebSocket) -> SignedInPerson | PairedScreen | None:
        if isinstance(self._open[websocket], PairedScreen):
            return await asyncio.to_thread(find_paired_screen, self._database, websocket)
        return await asyncio.to_thread(find_sign_in, self._database, websocket, acts=self._busy())

    def may_see(self, websocket: WebSocket, patient_id: int | None) -> bool:
        """Return whether who opened a websocket may see this patient now."""
        who = self._open.get(websocket)
        return who is not None and who.sees(patient_id)

    def is_locked(self, websocket: WebSocket) -> bool:
        """Return whether the sign-in that opened a websocket is locked."""
        who = self._open.get(websocket)
        return isinstance(who, SignedInPerson) and who.locked

    def may_drive(self, websocket: WebSocket) -> bool:
        """Return whether who opened a websocket may change what drives now."""
        who = self._open.get(websocket)
        return isinstance(who, SignedInPerson) and who.drives

    async def acted(self, websocket: WebSocket) -> None:
        """Store that the person at the page of a websocket does something."""
        await asyncio.to_thread(find_sign_in, self._database, websocket, acts=True)

    async def close_person(self, person_id: int, but: int | None = None) -> None:
        """Close every websocket of a person whose sign-ins have ended, all but the sign-in with the id `but`."""
        for websocket, who in list(self._open.items()):
            if isinstance(who, SignedInPerson) and who.person_id == person_id and who.sign_in_id != but:
                await self._close(websocket)

    async def look_again(self, sign_in_id: int) -> None:
        """Find anew who opened the websockets of a sign-in: it was unlocked."""
        for websocket, who in list(self._open.items()):
            if isinstance(who, SignedInPerson) and who.sign_in_id == sign_in_id:
                await self._check(websocket, lambda _who: True)

    async def close_sign_in(self, sign_in_id: int) -> None:
        """Close every websocket of a sign-in that has ended."""
        for websocket, who in list(self._open.items()):
            if isinstance(who, SignedInPerson) and who.sign_in_id == sign_in_id:
                await self._close(websocket)

    async def close_ended_screens(self) -> None:
        """Close every websocket of a patient's screen that was unpaired or whose session has ended."""

        async def close_if_ended(websocket: WebSocket) -> None:
            if await self._find_again(websocket) is None:
                await self._close(websocket)

        screens = [socket for socket, who in self._open.items() if isinstance(who, PairedScreen)]
        await asyncio.gather(*(close_if_ended(socket) for socket in screens))

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
