"""Send the live picture: one message per 50 ms, made once for each language and sent to every open page."""

import asyncio
import json
import logging
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Generic, NamedTuple, TypeVar

from fastapi import WebSocket
from pydantic import BaseModel
from starlette.websockets import WebSocketState

from app.api.sockets import cut_off
from app.clock import monotonic
from app.news import News
from app.texts import current_language, reader_language

EVERY = 0.05  # s
SEND_LIMIT = 3.0  # s: a page that does not take a message within this time is cut off; a slow one takes 16 kB/s
AT_ONCE = 4  # pages that get a picture in one turn of the event loop: a Stop waits for no more of them

logger = logging.getLogger("bodydrive")

Message = TypeVar("Message", bound=BaseModel)


class PictureText(NamedTuple):
    """A picture as JSON."""

    whole: str = ""
    bare: str = ""  # without the patient; empty when nobody needs it


NOTHING = PictureText()


@dataclass(slots=True, eq=False)
class Viewer:
    """One open page; while `may_see` returns False, it gets the picture without a patient."""

    websocket: WebSocket
    may_see: Callable[[], bool] = lambda: True
    sees: Callable[[int], bool] = lambda _patient: True  # whether it may be told of a patient now, by id
    language: str = field(default_factory=current_language)  # of the request that opened the socket
    news: dict[News, None] = field(default_factory=dict)  # that were not sent yet, in order
    fresh: asyncio.Event = field(default_factory=asyncio.Event)  # set when there is a newer picture

    def next_news(self) -> News | None:
        """Return the next news to send, None when none waits; news of a patient whom it may not see is dropped."""
        while self.news:
            news = next(iter(self.news))
            del self.news[news]
            if news.patient is None or self.sees(news.patient):
                return news
        return None


class PictureSender(Generic[Message]):
    """Sends the newest picture to every viewer; a slow viewer misses pictures but no news.

    The viewers get it one after another, a few in each turn of the event loop. To two hundred at once it would take
    longer than a Stop may wait, which needs several turns.
    """

    def __init__(
        self,
        picture: Callable[[], Message],
        quality: Callable[[], BaseModel | None] = lambda: None,
        without_patient: Callable[[Message], Message] = lambda picture: picture,
    ) -> None:
        self._picture = picture
        self._quality = quality
        self._without_patient = without_patient
        self._viewers: set[Viewer] = set()
        self._pictures: dict[str, PictureText] = {}  # by language
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Begin to make pictures."""
        self._task = asyncio.create_task(self._make())

    async def close(self) -> None:
        """Make no more pictures."""
        if self._task is not None:
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)

    def notify(self, news: News) -> None:
        """Send every page what changed on the server, except of a patient whom it may not see."""
        for viewer in self._viewers:
            viewer.news[news] = None

    async def serve(self, viewer: Viewer) -> None:
        """Send pictures to one page until it disconnects or does not take them within SEND_LIMIT."""
        self._viewers.add(viewer)
        viewer.fresh.clear()  # a picture of before may be old, and of another patient
        try:
            while viewer.websocket.application_state is WebSocketState.CONNECTED:
                await viewer.fresh.wait()
                viewer.fresh.clear()
                newest = self._pictures.get(viewer.language, NOTHING)
                text = newest.whole if viewer.may_see() else newest.bare
                if not text:
                    continue  # the page may see nothing since just now: the next picture is made for it
                news = viewer.next_news()
                if news is not None:
                    text = _joined(text, json.dumps({"news": news.model_dump()}))
                with suppress(RuntimeError):
                    async with asyncio.timeout(SEND_LIMIT):
                        await viewer.websocket.send_text(text)
        except TimeoutError:
            cut_off(viewer.websocket)
        finally:
            self._viewers.discard(viewer)

    def forget(self, viewer: Viewer) -> None:
        """Remove a page at once."""
        self._viewers.discard(viewer)

    async def _make(self) -> None:
        deadline, turn = monotonic(), 0
        while True:
            deadline = max(deadline + EVERY, monotonic())
            if self._viewers:
                pictures = self._made(with_quality=turn % round(1 / EVERY) == 0)
                turn += 1
                if pictures is not None:
                    self._pictures = pictures
                    await self._wake()
            await asyncio.sleep(max(deadline - monotonic(), 0.0))

    async def _wake(self) -> None:
        """Let the viewers send the newest picture; one that still sends an earlier picture sends it afterwards."""
        for number, viewer in enumerate(list(self._viewers), 1):
            viewer.fresh.set()
            if number % AT_ONCE == 0:
                await asyncio.sleep(0)

    def _made(self, with_quality: bool) -> dict[str, PictureText] | None:
        """Return the current picture in the languages of the viewers; None, with the error logged, when it cannot be.

        The chair may drive while this fails: the pages need the next pictures.
        """
        try:
            picture, quality = self._picture(), self._quality() if with_quality else None
            made = {}
            for language in {viewer.language for viewer in self._viewers}:
                with reader_language(language):
                    made[language] = self._in_language(picture, quality)
        except Exception:
            logger.exception("The live picture could not be made")
            return None
        return made

    def _in_language(self, picture: Message, quality: BaseModel | None) -> PictureText:
        text = picture.model_dump_json()
        bare = any(not viewer.may_see() for viewer in self._viewers)
        bare_text = self._without_patient(picture).model_dump_json() if bare else ""
        return PictureText(text if quality is None else _joined(text, quality.model_dump_json()), bare_text)


def _joined(first: str, other: str) -> str:
    """Return one JSON object with the fields of two, none of which is empty."""
    return f"{first[:-1]},{other[1:]}"
