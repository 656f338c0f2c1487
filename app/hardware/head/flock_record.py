"""The Flock of Birds' position and angles record: six words of two bytes, of which only the first byte has bit 7 set.

Source: Ascension Technology, Flock of Birds installation and operation guide, RS-232 commands and data formats.
"""

import math
import struct

from app.messages import HeadPose

WORDS = 6  # x, y, z, then azimuth, elevation, roll
RECORD = 2 * WORDS  # bytes; in a group one more, the unit's address
PHASE = 0x80  # set in the first byte of a record, and in no other
INCH = 0.0254  # m
POSITION = 36.0 * INCH / 32768  # m of one step
ANGLE = math.pi / 32768  # rad of one step


class Records:
    """Splits a stream of bytes into records, from any byte on: a record begins at a byte with bit 7 set."""

    def __init__(self, size: int) -> None:
        self._size = size
        self._record = bytearray()

    def feed(self, content: bytes) -> list[bytes]:
        """Return the complete records that end in `content`."""
        whole = []
        for byte in content:
            if byte & PHASE:
                self._record = bytearray([byte])
            elif self._record:
                self._record.append(byte)
            if len(self._record) == self._size:
                whole.append(bytes(self._record))
                self._record.clear()
        return whole


def decode(record: bytes, t: float) -> HeadPose:
    """Return the pose of a record (of 12 bytes or more) that came at `t` (s).

    The unit's axes are ahead, right, down; its angles are azimuth (right positive), elevation (up), roll (right).
    """
    x, y, z, azimuth, elevation, roll = (_word(record[2 * i], record[2 * i + 1]) for i in range(WORDS))
    return HeadPose(t, -azimuth * ANGLE, elevation * ANGLE, roll * ANGLE, x * POSITION, -y * POSITION, -z * POSITION)


def encode(words: tuple[int, ...], address: int | None = None) -> bytes:
    """Return the record of six words (int16, their two lowest bits lost), as a unit sends it."""
    record = bytearray()
    for word in words:
        bits = word & 0xFFFF
        record += bytes([bits >> 2 & 0x7F, bits >> 9 & 0x7F])
    record[0] |= PHASE
    return bytes(record) if address is None else bytes([*record, address])


def _word(low: int, high: int) -> int:
    """Return a word from its bytes: 7 bits each, the highest ones of 16."""
    value: int = struct.unpack("<h", struct.pack("<H", (low & 0x7F) << 2 | (high & 0x7F) << 9))[0]
    return value
