"""The patient's screen: paired by a code from the clinician's page, looked after and unpaired there."""

import asyncio
from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter, Depends, Request, Response
from fastapi.concurrency import run_in_threadpool
from pydantic import Field

from app.api.deps import (
    Clinician,
    Db,
    ForEveryone,
    LivePart,
    PairingPart,
    PatientPicturePart,
    PicturesPart,
    RowId,
    SessionFlowPart,
    SettingsPart,
    SignInLimitsPart,
    SocketsPart,
)
from app.api.live.screen_pictures import Picture, ScreenPictures
from app.api.own_address import own_address
from app.api.page_session import ClinicianInSession, any_session
from app.api.parts import parts_for
from app.api.qr import qr_picture
from app.api.sign_in.cookies import read_cookie, set_cookie
from app.api.sign_in.identity import SCREEN_COOKIE
from app.api.sign_in.sign_in_limits import address_of
from app.api.sockets import OpenSockets
from app.news import News
from app.quantities import Document
from app.refusals import Conflict
from app.session.open_session import SessionFlow
from app.session.screen_codes import PairingOffer
from app.settings import Settings
from app.store.access.visible_patients import every_patient
from app.store.database import Database
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
from app.texts import Text

router = APIRouter(prefix="/patient-screen", tags=["patient's screen"])

ONLY_HERE = Text("api-screen-only-here")


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
    """A link that pairs a screen, or a phone as a sensor."""

    code: str
    url: str
    qr: str
    expires: str
    message: Text | str


class Code(Document):
    """The code of a link."""

    code: Annotated[str, Field(min_length=1, max_length=200)]


class ScreenStateView(Document):
    """The state of the browser that asks: paired, over (the session has ended), unpaired, or none of these."""

    state: ScreenState


@dataclass(frozen=True, slots=True)
class PatientScreens:
    """The patient's screens of the open session."""

    database: Database
    sockets: OpenSockets
    session_flow: SessionFlow
    pictures: ScreenPictures

    async def view(self) -> ScreensView:
        """Return the screens, and what they show; Conflict without a session."""
        session = await self.session_flow.needed_session()
        connected, shown_now = self.sockets.screens(), self.pictures.patients()

        def read() -> ScreensView:
            with self.database.reading() as db:
                shown = [
                    ScreenView(
                        id=screen.id,
                        number=screen.number,
                        paired=screen.paired.isoformat(),
                        connected=screen.id in connected,
                        picture=shown_now.get(screen.id),
                    )
                    for screen in screens_of(db, session.id)
                ]
                return ScreensView(screens=shown, settings=screen_settings_of(db, session.id))

        return await run_in_threadpool(read)


PairedScreens = Annotated[PatientScreens, Depends(parts_for(PatientScreens))]


@router.get("")
async def read_screens(_person: Clinician, paired: PairedScreens) -> ScreensView:
    """Return the screens of this session; none without a session."""
    try:
        return await paired.view()
    except Conflict:
        return ScreensView(screens=[], settings=ScreenSettings())


@router.post("/pairing", status_code=201)
async def offer(
    request: Request,
    person: ClinicianInSession,
    settings: SettingsPart,
    session_flow: SessionFlowPart,
    pairing: PairingPart,
) -> OfferView:
    """Make a link that pairs one screen within ten minutes; the link before becomes invalid.

    `message`: when only this machine can open the link.
    """
    session: PatientSession = await session_flow.needed_session()
    return await offer_view(settings, request, pairing.offer(session.id, person.name), "patient.html")


async def offer_view(settings: Settings, request: Request, offered: PairingOffer, page: str) -> OfferView:
    """Return the link by which a device opens `page` with a code, as a QR code, too."""
    address = await asyncio.to_thread(own_address, settings, request)
    # The part behind # is not sent to a server, so it appears in no log.
    url = f"{address.base}{page}#pair={offered.code}"
    return OfferView(
        code=offered.code,
        url=url,
        qr=qr_picture(url),
        expires=offered.expires.isoformat(),
        message=_hint(settings, only_here=address.only_here),
    )


def _hint(settings: Settings, *, only_here: bool) -> Text | str:
    network = settings.network
    if network is None:
        return ONLY_HERE if only_here else ""
    return network.certificate_hint


@router.post("/pair", dependencies=[ForEveryone])
@any_session("The code was made for one session; the patient's screen shows no other.")
async def pair(
    body: Code,
    request: Request,
    response: Response,
    database: Db,
    sign_in_limits: SignInLimitsPart,
    sockets: SocketsPart,
    live: LivePart,
    pairing: PairingPart,
) -> ScreenStateView:
    """Pair the browser that asks with the session for which the code was made.

    Without sign-in: the cookie `bodydrive_screen` while the session lasts, at most 12 h.
    """
    attempt = await sign_in_limits.code(address_of(request))
    offered = pairing.redeem(body.code)
    attempt.take_back()

    def _pair() -> str:
        with every_patient(), database.transaction() as db:
            return add_screen(db, offered.session_id, offered.person, read_cookie(request, SCREEN_COOKIE))

    token = await run_in_threadpool(_pair)
    set_cookie(request, response, SCREEN_COOKIE, token, max_age=int(PAIRED_FOR.total_seconds()))
    await sockets.close_ended_screens()
    live.notify(News(what="screens"))
    return ScreenStateView(state="paired")


@router.get("/me", dependencies=[ForEveryone])
def who_am_i(request: Request, database: Db) -> ScreenStateView:
    """Tell a page how its pairing stands.

    Without sign-in.
    """
    with every_patient(), database.reading() as db:
        return ScreenStateView(state=find_screen(db, read_cookie(request, SCREEN_COOKIE) or "")[1])


@router.post("/settings")
async def choose(
    body: ScreenSettings,
    _person: ClinicianInSession,
    paired: PairedScreens,
    database: Db,
    session_flow: SessionFlowPart,
    live: LivePart,
    patient_picture: PatientPicturePart,
) -> ScreensView:
    """Choose what the screens of this session show; stored until the session ends."""
    session = await session_flow.needed_session()

    def _write() -> None:
        with database.transaction() as db:
            set_screen_settings(db, session.id, body)

    await run_in_threadpool(_write)
    patient_picture.settings = body
    live.notify(News(what="screens"))
    return await paired.view()


@router.delete("/{screen_id}")
async def unpair(
    screen_id: RowId,
    person: ClinicianInSession,
    paired: PairedScreens,
    database: Db,
    sockets: SocketsPart,
    pictures: PicturesPart,
    live: LivePart,
) -> ScreensView:
    """Unpair a screen; what it had opened is closed."""

    def _unpair() -> None:
        with database.transaction(closing=True) as db:
            unpair_screen(db, screen_id, person.name)

    await run_in_threadpool(_unpair)
    pictures.unpair(screen_id)
    await sockets.close_ended_screens()
    live.notify(News(what="screens"))
    return await paired.view()
