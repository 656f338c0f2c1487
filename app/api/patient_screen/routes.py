"""The patient's screen: paired by a code from the clinician's page, looked after and unpaired there."""

import asyncio
from typing import Annotated

from fastapi import APIRouter, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app.api.deps import Clinician, ForEveryone, People, PeopleParts, RowId
from app.api.live.screen_pictures import Picture
from app.api.own_address import own_address
from app.api.parts import Web, WebParts
from app.api.qr import qr_picture
from app.api.sign_in.cookies import read_cookie, set_cookie
from app.api.sign_in.identity import SCREEN_COOKIE, SignedInPerson
from app.api.sign_in.sign_in_limits import address_of
from app.quantities import Document
from app.refusals import Conflict
from app.store.patient_screens import (
    PAIRED_FOR,
    ScreenSettings,
    ScreenState,
    add_screen,
    find_screen,
    screen_settings_of,
    screens_of,
    set_screen_settings,
    unpair_screen,
)
from app.store.tables import PatientSession

router = APIRouter(prefix="/patient-screen", tags=["patient's screen"])

ONLY_HERE = (
    "Only this machine can open the link, because the program serves no other. For a screen of its own, end the "
    "program and start it with bodydrive serve --lan."
)


class ScreenView(Document):
    """A paired screen."""

    id: int
    number: int
    paired: str
    connected: bool
    picture: Picture | None  # what it shows to drive by; None: not reported


class ScreensView(Document):
    """The screens of this session, and what they show."""

    screens: list[ScreenView]
    settings: ScreenSettings


class OfferView(Document):
    """A link that pairs a screen."""

    code: str
    url: str
    qr: str
    expires: str
    words: str


class Code(Document):
    """The code of a link."""

    code: Annotated[str, Field(min_length=1, max_length=200)]


class ScreenStateView(Document):
    """The state of the browser that asks: paired, over (the session has ended), unpaired, or none of these."""

    state: ScreenState


async def _view(parts: People, web: WebParts, who: SignedInPerson) -> ScreensView:
    session = await web.session.needed_session(who.clinic_id)
    connected, pictures = parts.sockets.screens(), web.pictures.patients()

    def _read() -> ScreensView:
        with parts.database.transaction() as db:
            shown = [
                ScreenView(
                    id=screen.id,
                    number=screen.number,
                    paired=screen.paired.isoformat(),
                    connected=screen.id in connected,
                    picture=pictures.get(screen.id),
                )
                for screen in screens_of(db, session.id)
            ]
            return ScreensView(screens=shown, settings=screen_settings_of(db, session.id))

    return await run_in_threadpool(_read)


@router.get("")
async def look(who: Clinician, parts: PeopleParts, web: Web) -> ScreensView:
    """Return the screens of this session; none without a session."""
    try:
        return await _view(parts, web, who)
    except Conflict:
        return ScreensView(screens=[], settings=ScreenSettings())


@router.post("/pairing", status_code=201)
async def offer(request: Request, who: Clinician, parts: PeopleParts, web: Web) -> OfferView:
    """Make a link that pairs one screen within ten minutes; the link before becomes invalid.

    `words`: when only this machine can open the link.
    """
    session: PatientSession = await web.session.needed_session(who.clinic_id)
    made = web.pairing.offer(session.id, who.name)
    address = await asyncio.to_thread(own_address, parts.settings, request)
    # The part behind # is not sent to a server, so it appears in no log.
    url = f"{address.base}patient.html#pair={made.code}"
    return OfferView(
        code=made.code,
        url=url,
        qr=qr_picture(url),
        expires=made.expires.isoformat(),
        words=_words(parts, only_here=address.only_here),
    )


def _words(parts: People, *, only_here: bool) -> str:
    network = parts.settings.network
    if network is None:
        return ONLY_HERE if only_here else ""
    return network.first_words


@router.post("/pair", dependencies=[ForEveryone])
async def pair(body: Code, request: Request, response: Response, parts: PeopleParts, web: Web) -> ScreenStateView:
    """Pair the browser that asks with the session for which the code was made.

    Without sign-in: the cookie `bodydrive_screen` while the session lasts, at most 12 h.
    """
    attempt = await parts.limits.code(address_of(request))
    offered = web.pairing.redeem(body.code)
    attempt.take_back()

    def _pair() -> str:
        with parts.database.transaction() as db:
            return add_screen(db, offered.session_id, offered.person, read_cookie(request, SCREEN_COOKIE))

    token = await run_in_threadpool(_pair)
    set_cookie(request, response, SCREEN_COOKIE, token, max_age=int(PAIRED_FOR.total_seconds()))
    await parts.sockets.close_ended_screens()
    web.live.tell("screens")
    return ScreenStateView(state="paired")


@router.get("/me", dependencies=[ForEveryone])
def who_am_i(request: Request, parts: PeopleParts) -> ScreenStateView:
    """Tell a page how its pairing stands.

    Without sign-in.
    """
    with parts.database.transaction() as db:
        return ScreenStateView(state=find_screen(db, read_cookie(request, SCREEN_COOKIE) or "")[1])


@router.post("/settings")
async def choose(body: ScreenSettings, who: Clinician, parts: PeopleParts, web: Web) -> ScreensView:
    """Choose what the screens of this session show; stored until the session ends."""
    session = await web.session.needed_session(who.clinic_id)

    def _write() -> None:
        with parts.database.transaction() as db:
            set_screen_settings(db, session.id, body)

    await run_in_threadpool(_write)
    web.patient.settings = body
    web.live.tell("screens")
    return await _view(parts, web, who)


@router.delete("/{screen_id}")
async def unpair(screen_id: RowId, who: Clinician, parts: PeopleParts, web: Web) -> ScreensView:
    """Unpair a screen; what it had opened is closed."""

    def _unpair() -> None:
        with parts.database.transaction(closing=True) as db:
            unpair_screen(db, who.clinic_id, screen_id, who.name)

    await run_in_threadpool(_unpair)
    web.pictures.unpair(screen_id)
    await parts.sockets.close_ended_screens()
    web.live.tell("screens")
    return await _view(parts, web, who)
