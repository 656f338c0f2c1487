"""The live websocket: sends the live picture, receives Stop and the movement of the simulated body and the tablet."""

import asyncio
import json
import logging
from typing import Annotated, Literal

from fastapi import APIRouter, WebSocket
from pydantic import Field, ValidationError
from starlette.websockets import WebSocketDisconnect

from app.api.computer.graphics import Graphics, PicturesPerSecond
from app.api.deps import ControlPart, Db, GraphicsPart, LivePart, SessionFlowPart, SocketsPart
from app.api.live.picture_sender import Viewer
from app.api.sockets import OpenSockets
from app.layout import MAX_JOINTS
from app.quantities import Document, Fraction, Name, Radians
from app.session.control_link import ControlLink
from app.session.open_session import SessionFlow
from app.store.database import Database
from app.store.log import log_viewing
from app.texts import Text

logger = logging.getLogger("bodydrive")


class LiveViewing:
    """Decides whether a live socket shows the patient who is here, and logs each patient whom it begins to show."""

    def __init__(
        self, database: Database, sockets: OpenSockets, session: SessionFlow, websocket: WebSocket, person: str
    ) -> None:
        self._database = database
        self._sockets = sockets
        self._session = session
        self._websocket = websocket
        self._person = person
        self._shown: int | None = None  # the id of the patient
        self._rows: set[asyncio.Task[None]] = set()

    def may_see(self) -> bool:
        """Return whether the person may see the patient who is here now; called for every picture."""
        patient = self._session.patient_id
        sees = self._sockets.may_see(self._websocket, patient)
        shown = patient if sees else None
        if shown is not None and shown != self._shown:
            # Beside the pictures: the page of a chair that drives must not wait for the database.
            row = asyncio.create_task(asyncio.to_thread(self._log, shown))
            self._rows.add(row)
            row.add_done_callback(self._rows.discard)
        self._shown = shown
        return sees

    def sees(self, patient: int) -> bool:
        """Return whether the person may see a patient now, who need not be here."""
        return self._sockets.may_see(self._websocket, patient)

    async def close(self) -> None:
        """Wait until the last row is written."""
        await asyncio.gather(*self._rows)

    def _log(self, patient: int) -> None:
        try:
            with self._database.transaction(closing=True) as db:
                log_viewing(db, self._person, patient)
        except Exception:  # go on: the page needs the pictures of a chair that may drive
            logger.exception("The viewing of the patient %d by a live socket could not be logged", patient)


router = APIRouter()

MESSAGE_LIMIT = 4096  # characters
NOT_TEXT = 1003  # close code: our pages send text only


class HeadDirection(Document):
    """The direction of a tablet that is used as the head tracker."""

    yaw: Radians
    pitch: Radians
    roll: Radians


class PageMessage(Document):
    """A message of a page: targets of the simulated body's joints, the direction of a tablet, or Stop.

    `by`: whether the button of the page or a key made the stop.
    `acted`: the person has just touched the page or pressed a key; otherwise the sign-in is locked after a while.
    `pictures`: how many pictures a second the page draws, when the news "graphics" asked for it.
    """

    move: Annotated[dict[Name, Fraction], Field(max_length=MAX_JOINTS)] | None = None
    look: HeadDirection | None = None
    stop: bool = False
    by: Literal["tablet", "key"] = "tablet"
    acted: bool = False
    pictures: PicturesPerSecond | None = None


@router.websocket("/live")
async def live(
    websocket: WebSocket,
    database: Db,
    sockets: SocketsPart,
    control: ControlPart,
    session_flow: SessionFlowPart,
    live: LivePart,
    graphics: GraphicsPart,
) -> None:
    """Send the live picture 20 times a second, and carry out the messages of the page."""
    person = await sockets.admit(websocket)
    if person is None:
        return
    await websocket.accept()
    viewing = LiveViewing(database, sockets, session_flow, websocket, person.name)
    viewer = Viewer(websocket, viewing.may_see, viewing.sees)
    async with sockets.guarded(websocket, person):
        graphics.opened(websocket, Text("api-page-of", name=person.name))
        sending = asyncio.create_task(live.serve(viewer))
        try:
            while True:
                await _carry_out(await websocket.receive_text(), websocket, sockets, control, graphics)
        except (WebSocketDisconnect, RuntimeError):
            pass  # disconnected, or closed by us: in both cases the page connects again by itself
        except KeyError:
            await websocket.close(NOT_TEXT)  # otherwise the page would wait for ever
        finally:
            live.forget(viewer)
            graphics.forget(websocket)
            sending.cancel()
            await asyncio.gather(sending, return_exceptions=True)
            await viewing.close()


async def _carry_out(
    text: str, websocket: WebSocket, sockets: OpenSockets, control: ControlLink, graphics: Graphics
) -> None:
    """Carry out a message of a page. An invalid message is ignored, but a Stop in it counts; so on a locked page."""
    if len(text) > MESSAGE_LIMIT:
        return
    try:
        content = json.loads(text)
        if isinstance(content, dict) and content.get("stop") is True:
            await control.stop("key" if content.get("by") == "key" else "tablet")
        message = PageMessage.model_validate(content)
    except (ValidationError, ValueError, RecursionError):
        return
    if message.acted:
        await sockets.acted(websocket)
    if sockets.is_locked(websocket):
        return
    if message.pictures is not None:
        graphics.set_rate(websocket, message.pictures)
    if not sockets.may_drive(websocket):
        return
    if message.move is not None:
        control.move(message.move)
    if message.look is not None:
        control.look(message.look.yaw, message.look.pitch, message.look.roll)
