"""Phones as sensors: paired by a code from the clinician's page, looked after and unpaired there."""

import asyncio
from typing import Annotated

from fastapi import APIRouter, Path, Request, Response

from app.api.deps import (
    Clinician,
    Db,
    EquipmentPart,
    ForEveryone,
    LivePart,
    PhonesPart,
    SettingsPart,
    SignInLimitsPart,
    SocketsPart,
)
from app.api.page_session import OF_CLINIC, ClinicianInSession, any_session
from app.api.patient_screen.routes import Code, OfferView, offer_view
from app.api.sign_in.cookies import read_cookie, set_cookie
from app.api.sign_in.identity import PHONE_COOKIE
from app.api.sign_in.sign_in_limits import address_of
from app.api.sockets import OpenSockets
from app.hardware.configs import MOST_PHONES
from app.news import News
from app.quantities import Document
from app.session.equipment.paired_phones import PAIRED_FOR_HOURS, PairedPhones
from app.session.equipment.shirt import Equipment
from app.store.database import Database
from app.store.log import write_log
from app.texts import Text

router = APIRouter(prefix="/phones", tags=["phones as sensors"])

PhoneNumber = Annotated[int, Path(ge=1, le=MOST_PHONES)]


class PhoneView(Document):
    """A paired phone."""

    number: int
    paired: str
    connected: bool
    part: Text | str | None  # the part of the body that it is on


class PhonesView(Document):
    """The paired phones."""

    phones: list[PhoneView]


class PhoneStateView(Document):
    """The state of the browser that asks: the number of the phone that it is, null when it is none."""

    number: int | None


def phones_view(phones: PairedPhones, sockets: OpenSockets, equipment: Equipment) -> PhonesView:
    """Return the paired phones."""
    connected = sockets.phones()
    return PhonesView(
        phones=[
            PhoneView(
                number=number,
                paired=since.isoformat(),
                connected=number in connected,
                part=equipment.part_of_sensor(str(number)),
            )
            for number, since in phones.paired().items()
        ]
    )


@router.get("")
async def read_phones(
    _person: Clinician, phones: PhonesPart, sockets: SocketsPart, equipment: EquipmentPart
) -> PhonesView:
    """Return the phones that are paired as sensors."""
    return phones_view(phones, sockets, equipment)


@router.post("/pairing", status_code=201)
async def offer_phone(
    request: Request, person: ClinicianInSession, settings: SettingsPart, phones: PhonesPart
) -> OfferView:
    """Make a link that pairs one phone within ten minutes; the link before becomes invalid.

    `message`: when only this machine can open the link.
    """
    return await offer_view(settings, request, phones.offer(person.name), "phone.html")


@router.post("/pair", dependencies=[ForEveryone])
@any_session(OF_CLINIC)
async def pair_phone(
    body: Code,
    request: Request,
    response: Response,
    database: Db,
    sign_in_limits: SignInLimitsPart,
    phones: PhonesPart,
    sockets: SocketsPart,
    live: LivePart,
) -> PhoneStateView:
    """Pair the browser that asks as a sensor.

    Without sign-in: the cookie `bodydrive_phone` until the program ends, at most 12 h.
    """
    attempt = await sign_in_limits.code(address_of(request))
    number, token, person = phones.pair(body.code, read_cookie(request, PHONE_COOKIE))
    attempt.take_back()
    await _log(database, person, "phone paired", number)
    set_cookie(request, response, PHONE_COOKIE, token, max_age=3600 * PAIRED_FOR_HOURS)
    await sockets.close_ended_phones()
    live.notify(News(what="phones"))
    return PhoneStateView(number=number)


@router.get("/me", dependencies=[ForEveryone])
async def which_phone(request: Request, phones: PhonesPart) -> PhoneStateView:
    """Tell a page which phone it is.

    Without sign-in.
    """
    return PhoneStateView(number=phones.number_of(read_cookie(request, PHONE_COOKIE)))


@router.delete("/{number}")
async def unpair_phone(
    number: PhoneNumber,
    person: ClinicianInSession,
    database: Db,
    phones: PhonesPart,
    sockets: SocketsPart,
    equipment: EquipmentPart,
    live: LivePart,
) -> PhonesView:
    """Unpair a phone; its socket is closed."""
    phones.unpair(number)
    await _log(database, person.name, "phone unpaired", number)
    await sockets.close_ended_phones()
    live.notify(News(what="phones"))
    return phones_view(phones, sockets, equipment)


async def _log(database: Database, person: str, what: str, number: int) -> None:
    def write() -> None:
        with database.transaction() as db:
            write_log(db, person, what, phone=number)

    await asyncio.to_thread(write)
