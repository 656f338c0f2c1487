"""The live picture is sent on after an error, never from before a page came, and with the news for that page."""

import asyncio
import json
from typing import ClassVar

import pytest
from pydantic import BaseModel
from starlette.websockets import WebSocketState

from app.api.live import picture_sender
from app.api.live.picture_sender import PictureSender, Viewer
from app.api.sockets import CUT_OFF
from app.news import News
from app.texts import Text
from event_loop import in_event_loop


class Shown(BaseModel):
    """A picture."""

    v: float = 0.0


class Titled(BaseModel):
    """A picture with a text."""

    title: Text


class Page:
    """An open page that keeps its messages, and disconnects after some pictures."""

    def __init__(self, pictures: int = 2) -> None:
        self.application_state = WebSocketState.CONNECTED
        self.sent: list[str] = []
        self._pictures = pictures

    async def send_text(self, text: str) -> None:
        self.sent.append(text)
        if len(self.sent) == self._pictures:
            self.application_state = WebSocketState.DISCONNECTED


@in_event_loop
async def test_one_bad_picture_is_not_the_last() -> None:
    turns = iter([Shown(v=0.0), None, Shown(v=1.0)])
    page = Page()

    def picture() -> Shown:
        shown = next(turns)
        if shown is None:
            raise ValueError("no picture")
        return shown

    sender = PictureSender(picture)
    sender.start()
    async with asyncio.timeout(5):
        await sender.serve(Viewer(page))  # type: ignore[arg-type]
    await sender.close()
    assert page.sent == ['{"v":0.0}', '{"v":1.0}']


@in_event_loop
async def test_a_page_that_comes_after_a_pause_gets_no_picture_of_before(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picture_sender, "EVERY", 0.001)
    shown = Shown()
    first, second = Page(), Page()
    sender = PictureSender(shown.model_copy)
    sender.start()
    async with asyncio.timeout(5):
        await sender.serve(Viewer(first))  # type: ignore[arg-type]
        shown.v = 1.0  # while nobody looks
        await sender.serve(Viewer(second))  # type: ignore[arg-type]
    await sender.close()
    assert set(first.sent) == {'{"v":0.0}'}
    assert set(second.sent) == {'{"v":1.0}'}


@in_event_loop
async def test_many_pages_leave_every_turn_of_the_event_loop_to_a_stop(monkeypatch: pytest.MonkeyPatch) -> None:
    """With 200 slow pages beside 20 others a Stop took 102.6 ms (p99), because a picture went to all in one turn."""
    monkeypatch.setattr(picture_sender, "EVERY", 0.001)
    pages = [Page() for _ in range(220)]
    most = 0

    async def watch() -> None:
        nonlocal most
        before = 0
        while True:
            await asyncio.sleep(0)
            sent = sum(len(page.sent) for page in pages)
            most, before = max(most, sent - before), sent

    sender = PictureSender(Shown)
    watching = asyncio.create_task(watch())
    sender.start()
    async with asyncio.timeout(60):
        await asyncio.gather(*(sender.serve(Viewer(page)) for page in pages))  # type: ignore[arg-type]
    watching.cancel()
    await sender.close()
    assert all(len(page.sent) == 2 for page in pages)
    assert most <= 2 * picture_sender.AT_ONCE


@in_event_loop
async def test_a_page_that_takes_no_picture_for_long_is_cut_off(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picture_sender, "EVERY", 0.001)
    monkeypatch.setattr(picture_sender, "SEND_LIMIT", 0.01)
    ended = asyncio.Event()

    class StandsStill(Page):
        scope: ClassVar = {"state": {CUT_OFF: ended.set}}

        async def send_text(self, _text: str) -> None:
            await asyncio.Event().wait()

    sender = PictureSender(Shown)
    sender.start()
    await sender.serve(Viewer(StandsStill()))  # type: ignore[arg-type]
    await sender.close()
    assert ended.is_set()


@in_event_loop
async def test_each_page_gets_the_picture_in_its_language(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picture_sender, "EVERY", 0.001)
    pages = {"en": Page(), "de": Page()}
    sender = PictureSender(lambda: Titled(title=Text("drive-title")))
    sender.start()
    async with asyncio.timeout(5):
        viewers = [Viewer(page, language=language) for language, page in pages.items()]  # type: ignore[arg-type]
        await asyncio.gather(*map(sender.serve, viewers))
    await sender.close()
    assert set(pages["en"].sent) == {'{"title":"Where to?"}'}
    assert set(pages["de"].sent) == {'{"title":"Wohin?"}'}


async def told(page: Page, *news: News, sees: frozenset[int]) -> list[News]:
    """Return the news that a page gets when these wait for it; `sees`: the patients whom it may see."""
    sender = PictureSender(Shown)
    viewer = Viewer(page, sees=sees.__contains__)  # type: ignore[arg-type]
    serving = asyncio.create_task(sender.serve(viewer))
    await asyncio.sleep(0)  # it is a viewer from now on
    for each in news:
        sender.notify(each)
    sender.start()
    async with asyncio.timeout(5):
        await serving
    await sender.close()
    messages = [json.loads(text) for text in page.sent]
    return [News(**message["news"]) for message in messages if "news" in message]


@in_event_loop
async def test_news_comes_in_order_one_with_each_picture_and_equal_ones_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picture_sender, "EVERY", 0.001)
    first, other, shirt = News(what="trial", patient=1), News(what="trial", patient=2), News(what="equipment")
    again = first.model_copy()
    assert await told(Page(5), first, other, again, shirt, other, sees=frozenset({1, 2})) == [first, other, shirt]


@in_event_loop
async def test_a_page_gets_no_news_of_a_patient_whom_it_may_not_see(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(picture_sender, "EVERY", 0.001)
    seen, hidden, shirt = News(what="trial", patient=1), News(what="trial", patient=2), News(what="equipment")
    assert await told(Page(4), hidden, seen, hidden, shirt, sees=frozenset({1})) == [seen, shirt]
    assert await told(Page(4), hidden, seen, shirt, sees=frozenset()) == [shirt]
