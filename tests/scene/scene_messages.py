"""The messages of a 3D server to a browser, and ticks for its scene."""

import msgspec
import numpy as np
import websockets.sync.client
import zstandard

from app.messages import TICK
from app.scene.bridge_secret import BRIDGE_HEADERS
from app.scene.client_messages import SUBPROTOCOL


def messages(port, stop):
    """Read a 3D server as a browser does, until a message satisfies `stop`."""
    found = []
    with websockets.sync.client.connect(
        f"ws://127.0.0.1:{port}",
        subprotocols=[SUBPROTOCOL],
        additional_headers=BRIDGE_HEADERS,
        compression=None,
        max_size=None,
        proxy=None,
    ) as client:
        while not any(stop(message) for message in found):
            frame = client.recv(timeout=10)
            size = int.from_bytes(frame[8:16], "little")
            inner = zstandard.ZstdDecompressor().decompress(frame[16 : 16 + size], int.from_bytes(frame[:8], "little"))
            found += msgspec.msgpack.decode(inner)["messages"]
    return found


def everything(port):
    return messages(port, lambda message: message["type"] == "ReplayDoneMessage")


def of_node(found, kind, name):
    return [message for message in found if message["type"] == kind and message["name"] == name]


def tick(number, x, y, theta, t=1.0):
    made = np.zeros(1, dtype=TICK)[0]
    made["number"], made["x"], made["y"], made["theta"], made["t"] = number, x, y, theta, t
    return made
