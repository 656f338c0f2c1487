"""A flood of sign-ins from one machine, with many names, from many addresses.

Arguments: the port of the web process, how many at once. Then, for each line on stdin, `on` lets them begin and `off`
lets them end; answers with a JSON object of how often each status came so far. Ends with stdin.
"""

import asyncio
import json
import sys
from collections import Counter

PEOPLE = 200  # names tried by each connection, in turn


async def main(port: int, connections: int) -> None:
    """Flood until stdin ends."""
    is_on, answers = asyncio.Event(), Counter[int]()
    flood = [asyncio.create_task(_sign_in(port, number, is_on, answers)) for number in range(connections)]
    while word := (await asyncio.to_thread(sys.stdin.readline)).strip():
        (is_on.set if word == "on" else is_on.clear)()
        sys.stdout.write(f"{json.dumps(answers)}\n")
        sys.stdout.flush()
    for one in flood:
        one.cancel()
    await asyncio.gather(*flood, return_exceptions=True)


async def _sign_in(port: int, number: int, is_on: asyncio.Event, answers: Counter[int]) -> None:
    """Send one sign-in after the other over one connection, each after the answer to the one before."""
    await is_on.wait()
    # Each connection has its own loopback address, so that the limit for an address does not end the flood.
    source = (f"127.0.0.{number % 250 + 2}", 0) if sys.platform == "linux" else None
    reader, writer = await asyncio.open_connection("127.0.0.1", port, local_addr=source)
    try:
        turn = 0
        while True:
            await is_on.wait()
            turn += 1
            writer.write(_request(port, f"person {number} {turn % PEOPLE}", is_known=bool(turn % 2)))
            head = await reader.readuntil(b"\r\n\r\n")
            fields = dict(line.lower().split(b": ", 1) for line in head.split(b"\r\n")[1:] if line)
            await reader.readexactly(int(fields[b"content-length"]))
            answers[int(head.split()[1])] += 1
    finally:
        writer.close()


def _request(port: int, name: str, *, is_known: bool) -> bytes:
    body = json.dumps({"name": name, "password": "a wrong password"}).encode()
    lines = [
        "POST /api/v1/auth/sign-in HTTP/1.1",
        f"Host: 127.0.0.1:{port}",
        f"Origin: http://127.0.0.1:{port}",
        "Content-Type: application/json",
        f"Content-Length: {len(body)}",
    ]
    if is_known:  # with a sign-in cookie, which is looked up
        lines.append(f"Cookie: bodydrive_sign_in={'s' * 43}; bodydrive_browser_1={'b' * 43}")
    return "\r\n".join([*lines, "", ""]).encode() + body


if __name__ == "__main__":
    asyncio.run(main(int(sys.argv[1]), int(sys.argv[2])))
