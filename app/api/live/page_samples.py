"""Samples of pages that are sensors, from their sockets: of bounded number and size."""

from collections.abc import Callable
from typing import Final

from fastapi import WebSocket

from app.clock import monotonic
from app.messages import LONGEST_SAMPLE

NOT_A_SAMPLE: Final = 1003  # close codes
TOO_MANY: Final = 1008

Take = Callable[[bytes, float], int | None]
"""Takes a sample that came at a time (monotonic s); returns the code with which the socket is closed, if it is."""


async def receive_samples(websocket: WebSocket, most: int, take: Take) -> int | None:
    """Hand on samples, at most `most` a second, until the page leaves or a close code, which is returned."""
    count, since = 0, monotonic()
    while True:
        message = await websocket.receive()
        if message["type"] == "websocket.disconnect":
            return None
        now = monotonic()
        if now - since > 1.0:
            count, since = 0, now
        count += 1
        sample = message.get("bytes")
        if count > most:
            return TOO_MANY
        if not sample or len(sample) > LONGEST_SAMPLE:
            return NOT_A_SAMPLE
        code = take(sample, now)
        if code is not None:
            return code
