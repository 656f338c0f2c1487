"""A client of the 3D view without a browser: it receives everything and extracts the poses of the chair."""

import ssl
from collections.abc import AsyncIterator, Iterator
from typing import Any, Final

import msgspec
import zstandard
from websockets.asyncio.client import ClientConnection, connect
from websockets.asyncio.connection import Connection
from websockets.typing import Subprotocol

from app.scene.client_messages import SUBPROTOCOL
from app.scene.role_servers import Role

CHAIR: Final = "/world/chair"
HEADER: Final = 16  # bytes: two lengths before the packed messages


async def open_view(port: int, role: Role, trust: ssl.SSLContext | None = None) -> ClientConnection:
    """Connect to the 3D view that is served on a port of this machine, over https with `trust`."""
    return await connect(
        f"{'ws' if trust is None else 'wss'}://127.0.0.1:{port}/view/{role}",
        ssl=trust,
        subprotocols=[Subprotocol(SUBPROTOCOL)],
        compression=None,
        max_size=None,
        proxy=None,
    )


async def packets(connection: Connection) -> AsyncIterator[bytes]:
    """Yield the packets that come, until the server closes the connection."""
    async for packet in connection:
        yield packet if isinstance(packet, bytes) else packet.encode()


def chair_positions(packet: bytes) -> Iterator[tuple[float, float]]:
    """Yield the positions (x, y in m) of the chair in one packet of viser.

    A packet is two lengths (little-endian uint64: of the messages, and of them packed by zstd), the packed messages
    (msgpack), and then the arrays of meshes, which are ignored.
    """
    unpacked, packed = (int.from_bytes(packet[at : at + 8], "little") for at in (0, 8))
    content = zstandard.ZstdDecompressor().decompress(packet[HEADER : HEADER + packed], max_output_size=unpacked)
    found: dict[str, Any] = msgspec.msgpack.decode(content)
    for message in found["messages"]:
        if message["type"] == "SetPositionMessage" and message["name"] == CHAIR:
            x, y, _ = message["position"]
            yield x, y
