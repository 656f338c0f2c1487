"""The socket of a phone that is a sensor: it sends how the phone is held.

`app/hardware/shirt/orientation_sensors/phones.py` reads what it sends.
"""

import asyncio
from collections.abc import Callable
from typing import Annotated

from fastapi import APIRouter, Depends, WebSocket

from app.api.deps import ControlPart, EquipmentPart, LivePart, SocketsPart
from app.api.live.page_samples import receive_samples
from app.api.parts import part
from app.api.sockets import close_in_time
from app.news import News
from app.quantities import Document
from app.session.equipment.shirt import Equipment
from app.texts import Text

router = APIRouter()

SAY_EVERY = 0.5  # s: the page says that it is lost when it hears nothing for longer
FLOOD = 200  # messages within a second; our page sends at most 60
ELSEWHERE = 4409  # close code: the phone's page was opened once more
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
    number = phone.number

    def take(sample: bytes, t: float) -> None:
        if equipment.kind == KIND:
            control.add_sample(number, sample, t)

    before = active.take(number, websocket)
    if before is not None:
        await close_in_time(before, ELSEWHERE)
    async with sockets.guarded(websocket, phone):
        live.notify(News(what="phones"))
        telling = asyncio.create_task(_tell(websocket, lambda: _message(number, equipment)))
        try:
            code = await receive_samples(websocket, FLOOD, take)
            if code is not None:
                await websocket.close(code)
        except RuntimeError:
            pass  # closed by us
        finally:
            active.forget(number, websocket)
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
