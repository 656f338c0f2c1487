from collections.abc import Mapping

import msgspec
import zstandard

from bench.web.view_client import chair_positions


def packet(*messages: Mapping[str, object]) -> bytes:
    content = msgspec.msgpack.encode({"messages": messages, "timestampSec": 1.0})
    packed = zstandard.ZstdCompressor().compress(content)
    return len(content).to_bytes(8, "little") + len(packed).to_bytes(8, "little") + packed + b"arrays of meshes"


def test_only_the_chair_counts() -> None:
    moved = {"type": "SetPositionMessage", "name": "/world/chair", "position": (1.0, 2.0, 0.0)}
    turned = {"type": "SetOrientationMessage", "name": "/world/chair", "wxyz": (1.0, 0.0, 0.0, 0.0)}
    other = {"type": "SetPositionMessage", "name": "/world", "position": (3.0, 4.0, 0.0)}
    assert list(chair_positions(packet(turned, moved, other))) == [(1.0, 2.0)]
    assert list(chair_positions(packet())) == []
