"""The live websocket: the newest tick down, the visitor's movement and Stop up."""

import asyncio
import json
from typing import Annotated

from fastapi import APIRouter, WebSocket
from pydantic import Field, ValidationError
from starlette.websockets import WebSocketDisconnect

from app.api.live.hub import Viewer
from app.api.parts import WebParts
from app.layout import MAX_JOINTS
from app.quantities import Document, Fraction, Name, Radians

router = APIRouter()

MESSAGE_LIMIT = 4096  # characters
NOT_TEXT = 1003  # close code: our pages send text only


class HeadDirection(Document):
    """Where a tablet looks."""

    yaw: Radians
    pitch: Radians
    roll: Radians


class PageMessage(Document):
    """What a page says: where the visitor moves, where a tablet looks, or Stop."""

    move: Annotated[dict[Name, Fraction], Field(max_length=MAX_JOINTS)] | None = None
    look: HeadDirection | None = None
    stop: bool = False


@router.websocket("/live")
async def live(websocket: WebSocket) -> None:
    """Show the newest tick 20 times a second, and take the visitor's movements."""
    sockets = websocket.app.state.people.sockets
    who = await sockets.admit(websocket)
    if who is None:
        return
    await websocket.accept()
    web: WebParts = websocket.app.state.web
    viewer = Viewer(websocket)
    async with sockets.guarded(websocket, who):
        sending = asyncio.create_task(web.live.serve(viewer))
        try:
            while True:
                await _take(await websocket.receive_text(), web)
        except (WebSocketDisconnect, RuntimeError):
            pass  # gone, or closed by us: in both cases the page comes back by itself
        except KeyError:
            await websocket.close(NOT_TEXT)  # left open, it would show nothing for ever
        finally:
            web.live.forget(viewer)
            sending.cancel()
            await asyncio.gather(sending, return_exceptions=True)


async def _take(text: str, web: WebParts) -> None:
    """Do what a page asks; what cannot be read is left alone, except that a Stop is looked for first."""
    if len(text) > MESSAGE_LIMIT:
        return
    try:
        said = json.loads(text)
        if isinstance(said, dict) and said.get("stop") is True:
            await web.control.stop()
        message = PageMessage.model_validate(said)
    except (ValidationError, ValueError, RecursionError):
        return
    if message.move is not None:
        web.control.move(message.move)
    if message.look is not None:
        web.control.look(message.look.yaw, message.look.pitch, message.look.roll)
