"""The screen socket: a worker of the page says ten times a second if the page is in view, alive, and what it shows."""

import json
from typing import Annotated

from fastapi import APIRouter, WebSocket
from pydantic import Field, ValidationError
from starlette.websockets import WebSocketDisconnect

from app.api.live.pictures import Picture
from app.api.live.screens import PageSign, Screen
from app.api.parts import WebParts
from app.clock import monotonic
from app.quantities import Document, Seconds

router = APIRouter()

MESSAGE_LIMIT = 300  # characters
NOT_TEXT = 1003  # close code
TAKEN = 4409  # close code: another socket speaks for this screen

ScreenWord = Annotated[str, Field(min_length=8, max_length=64, pattern=r"^[A-Za-z0-9_-]+$")]


class ScreenMessage(Document):
    """What a screen says.

    `silence` is for how long (s) the page's own thread has said nothing to the worker; `picture` is what the page shows
    to drive by, None: it does not say.
    """

    screen: ScreenWord
    visible: bool
    silence: Seconds
    picture: Picture | None = None


@router.websocket("/screen")
async def screen_socket(websocket: WebSocket) -> None:
    """Take the signs of one screen; the chair that it armed stops when they end."""
    sockets = websocket.app.state.people.sockets
    who = await sockets.admit(websocket)
    if who is None:
        return
    await websocket.accept()
    web: WebParts = websocket.app.state.web
    screen: Screen | None = None
    async with sockets.guarded(websocket, who):
        try:
            while True:
                said = _read(await websocket.receive_text())
                if said is None:
                    continue
                if screen is not None and screen.word != said.screen:
                    web.lost(screen, websocket)
                screen = Screen(who.person_id, said.screen)
                if not web.take_sign(screen, PageSign(monotonic(), said.visible, said.silence, websocket)):
                    await websocket.close(TAKEN)
                    return
                if said.picture is not None:
                    web.pictures.of_screen(screen, said.picture, websocket)
        except (WebSocketDisconnect, RuntimeError):
            pass  # gone, or closed by us
        except KeyError:
            await websocket.close(NOT_TEXT)
        finally:
            web.pictures.forget(websocket)
            if screen is not None:
                web.lost(screen, websocket)


def _read(text: str) -> ScreenMessage | None:
    """Return what was said; None for what cannot be read, which is as good as silence."""
    if len(text) > MESSAGE_LIMIT:
        return None
    try:
        return ScreenMessage.model_validate(json.loads(text))
    except (ValidationError, ValueError, RecursionError):
        return None
