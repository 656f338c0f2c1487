"""The screen socket: a worker of the page reports ten times a second whether the page is in view, and its picture."""

import json
from typing import Annotated

from fastapi import APIRouter, WebSocket
from pydantic import Field, ValidationError
from starlette.websockets import WebSocketDisconnect

from app.api.deps import DrivingScreenPart, PicturesPart, SocketsPart
from app.api.live.screen_pictures import ScreenPicture
from app.api.live.screens import PageSign, Screen
from app.clock import monotonic
from app.quantities import Document, Seconds

router = APIRouter()

MESSAGE_LIMIT = 300  # characters
NOT_TEXT = 1003  # close code
TAKEN = 4409  # close code: another socket reports for this screen

ScreenWord = Annotated[str, Field(min_length=8, max_length=64, pattern=r"^[A-Za-z0-9_-]+$")]


class ScreenMessage(Document):
    """A report of a screen.

    `silence` is the time (s) for which the page's main thread has sent nothing to the worker; `picture` is what the
    page shows to drive by, "late" when it is too old for that; None: not reported.
    """

    screen: ScreenWord
    visible: bool
    silence: Seconds
    picture: ScreenPicture | None = None


@router.websocket("/screen")
async def screen_socket(
    websocket: WebSocket, sockets: SocketsPart, pictures: PicturesPart, driving_screen: DrivingScreenPart
) -> None:
    """Receive the reports of one screen; when they end, the chair that was armed from it stops."""
    person = await sockets.admit(websocket)
    if person is None:
        return
    await websocket.accept()
    screen: Screen | None = None
    async with sockets.guarded(websocket, person):
        try:
            while True:
                report = _read(await websocket.receive_text())
                if report is None:
                    continue
                if screen is not None and screen.word != report.screen:
                    driving_screen.lost(screen, websocket)
                screen = Screen(person.person_id, report.screen)
                if not driving_screen.report(screen, PageSign(monotonic(), report.visible, report.silence, websocket)):
                    await websocket.close(TAKEN)
                    return
                if report.picture is not None:
                    pictures.of_screen(screen, report.picture, websocket)
        except (WebSocketDisconnect, RuntimeError):
            pass  # gone, or closed by us
        except KeyError:
            await websocket.close(NOT_TEXT)
        finally:
            pictures.forget(websocket)
            if screen is not None:
                driving_screen.lost(screen, websocket)


def _read(text: str) -> ScreenMessage | None:
    """Return the report; None when it cannot be read, which counts as no report."""
    if len(text) > MESSAGE_LIMIT:
        return None
    try:
        return ScreenMessage.model_validate(json.loads(text))
    except (ValidationError, ValueError, RecursionError):
        return None
