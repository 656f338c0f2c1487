"""Pages that show the live picture beside pages that hardly read it, for a benchmark.

Arguments: the port of the web process, the token of a sign-in, how many pages read, how many hardly read. Those that
read are there from the beginning. Then, for each line on stdin, `on` opens those that hardly read, which come again
when they are cut off, and `off` closes them; answers with a JSON object of how often what happened so far. Ends with
stdin.
"""

import asyncio
import json
import socket
import sys
from collections import Counter

from websockets.asyncio.client import connect

from app.api.sign_in.identity import COOKIE

PATH = "/api/v1/live"
READ, PAUSE = 1024, 0.5  # bytes that a slow page reads at once; s between two such reads
BUFFER = 4096  # bytes that wait in the kernel for a slow page, which the kernel doubles
AGAIN = 0.5  # s after which a page that was cut off comes again, as the first time that a real one does


async def main(port: int, token: str, reading: int, slow: int) -> None:
    """Be these pages until stdin ends."""
    counts = Counter[str]()
    viewers = [asyncio.create_task(_read(port, token, counts)) for _ in range(reading)]
    slow_ones: list[asyncio.Task[None]] = []
    while word := (await asyncio.to_thread(sys.stdin.readline)).strip():
        await _end(slow_ones)
        slow_ones = [asyncio.create_task(_hardly_read(port, token, counts)) for _ in range(slow if word == "on" else 0)]
        sys.stdout.write(f"{json.dumps(counts)}\n")
        sys.stdout.flush()
    await _end([*viewers, *slow_ones])


async def _end(pages: list[asyncio.Task[None]]) -> None:
    for page in pages:
        page.cancel()
    await asyncio.gather(*pages, return_exceptions=True)


async def _read(port: int, token: str, counts: Counter[str]) -> None:
    origin, cookie = f"http://127.0.0.1:{port}", f"{COOKIE}={token}"
    async with connect(f"ws://127.0.0.1:{port}{PATH}", additional_headers={"Cookie": cookie, "Origin": origin}) as page:
        async for _ in page:
            counts["pictures of pages that read"] += 1


async def _hardly_read(port: int, token: str, counts: Counter[str]) -> None:
    """Open a page and read a little now and then; open it again when it is cut off."""
    while True:
        with socket.socket() as page:
            page.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER)
            page.setblocking(False)
            await _hardly_read_one(page, port, token, counts)
        await asyncio.sleep(AGAIN)


async def _hardly_read_one(page: socket.socket, port: int, token: str, counts: Counter[str]) -> None:
    loop = asyncio.get_running_loop()
    try:
        await loop.sock_connect(page, ("127.0.0.1", port))
        await loop.sock_sendall(page, _handshake(port, token))
        counts["slow pages opened"] += 1
        while await loop.sock_recv(page, READ):
            await asyncio.sleep(PAUSE)
    except OSError:
        pass
    counts["slow pages cut off"] += 1


def _handshake(port: int, token: str) -> bytes:
    lines = [
        f"GET {PATH} HTTP/1.1",
        f"Host: 127.0.0.1:{port}",
        f"Origin: http://127.0.0.1:{port}",
        f"Cookie: {COOKIE}={token}",
        "Upgrade: websocket",
        "Connection: Upgrade",
        "Sec-WebSocket-Version: 13",
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==",
    ]
    return "\r\n".join([*lines, "", ""]).encode()


if __name__ == "__main__":
    asyncio.run(main(int(sys.argv[1]), sys.argv[2], int(sys.argv[3]), int(sys.argv[4])))
