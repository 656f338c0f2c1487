"""The open websockets, each with the sign-in or pairing that opened it, whose end closes it at once."""

import asyncio
import logging
from collections import defaultdict
from collections.abc import AsyncIterator, Callable, Iterable, Mapping
from contextlib import asynccontextmanager, suppress
from typing import Final, NamedTuple, TypeVar

from fastapi import WebSocket, WebSocketDisconnect
from starlette.requests import HTTPConnection

from app.api.origin import host_is_ours, origin_is_ours
from app.api.sign_in.cookies import read_cookie
from app.api.sign_in.identity import (
    COOKIE,
    PHONE_COOKIE,
    SCREEN_COOKIE,
    PairedPhone,
    PairedScreen,
    SignedInPerson,
    find_paired_screen,
    find_sign_in,
    find_viewer,
)
from app.session.equipment.paired_phones import PairedPhones
from app.settings import Settings
from app.store.database import Database

SIGNED_OUT = 4401  # close code: sign in again
NOT_VISIBLE = 4409  # close code: there is nothing to see for this person at the moment
CHECK_EVERY = 2.0  # s until the end of a sign-in is noticed; a sign-out closes at once
CLOSE_LIMIT = 1.0  # s in which a page has to take the end of its websocket; its connection is cut off afterwards
CUT_OFF = "cut off"  # in the state of a websocket's scope: a function that ends the connection at once

logger = logging.getLogger("bodydrive")

Opener = SignedInPerson | PairedScreen | PairedPhone
"""Who opens a websocket."""
Who = TypeVar("Who")
Find = Callable[[Database, HTTPConnection], Who | None]
Sees = Callable[[Opener], bool]
"""Returns whether somebody may see what a websocket shows, which may change while it is open."""
Busy = Callable[[], bool]


def cut_off(websocket: WebSocket) -> None:
    """End the connection of a websocket without waiting until its page has taken what was sent before."""
    end = websocket.scope.get("state", {}).get(CUT_OFF)
    if end is not None:  # only this program's own web server offers it
        end()


class Guarded(NamedTuple):
    """Who opened a websocket, and whether they may see what it shows."""

    viewer: Opener
    sees: Sees


