"""A viewer of the 3D view in its own process, so that it can be stopped; it reconnects after a disconnection.

Arguments: the web process's port, the role. For each line on stdin it prints how many poses have come so far, how often
it has connected, and how old the newest pose was when it came (s). Ends with stdin.
"""

import asyncio
import math
import sys
from typing import cast

from websockets.exceptions import ConnectionClosed, InvalidHandshake

from app.clock import monotonic
from app.scene.role_servers import Role
from bench.circle import age_at
from bench.web.view_client import chair_positions, open_view, packets

AGAIN = 0.5  # s before the next connection


class Viewer:
    """Counts the poses that it receives."""

    def __init__(self) -> None:
        self.poses = 0
        self.connected = 0
        self.age = math.nan  # s

    async def receive(self, port: int, role: Role) -> None:
        """Receive poses endlessly, and reconnect."""
        while True:
            try:
                async with await open_view(port, role) as connection:
                    self.connected += 1
                    async for packet in packets(connection):
                        for at in chair_positions(packet):
                            self.poses += 1
                            self.age = age_at(*at, monotonic())
            except (OSError, TimeoutError, ConnectionClosed, InvalidHandshake):
                pass
            await asyncio.sleep(AGAIN)


async def main(port: int, role: Role) -> None:
    """Receive poses until stdin ends."""
    viewer = Viewer()
    receiving = asyncio.create_task(viewer.receive(port, role))
    while await asyncio.to_thread(sys.stdin.readline):
        sys.stdout.write(f"{viewer.poses} {viewer.connected} {viewer.age}\n")
        sys.stdout.flush()
    receiving.cancel()


if __name__ == "__main__":
    asyncio.run(main(int(sys.argv[1]), cast(Role, sys.argv[2])))
