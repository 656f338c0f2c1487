"""A viewer of one 3D server in its own process: for each line on stdin it prints the number of bytes received.

Argument: the server's port. The first line on stdin is the secret of the bridge; prints a line when it is connected.
Ends with stdin.
"""

import asyncio
import sys

from websockets.asyncio.client import connect
from websockets.typing import Subprotocol

from app.scene.bridge_secret import HEADER
from app.scene.client_messages import SUBPROTOCOL


async def read(port: int, secret: str) -> None:
    """Read until stdin ends."""
    count = 0

    async with connect(
        f"ws://127.0.0.1:{port}",
        subprotocols=[Subprotocol(SUBPROTOCOL)],
        additional_headers={HEADER: secret},
        compression=None,
        max_size=None,
        proxy=None,
    ) as connection:

        async def take() -> None:
            nonlocal count
            async for packet in connection:
                count += len(packet)

        taking = asyncio.create_task(take())
        _say("connected")
        while await asyncio.to_thread(sys.stdin.readline):
            _say(str(count))
        taking.cancel()


def _say(line: str) -> None:
    sys.stdout.write(f"{line}\n")
    sys.stdout.flush()


if __name__ == "__main__":
    asyncio.run(read(int(sys.argv[1]), sys.stdin.readline().strip()))
