"""The far end of a serial line: the bytes of a board, and a board on a pseudo terminal whose cable can be pulled."""

import os
import pty
import struct
import tty
from binascii import crc_hqx
from collections.abc import Iterable, Sequence
from select import select

from app.hardware.shirt.serial_bytes import CHECKSUM_START


def cobs_encoded(body: bytes) -> bytes:
    """Return the bytes of COBS, without the delimiter."""
    encoded = bytearray()
    for block in body.split(b"\0"):
        full = len(block) // 254 * 254
        for at in range(0, full, 254):
            encoded += b"\xff" + block[at : at + 254]
        encoded += bytes([len(block) - full + 1]) + block[full:]
    return bytes(encoded)


def frame_bytes(seq: int, microseconds: int, steps: Sequence[int]) -> bytes:
    """Return a frame of int16 values with its delimiter; both counts wrap."""
    body = struct.pack(f"<HI{len(steps)}h", seq % 2**16, microseconds % 2**32, *steps)
    return cobs_encoded(body + struct.pack("<H", crc_hqx(body, CHECKSUM_START))) + b"\0"


def stream(frames: Iterable[tuple[int, int, Sequence[int]]]) -> bytes:
    """Return what a board sends after its start: a delimiter, then frames."""
    return b"\0" + b"".join(frame_bytes(*frame) for frame in frames)


class WiredBoard:
    """A board that sends three sensors, as frames or as lines."""

    def __init__(self, *, sends_lines: bool = False, rate: float = 100.0) -> None:
        self.sends_lines = sends_lines
        self.rate = rate
        self.plug()

    def plug(self) -> None:
        """Connect the board, which starts; the system gives the line a name."""
        self._ours, self.line = pty.openpty()
        tty.setraw(self.line)
        self.device = os.ttyname(self.line)
        self.is_in = True
        self.seq = 0

    def pull(self) -> None:
        """Take the cable out: the line is gone."""
        self.is_in = False
        os.close(self._ours)
        os.close(self.line)

    def send(self, count: int) -> None:
        """Send the next frames at once; the first value of each is its number modulo 1,000."""
        numbers = range(self.seq, self.seq + count)
        self.seq += count
        if self.sends_lines:
            self.send_bytes(b"\r\n" + b"".join(b"%d,1,2\r\n" % (seq % 1000) for seq in numbers))
        else:
            self.send_bytes(stream((seq, round(1e6 * seq / self.rate), (seq % 1000, 1, 2)) for seq in numbers))

    def write(self, content: bytes) -> None:
        """Send arbitrary bytes."""
        os.write(self._ours, content)

    def send_bytes(self, content: bytes) -> None:
        """Send arbitrary bytes, and wait until they are on the line."""
        self.write(content)
        assert select([self.line], [], [], 20.0)[0]
