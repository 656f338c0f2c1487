"""The datagram of a shirt: one frame, checked, and signed where a key is paired (docs/protocols.md, section 6)."""

import hmac
from struct import Struct
from typing import Final
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from app.hardware.chair.key import Key
from app.layout import MAX_CHANNELS
from app.texts import Text

MAGIC = b"SHRT"
VERSION = 1
INT16 = 1  # flag: samples are int16 of full scale +-32767 instead of float32
SIGNED = 2  # flag: key id and boot counter follow the header, a tag stands before the checksum
FULL_SCALE = 32767.0

HEADER = Struct("<4sBBHIQ")
"""Magic, version, flags, channel count, seq (u32), device time (u64, microseconds)."""
SIGNER = Struct("<HQ")
"""Key id (u16) and boot counter (u64) of a signed frame."""
TAG_BYTES = 16  # the first bytes of HMAC-SHA-256 over all bytes before the tag
CHECKSUM = Struct("<I")
LONGEST = HEADER.size + SIGNER.size + 4 * MAX_CHANNELS + TAG_BYTES + CHECKSUM.size  # bytes

Packet = tuple[int, int, NDArray[np.float32]]
"""Seq, device time in microseconds, values (n_channels,)."""

KEY_REFUSALS: Final = frozenset({"shirtdev-frame-needs-key", "shirtdev-frame-not-signed"})
"""The ids of the reasons of `refusal` that another key, or the paired one, would mend."""

_PARTS = HEADER.unpack_from
_NUMBER = CHECKSUM.unpack_from
_VALUES_AT = HEADER.size
_SIGNED_VALUES_AT = HEADER.size + SIGNER.size


def encode(seq: int, t_device: float, values: NDArray[np.float32], int16: bool = False) -> bytes:
    """Return the datagram of one frame.

    Parameters
    ----------
    seq : int
        The device's counter; its lower 32 bits are sent.
    t_device : float
        The device's time, s, not negative; sent in whole microseconds.
    values : (n_channels,) array
        As int16 they are clipped to -1..1, and a NaN is sent as 0.
    int16 : bool
        Send 2 bytes a sample instead of 4.

    Raises
    ------
    ValueError
        When there are no channels or more than a shirt can have, or the time is out of range.
    """
    if values.ndim != 1 or not 1 <= len(values) <= MAX_CHANNELS:
        raise ValueError(f"a frame has 1 to {MAX_CHANNELS} channels in one row, this one has the shape {values.shape}")
    microseconds = round(t_device * 1e6)
    if not 0 <= microseconds < 2**64:
        raise ValueError(f"a device time of {t_device:g} s cannot be sent: it counts from 0 up")
    flags = INT16 if int16 else 0
    samples = _as_int16(values) if int16 else values.astype("<f4").tobytes()
    body: bytes = HEADER.pack(MAGIC, VERSION, flags, len(values), seq & 0xFFFFFFFF, microseconds) + samples
    return body + CHECKSUM.pack(crc32(body))


def decode(buffer: bytes | bytearray | memoryview, size: int, channels: int) -> Packet | None:
    """Return the frame in the first `size` bytes of `buffer`, None when it is not one of `channels` channels.

    A frame with a changed byte is refused. The values are a copy, so the buffer can be reused.
    """
    if size < _VALUES_AT:
        return None
    magic, version, flags, count, seq, microseconds = _PARTS(buffer)
    if magic != MAGIC or version != VERSION or count != channels:
        return None
    if flags == 0:
        end = _VALUES_AT + 4 * count
    elif flags == INT16:
        end = _VALUES_AT + 2 * count
    else:
        return None
    if size != end + 4 or crc32(memoryview(buffer)[:end]) != _NUMBER(buffer, end)[0]:
        return None
    return seq, microseconds, _values(buffer, flags, count, _VALUES_AT)


def decode_signed(
    buffer: bytes | bytearray | memoryview, size: int, channels: int, key: Key
) -> tuple[int, Packet] | None:
    """Return boot counter and frame of the first `size` bytes, None when these are no frame signed with `key`."""
    if size < _SIGNED_VALUES_AT:
        return None
    magic, version, flags, count, seq, microseconds = _PARTS(buffer)
    if magic != MAGIC or version != VERSION or count != channels or flags & ~INT16 != SIGNED:
        return None
    tag_at = _SIGNED_VALUES_AT + (2 if flags & INT16 else 4) * count
    end = tag_at + TAG_BYTES
    key_id, boot = SIGNER.unpack_from(buffer, _VALUES_AT)
    if size != end + CHECKSUM.size or key_id != key.id:
        return None
    content = memoryview(buffer)
    if crc32(content[:end]) != _NUMBER(buffer, end)[0]:
        return None
    tag = hmac.digest(key.secret, content[:tag_at], "sha256")[:TAG_BYTES]
    if not hmac.compare_digest(tag, content[tag_at:end]):
        return None
    return boot, (seq, microseconds, _values(buffer, flags, count, _SIGNED_VALUES_AT))


def _values(buffer: bytes | bytearray | memoryview, flags: int, count: int, start: int) -> NDArray[np.float32]:
    """Return a copy of the samples (count,) that begin at byte `start`."""
    if not flags & INT16:
        return np.frombuffer(buffer, "<f4", count, start).astype(np.float32)
    values = np.frombuffer(buffer, "<i2", count, start).astype(np.float32)
    values /= np.float32(FULL_SCALE)
    return values


def refusal(buffer: bytes | bytearray | memoryview, size: int, channels: int, key: Key | None = None) -> Text:
    """Return why these bytes are no frame of `channels` channels, signed with `key` where there is one."""
    if size < HEADER.size + CHECKSUM.size:
        return Text("shirtdev-frame-short", size=size)
    magic, version, flags, count, _, _ = HEADER.unpack_from(buffer)
    if magic != MAGIC:
        return Text("shirtdev-frame-foreign")
    if version != VERSION:
        return Text("shirtdev-frame-version", version=version, understood=VERSION)
    if flags & ~(INT16 | SIGNED):
        return Text("shirtdev-frame-flags", flags=f"{flags:#04x}")
    if count != channels:
        return Text("shirtdev-frame-sensors", sent=count, expected=channels)
    if key is None and flags & SIGNED:
        return Text("shirtdev-frame-needs-key")
    if key is not None:
        return Text("shirtdev-frame-not-signed")
    return Text("shirtdev-frame-damaged")


def _as_int16(values: NDArray[np.float32]) -> bytes:
    whole = np.clip(np.nan_to_num(values, nan=0.0, posinf=1.0, neginf=-1.0), -1.0, 1.0) * FULL_SCALE
    samples: bytes = np.rint(whole).astype("<i2").tobytes()
    return samples
