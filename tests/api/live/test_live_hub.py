"""The live picture is sent on after an error."""

import asyncio
from typing import Any

from starlette.websockets import WebSocketState

from app.api.live.hub import LiveHub, Viewer


class Page:
    """An open page that keeps its messages, and disconnects after the second picture."""

    def __init__(self) -> None:
        self.application_state = WebSocketState.CONNECTED
        self.sent: list[str] = []

    async def send_text(self, text: str) -> None:
        self.sent.append(text)
        if len(self.sent) == 2:
            self.application_state = WebSocketState.DISCONNECTED


def test_one_bad_picture_is_not_the_last() -> None:
    turns = iter([{"v": 0.0}, {"v": float("nan")}, {"v": 1.0}])
    page = Page()

    def picture() -> dict[str, Any]:
        return next(turns)

    async def story() -> None:
        hub = LiveHub(picture, dict)
        hub.start()
        async with asyncio.timeout(5):
            await hub.serve(Viewer(page))  # type: ignore[arg-type]
        await hub.close()

    asyncio.run(story())
    assert page.sent == ['{"v":0.0}', '{"v":1.0}']
