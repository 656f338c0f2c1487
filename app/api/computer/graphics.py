"""How many pictures a second each screen draws that is open now, counted by the screens when somebody asks."""

import asyncio
from typing import Annotated, Any

from pydantic import Field

from app.api.live.picture_sender import PictureSender
from app.news import News
from app.texts import Text

COUNT = News(what="graphics")  # on the live sockets: count your pictures, and answer
ANSWER_LIMIT = 4.0  # s; the pages count for two seconds

PicturesPerSecond = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1000)]


class Graphics:
    """Asks the screens, and keeps the answer of each, by its live socket."""

    def __init__(self, *senders: PictureSender[Any]) -> None:
        self._senders = senders
        self._names: dict[object, Text] = {}
        self._rates: dict[object, float] = {}

    def opened(self, socket: object, name: Text) -> None:
        """Store whose screen has opened a live socket."""
        self._names[socket] = name

    def forget(self, socket: object) -> None:
        """Forget a screen whose socket has ended."""
        self._names.pop(socket, None)
        self._rates.pop(socket, None)

    def set_rate(self, socket: object, rate: float) -> None:
        """Store the pictures a second of a screen."""
        self._rates[socket] = rate

    async def ask(self) -> list[tuple[Text, float | None]]:
        """Return the name of each open screen and its pictures a second, None for one that did not answer."""
        self._rates.clear()
        for sender in self._senders:
            sender.notify(COUNT)
        await asyncio.sleep(ANSWER_LIMIT)
        return [(name, self._rates.get(socket)) for socket, name in self._names.items()]
