"""Message buffers of viser's servers, which any thread may fill while pages come and go.

viser 1.1.1 wakes whoever waits for a message in the thread that draws, while the server's own thread may change the
list of those who wait. Then the drawing thread ended ("deque mutated during iteration"), and the picture stood still.
"""

import asyncio
import threading
from asyncio import AbstractEventLoop

from viser.infra import _infra
from viser.infra._async_message_buffer import AsyncMessageBuffer


class LoopEvent(asyncio.Event):
    """An event that is set in the thread that made it, which runs the event loop; elsewhere it stays as it is.

    viser asks the loop to set it after each message and at the end of each atomic block, so that nobody waits longer.
    """

    def __init__(self) -> None:
        super().__init__()
        self._loop_thread = threading.get_ident()

    def set(self) -> None:
        """Wake who waits, when called in the thread of the event loop."""
        if threading.get_ident() == self._loop_thread:
            super().set()


class LoopBuffer(AsyncMessageBuffer):
    """Messages to pages; who waits for them is woken by the event loop of the server alone."""

    def __init__(self, event_loop: AbstractEventLoop, persistent_messages: bool) -> None:
        super().__init__(event_loop, persistent_messages, message_event=LoopEvent())


def use_loop_buffers() -> None:
    """Give these buffers to every server that viser opens from now on, and to its pages."""
    # viser has no hook for them, but makes them by this name.
    _infra.AsyncMessageBuffer = LoopBuffer  # type: ignore[assignment, attr-defined]
