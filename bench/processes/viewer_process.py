"""A viewer of the 3D view in a process of its own, so that it can be stopped; it comes back when it was cut off.

Arguments: the web process's port, the role. For each line on stdin it prints how many poses have come so far, how often
it has connected, and how old the newest pose was when it came (s). Ends with stdin.
"""

import asyncio
import math
import sys
from typing import cast

from websockets.exceptions import ConnectionClosed, InvalidHandshake

from app.clock import monotonic
from app.scene.servers import Role
from bench.circle import age_at
from bench.view_client import chair_positions, open_view, packets

AGAIN = 0.5  # s before it connects again


class Viewer:
    """Counts what it sees."""

    def __init__(self) -> None:
        self.poses = 0
        self.connected = 0
        self.age = math.nan  # s

    async def look(self, port: int, role: Role) -> None:
        """Look for ever."""
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
    """Look until stdin ends."""
    viewer = Viewer()
    looking = asyncio.create_task(viewer.look(port, role))
    while await asyncio.to_thread(sys.stdin.readline):
        sys.stdout.write(f"{viewer.poses} {viewer.connected} {viewer.age}\n")
        sys.stdout.flush()
    looking.cancel()


if __name__ == "__main__":
    asyncio.run(main(int(sys.argv[1]), cast(Role, sys.argv[2])))
