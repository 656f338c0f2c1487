"""The datagrams of the chair link (docs/protocols.md, section 9). Standard library only.

Everything is little-endian. A command has 52 bytes and a tag, a telemetry 68 bytes and a tag: the first 16 bytes of
HMAC-SHA-256. The tag of a command also covers the receiver's nonce, which is new at every boot and every disarming, so
that a recorded command is refused.
"""

import hmac
import math
from struct import Struct
from typing import NamedTuple

from app.hardware.chair.key import Key

VERSION = 1  # of a command and of a hello
TELEMETRY_VERSION = 2  # 1 had no measured speeds, nor the chair's own joystick and document
COMMAND_MAGIC, TELEMETRY_MAGIC, HELLO_MAGIC = b"BMIW", b"BMIT", b"BMIH"
DRIVE, STOP, VIRTUAL = 1, 2, 4  # flags of a command

TAG_BYTES, NONCE_BYTES, DIGEST_BYTES = 16, 8, 8
_COMMAND = Struct("<4sBBHIQQffff8s")
_TELEMETRY = Struct("<4sBBHIQQ8sfffBBBBff8s")
FRAME_BYTES = _COMMAND.size + TAG_BYTES  # 68, of a command
TELEMETRY_BYTES = _TELEMETRY.size + TAG_BYTES  # 84
_HELLO = Struct("<4sBBHI")


class ChairCommand(NamedTuple):
    """A command to a chair."""

    flags: int
    key_id: int
    epoch: int  # u32, random at each arming
    sequence: int  # u64, strictly increasing
    t_ns: int  # the sender's monotonic clock, ns
    v: float  # m/s
    omega: float  # rad/s
    v_cap: float  # m/s: the sender's own limit
    omega_cap: float  # rad/s
    digest: bytes  # the first 8 bytes of the parameter set's SHA-256


class Telemetry(NamedTuple):
    """A chair's report of itself."""

    state: int  # 0 disarmed, 1 checking neutral, 2 armed, 3 fault
    key_id: int
    epoch: int
    sequence: int  # of the last accepted command
    t_ns: int  # the chair's monotonic clock, ns
    nonce: bytes  # 8 bytes
    v: float  # m/s, as the receiver commands the chair
    omega: float  # rad/s
    battery: float  # 0..1, NaN when unknown
    stop_input: int  # 1: pressed
    fault: int  # app.hardware.chair.reasons.Reason
    own_joystick: int = 0  # 1: somebody moves the chair's own joystick
    crawls: int = 0  # 1: a chair document is missing, so the receiver commands a crawl at most
    measured_v: float = math.nan  # m/s, as the chair itself measures it; NaN: it does not
    measured_omega: float = math.nan  # rad/s
    document: bytes = bytes(DIGEST_BYTES)  # the first 8 bytes of the chair document's SHA-256; zeros: it has none


def encode_command(command: ChairCommand, key: Key, nonce: bytes) -> bytes:
    """Return the 68 bytes of a command, tagged for a receiver whose nonce is `nonce`."""
    flags, key_id, *rest = command
    body = _COMMAND.pack(COMMAND_MAGIC, VERSION, flags, key_id, *rest)
    return body + _tag(key, body + nonce)


def decode_command(datagram: bytes, key: Key, nonce: bytes) -> ChairCommand | None:
    """Return a command whose length, magic, version, key number and tag are right, otherwise None.

    The receiver checks whether the command is new and its numbers can be driven.
    """
    if len(datagram) != FRAME_BYTES or datagram[:4] != COMMAND_MAGIC:
        return None
    body, tag = datagram[:-TAG_BYTES], datagram[-TAG_BYTES:]
    _, version, flags, key_id, *rest = _COMMAND.unpack(body)
    if version != VERSION or key_id != key.id or not hmac.compare_digest(tag, _tag(key, body + nonce)):
        return None
    return ChairCommand(flags, key_id, *rest)


def encode_telemetry(telemetry: Telemetry, key: Key) -> bytes:
    """Return the 84 bytes of a telemetry."""
    state, key_id, *rest = telemetry
    body = _TELEMETRY.pack(TELEMETRY_MAGIC, TELEMETRY_VERSION, state, key_id, *rest)
    return body + _tag(key, body)


def decode_telemetry(datagram: bytes, key: Key) -> Telemetry | None:
    """Return a telemetry with a valid tag of this chair's key, otherwise None."""
    if len(datagram) != TELEMETRY_BYTES or datagram[:4] != TELEMETRY_MAGIC:
        return None
    body, tag = datagram[:-TAG_BYTES], datagram[-TAG_BYTES:]
    _, version, state, key_id, *rest = _TELEMETRY.unpack(body)
    if version != TELEMETRY_VERSION or key_id != key.id or not hmac.compare_digest(tag, _tag(key, body)):
        return None
    return Telemetry(state, key_id, *rest)


def encode_hello(key_id: int) -> bytes:
    """Return the 12 bytes that ask a chair for its telemetry; they arm nothing."""
    return _HELLO.pack(HELLO_MAGIC, VERSION, 0, key_id, 0)


def is_hello(datagram: bytes, key_id: int) -> bool:
    """Return whether a datagram asks this chair for its telemetry."""
    return datagram == encode_hello(key_id)


def _tag(key: Key, covered: bytes) -> bytes:
    return hmac.digest(key.secret, covered, "sha256")[:TAG_BYTES]
