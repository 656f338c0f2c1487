"""The event loop of the web process, which does only a little in each turn, so that a Stop is not long in coming."""

import asyncio
import selectors
from itertools import count
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from _typeshed import FileDescriptorLike

EVENTS = 4  # sockets that are attended to in one turn, of those that have something to read or may be written to


class FewAtOnce(selectors.DefaultSelector):
    """Reports a few of the sockets that are ready, first those that were attended to least recently.

    A Stop takes about seven turns of the event loop, from its new connection to its answer. When two hundred pages
    come, go or send at the same moment, it would wait for all of them in each turn.
    """

    def __init__(self) -> None:
        super().__init__()
        self._numbers = count(1)
        self._attended: dict[int, int] = {}  # descriptor: the turn

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        """Wait until a socket is ready; those that are left out are still ready in the next turn."""
        ready = super().select(timeout)
        if len(ready) > EVENTS:
            ready = sorted(ready, key=lambda event: self._attended.get(event[0].fd, 0))[:EVENTS]
        turn = next(self._numbers)
        for key, _ in ready:
            self._attended[key.fd] = turn
        return ready

    def unregister(self, fileobj: "FileDescriptorLike") -> selectors.SelectorKey:
        """Forget a socket; another one that gets its descriptor is a new one."""
        key = super().unregister(fileobj)
        self._attended.pop(key.fd, None)
        return key


def event_loop() -> asyncio.AbstractEventLoop:
    """Return a new event loop."""
    return asyncio.SelectorEventLoop(FewAtOnce())
