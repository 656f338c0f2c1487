"""The live picture is sent on after an error, and never from before a page came."""

import asyncio
from typing import Any

import pytest
from starlette.websockets import WebSocketState

from app.api.live import hub as hub_module
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


def test_a_page_that_comes_after_a_pause_gets_no_picture_of_before(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(hub_module, "EVERY", 0.001)
    shown = {"v": 0.0}
    first, second = Page(), Page()

    async def story() -> None:
        hub = LiveHub(shown.copy, dict)
        hub.start()
        async with asyncio.timeout(5):
            await hub.serve(Viewer(first))  # type: ignore[arg-type]
            shown["v"] = 1.0  # while nobody looks
            await hub.serve(Viewer(second))  # type: ignore[arg-type]
        await hub.close()

    asyncio.run(story())
    assert set(first.sent) == {'{"v":0.0}'}
    assert set(second.sent) == {'{"v":1.0}'}