class OpenSockets:
    """Admits and keeps the open websockets; every websocket route uses `admit` and `guarded`."""

    def __init__(
        self, settings: Settings, database: Database, phones: PairedPhones, busy: Busy = lambda: False
    ) -> None:
        """`busy` returns whether a chair is armed or something is recorded: then nobody here is idle."""
        self._settings = settings
        self._database = database
        self._phones = phones
        self._busy = busy
        self._open: dict[WebSocket, Guarded] = {}
        self._watching: asyncio.Task[None] | None = None  # ends with the last websocket

    async def admit(self, websocket: WebSocket) -> SignedInPerson | None:
        """Return the person who opens a websocket, before it is accepted; None when it was refused and closed.

        The person's sign-in may be locked: what the websocket shows must ask `may_see`.
        """
        return await self._admit(websocket, find_sign_in)

    async def admit_screen(self, websocket: WebSocket) -> PairedScreen | None:
        """Return the patient's screen that opens a websocket; None when it was refused and closed."""
        return await self._admit(websocket, find_paired_screen)

    async def admit_phone(self, websocket: WebSocket) -> PairedPhone | None:
        """Return the phone, paired as a sensor, that opens a websocket; None when it was refused and closed."""
        if host_is_ours(self._settings, websocket.headers) and origin_is_ours(websocket):
            phone = self._phone(websocket)
            if phone is not None:
                return phone
        await websocket.close(SIGNED_OUT)
        return None

    async def admit_viewer(self, websocket: WebSocket) -> SignedInPerson | PairedScreen | None:
        """Return who opens a websocket that shows the patient's picture; None when it was refused and closed."""
        return await self._admit(websocket, find_viewer)

    async def _admit(self, websocket: WebSocket, find: Find[Who]) -> Who | None:
        if host_is_ours(self._settings, websocket.headers) and origin_is_ours(websocket):
            viewer = await asyncio.to_thread(find, self._database, websocket)
            if viewer is not None:
                return viewer
        await websocket.close(SIGNED_OUT)
        return None

    @asynccontextmanager
    async def guarded(
        self, websocket: WebSocket, viewer: Opener, sees: Sees = lambda _viewer: True
    ) -> AsyncIterator[None]:
        """Close the accepted websocket within CHECK_EVERY of the end of the sign-in or pairing, however it ends.

        It is closed, too, when the person may no longer see (`sees`) what it shows.
        """
        self._open[websocket] = Guarded(viewer, sees)
        if self._watching is None or self._watching.done():
            self._watching = asyncio.create_task(self._watch())
        try:
            yield
        finally:
            self._open.pop(websocket, None)

    async def _watch(self) -> None:
        while self._open:
            await asyncio.sleep(CHECK_EVERY)
            try:
                await self._check(list(self._open))
            except Exception:  # go on: the next check may succeed, and without one nobody's end would be noticed
                logger.exception("The sign-ins of the open websockets could not be checked")

    async def _check(self, websockets: Iterable[WebSocket]) -> None:
        """Find anew who opened these websockets, each sign-in or pairing once; close those that may not stay open.

        Each at a time: two hundred look-ups at once, one for each websocket, would hold a Stop up.
        """
        of_cookie = defaultdict[tuple[type, str | None], list[WebSocket]](list)
        for websocket in websockets:
            kind = type(self._open[websocket].viewer)
            cookie = read_cookie(websocket, _COOKIES[kind])
            of_cookie[kind, cookie].append(websocket)
        ending: dict[WebSocket, int] = {}
        for (kind, _), those in of_cookie.items():
            viewer = await self._find_again(kind, those[0])
            for websocket in those:
                if websocket not in self._open:
                    continue  # it ended by itself meanwhile
                if viewer is None:
                    ending[websocket] = SIGNED_OUT
                    continue
                sees = self._open[websocket].sees
                self._open[websocket] = Guarded(viewer, sees)
                if not sees(viewer):
                    ending[websocket] = NOT_VISIBLE
        await self._close(ending)

    def _phone(self, connection: HTTPConnection) -> PairedPhone | None:
        number = self._phones.number_of(read_cookie(connection, PHONE_COOKIE))
        return None if number is None else PairedPhone(number)

    async def _find_again(self, kind: type, websocket: WebSocket) -> Opener | None:
        if kind is PairedPhone:
            return self._phone(websocket)
        if kind is PairedScreen:
            return await asyncio.to_thread(find_paired_screen, self._database, websocket)
        return await asyncio.to_thread(find_sign_in, self._database, websocket, acts=self._busy())

    def may_see(self, websocket: WebSocket, patient_id: int | None) -> bool:
        """Return whether who opened a websocket may see this patient now."""
        opened = self._open.get(websocket)
        return opened is not None and opened.viewer.sees(patient_id)

    def is_locked(self, websocket: WebSocket) -> bool:
        """Return whether the sign-in that opened a websocket is locked."""
        person = self._person(websocket)
        return person is not None and person.locked

    def may_drive(self, websocket: WebSocket) -> bool:
        """Return whether who opened a websocket may change what drives now."""
        person = self._person(websocket)
        return person is not None and person.drives

    def may_be_sensor(self, websocket: WebSocket) -> bool:
        """Return whether a page may be the patient's sensor: that of a person who drives, or the patient's screen."""
        opened = self._open.get(websocket)
        return self.may_drive(websocket) or (opened is not None and isinstance(opened.viewer, PairedScreen))

    async def acted(self, websocket: WebSocket) -> None:
        """Store that the person at the page of a websocket does something."""
        await asyncio.to_thread(find_sign_in, self._database, websocket, acts=True)

    async def close_person(self, person_id: int, but: int | None = None) -> None:
        """Close every websocket of a person whose sign-ins have ended, all but the sign-in with the id `but`."""
        await self._close(self._of(lambda person: person.person_id == person_id and person.sign_in_id != but))

    async def recheck(self, sign_in_id: int) -> None:
        """Find anew who opened the websockets of a sign-in: it was unlocked."""
        await self._check(self._of(lambda person: person.sign_in_id == sign_in_id))

    async def close_sign_in(self, sign_in_id: int) -> None:
        """Close every websocket of a sign-in that has ended."""
        await self._close(self._of(lambda person: person.sign_in_id == sign_in_id))

    async def close_ended_phones(self) -> None:
        """Close every websocket of a phone that was unpaired, or whose number another browser has now."""
        await self._check(
            [websocket for websocket, (viewer, _) in self._open.items() if isinstance(viewer, PairedPhone)]
        )

    def phones(self) -> set[int]:
        """Return the numbers of the phones that are connected."""
        return {viewer.number for viewer, _ in list(self._open.values()) if isinstance(viewer, PairedPhone)}

    async def close_ended_screens(self) -> None:
        """Close every websocket of a patient's screen that was unpaired or whose session has ended."""
        await self._check(
            [websocket for websocket, (viewer, _) in self._open.items() if isinstance(viewer, PairedScreen)]
        )

    def screens(self) -> set[int]:
        """Return the ids of the patient's screens that are connected."""
        return {viewer.screen_id for viewer, _ in list(self._open.values()) if isinstance(viewer, PairedScreen)}

    async def close_all(self) -> None:
        """Close every websocket: the process is about to end."""
        await self._close(dict.fromkeys(self._open, 1001))

    def _person(self, websocket: WebSocket) -> SignedInPerson | None:
        opened = self._open.get(websocket)
        return opened.viewer if opened is not None and isinstance(opened.viewer, SignedInPerson) else None

    def _of(self, wanted: Callable[[SignedInPerson], bool]) -> dict[WebSocket, int]:
        """Return the websockets of some people, each with the code that says that their sign-in has ended."""
        people = ((websocket, self._person(websocket)) for websocket in self._open)
        return {websocket: SIGNED_OUT for websocket, person in people if person is not None and wanted(person)}

    async def _close(self, codes: dict[WebSocket, int]) -> None:
        """Close websockets, each with its code; a page that does not take it ends without it."""
        closing = []
        for websocket, code in codes.items():
            closing.append(asyncio.create_task(close_in_time(websocket, code)))
            await asyncio.sleep(0)  # a Stop waits for no more than one of them
        await asyncio.gather(*closing)


_COOKIES: Final[Mapping[type, str]] = {
    SignedInPerson: COOKIE,
    PairedScreen: SCREEN_COOKIE,
    PairedPhone: PHONE_COOKIE,
}


async def close_in_time(websocket: WebSocket, code: int) -> None:
    """Close a websocket with a code; the connection of a page that does not take it is cut off."""
    try:
        with suppress(RuntimeError, WebSocketDisconnect):  # it is closed already
            await asyncio.wait_for(websocket.close(code), CLOSE_LIMIT)
    except TimeoutError:
        cut_off(websocket)
