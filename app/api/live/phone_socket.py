"""The socket of a phone that is a sensor: it sends how it is held (`app/hardware/shirt/phones.py`)."""

import asyncio
from collections.abc import Callable
from typing import Annotated

from fastapi import APIRouter, Depends, WebSocket

from app.api.deps import ControlPart, EquipmentPart, LivePart, SocketsPart
from app.api.parts import part
from app.clock import monotonic
from app.messages import LONGEST_SAMPLE
from app.news import News
from app.quantities import Document
from app.session.control_link import ControlLink
from app.session.equipment.shirt import Equipment
from app.texts import Text

router = APIRouter()

SAY_EVERY = 0.5  # s: the page says that it is lost when it hears nothing for longer
FLOOD = 200  # messages within a second; our page sends at most 60
NOT_A_SAMPLE = 1003  # close codes
TOO_MANY = 1008
ELSEWHERE = 4409  # the phone's page was opened once more
KIND = "phones"


class PhoneMessage(Document):
    """What a phone that is a sensor is told."""

    number: int
    wanted: bool  # whether the shirt in use is made of phones
    part: Text | str | None  # the part of the body that it is on


class ActivePhones:
    """The socket of each phone: the newest one, for two pages of a phone would be mixed into one sensor."""

    def __init__(self) -> None:
        self._sockets: dict[int, WebSocket] = {}

    def take(self, number: int, websocket: WebSocket) -> WebSocket | None:
        """Make a socket that of a phone, and return the one before."""
        before = self._sockets.get(number)
        self._sockets[number] = websocket
        return before

    def forget(self, number: int, websocket: WebSocket) -> None:
        """A socket has ended."""
        if self._sockets.get(number) is websocket:
            del self._sockets[number]


@router.websocket("/phone")
async def phone_socket(
    websocket: WebSocket,
    sockets: SocketsPart,
    control: ControlPart,
    equipment: EquipmentPart,
    live: LivePart,
    active: Annotated[ActivePhones, Depends(part(ActivePhones))],
) -> None:
    """Receive the samples of one phone, and tell it which part of the body it is on."""
    phone = await sockets.admit_phone(websocket)
    if phone is None:
        return
    await websocket.accept()
    before = active.take(phone.number, websocket)
    if before is not None:
        await _close(before, ELSEWHERE)
    async with sockets.guarded(websocket, phone):
        live.notify(News(what="phones"))
        telling = asyncio.create_task(_tell(websocket, lambda: _message(phone.number, equipment)))
        try:
            code = await _receive(websocket, phone.number, control, equipment)
            if code is not None:
                await websocket.close(code)
        except RuntimeError:
            pass  # closed by us
        finally:
            active.forget(phone.number, websocket)
            telling.cancel()
            await asyncio.gather(telling, return_exceptions=True)
    live.notify(News(what="phones"))


def _message(number: int, equipment: Equipment) -> PhoneMessage:
    wanted = equipment.kind == KIND
    return PhoneMessage(number=number, wanted=wanted, part=equipment.part_of_sensor(str(number)) if wanted else None)


async def _tell(websocket: WebSocket, message: Callable[[], PhoneMessage]) -> None:
    while True:
        await websocket.send_text(message().model_dump_json())
        await asyncio.sleep(SAY_EVERY)


async def _receive(websocket: WebSocket, number: int, control: ControlLink, equipment: Equipment) -> int | None:
    """Pass on samples until the page leaves; return the code with which its socket is closed before, if it is."""
    count, since = 0, monotonic()
    while True:
        message = await websocket.receive()
        if message["type"] == "websocket.disconnect":
            return None
        now = monotonic()
        if now - since > 1.0:
            count, since = 0, now
        count += 1
        sample = message.get("bytes")
        if count > FLOOD:
            return TOO_MANY
        if not sample or len(sample) > LONGEST_SAMPLE:
            return NOT_A_SAMPLE
        if equipment.kind == KIND:
            control.add_sample(number, sample, now)


async def _close(websocket: WebSocket, code: int) -> None:
    try:
        await websocket.close(code)
    except RuntimeError:
        return  # it has ended meanwhile
