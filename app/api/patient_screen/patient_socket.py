"""The live websocket of the patient's screen: sends the newest moment, receives the kind of picture on that screen."""

import asyncio
from collections.abc import Mapping
from typing import Any

from fastapi import APIRouter, WebSocket
from fastapi.concurrency import run_in_threadpool
from pydantic import ValidationError

from app.api.computer.graphics import Graphics, PicturesPerSecond
from app.api.deps import Db, GraphicsPart, LivePart, PatientLivePart, PatientPicturePart, PicturesPart, SocketsPart
from app.api.live.live_picture import ClinicLive
from app.api.live.picture_sender import Viewer
from app.api.live.screen_pictures import Picture, ScreenPictures
from app.api.sockets import cut_off
from app.clock import monotonic
from app.news import News
from app.quantities import Document
from app.store.access.visible_patients import every_patient
from app.store.patient_screens import screen_settings_of
from app.texts import Text

router = APIRouter()

FLOOD = 40  # messages within ...
WITHIN = 10.0  # s; our page sends one each second, and one when its picture changes
PATIENT_SCREEN_SILENCE = 3.0  # s without a report, after which the screen counts as lost: it shows no current picture
MESSAGE_LIMIT = 300  # characters
TOO_MANY_MESSAGES = 1008  # close code: our own page never sends so many


class PictureReport(Document):
    """The picture that the patient's screen shows to drive by, or how many a second it draws when that was asked."""

    picture: Picture | None = None
    pictures: PicturesPerSecond | None = None


@router.websocket("/patient/live")
async def patient_live(
    websocket: WebSocket,
    database: Db,
    sockets: SocketsPart,
    pictures: PicturesPart,
    live: LivePart,
    patient_picture: PatientPicturePart,
    patient_hub: PatientLivePart,
    graphics: GraphicsPart,
) -> None:
    """Send the picture 20 times a second, and receive the screen's reports."""
    screen = await sockets.admit_screen(websocket)
    if screen is None:
        return
    session_id = screen.session_id

    def _read() -> None:
        with every_patient(), database.reading() as db:
            patient_picture.settings = screen_settings_of(db, session_id)

    await run_in_threadpool(_read)
    await websocket.accept()
    viewer = Viewer(websocket)
    async with sockets.guarded(websocket, screen):
        graphics.opened(websocket, Text("api-patients-screen"))
        live.notify(News(what="screens"))
        sending = asyncio.create_task(patient_hub.serve(viewer))
        try:
            await _receive(websocket, screen.screen_id, pictures, live, graphics)
        except RuntimeError:
            pass  # closed by us
        finally:
            patient_hub.forget(viewer)
            pictures.forget(websocket)
            graphics.forget(websocket)
            sending.cancel()
            await asyncio.gather(sending, return_exceptions=True)
    live.notify(News(what="screens"))


async def _receive(
    websocket: WebSocket, screen_id: int, pictures: ScreenPictures, live: ClinicLive, graphics: Graphics
) -> None:
    """Receive picture reports until the page leaves, or has sent more than `FLOOD` messages within 10 s.

    A page that has reported once must go on: after `PATIENT_SCREEN_SILENCE` its connection is cut off, which halts the
    trial. A page that the browser has put aside keeps its socket open, and shows nothing.
    """
    count, since = 0, monotonic()
    limit: float | None = None
    while True:
        try:
            async with asyncio.timeout(limit):
                message = await websocket.receive()
        except TimeoutError:
            cut_off(websocket)
            return
        if message["type"] == "websocket.disconnect":
            return
        if monotonic() - since > WITHIN:
            count, since = 0, monotonic()
        count += 1
        if count > FLOOD:
            await websocket.close(TOO_MANY_MESSAGES)
            return
        report = _read(message)
        if report is None:
            continue
        if report.pictures is not None:
            graphics.set_rate(websocket, report.pictures)
        if report.picture is None:
            continue
        limit = PATIENT_SCREEN_SILENCE
        if pictures.of_patient(screen_id, report.picture, websocket):
            live.notify(News(what="screens"))


def _read(message: Mapping[str, Any]) -> PictureReport | None:
    """Return the report; None for a message that cannot be read, which changes nothing."""
    text = message.get("text")
    if text is None or len(text) > MESSAGE_LIMIT:
        return None
    try:
        return PictureReport.model_validate_json(text)
    except ValidationError:
        return None
