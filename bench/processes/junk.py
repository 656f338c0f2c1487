"""Floods ports with datagrams of the right length, magic and key number but a wrong tag.

Arguments: datagrams per second to each port, seconds, then for each port `PORT:COLOUR:FD`; COLOUR is W for datagrams
like commands and T for datagrams like telemetry, FD an open socket to send from, so that junk can come from the chair's
own address. Prints the number of datagrams to each port, and the times of begin and end (monotonic s).
"""

import json
import os
import socket
import sys
from struct import Struct

from app.clock import MonotonicClock
from app.hardware.chair.packet import (
    COMMAND_MAGIC,
    FRAME_BYTES,
    TELEMETRY_BYTES,
    TELEMETRY_MAGIC,
    TELEMETRY_VERSION,
    VERSION,
)

KEY_ID = 1
BURST = 50  # datagrams in one system call, where the kernel can split them
UDP_SEGMENT = 103  # socket option of linux/udp.h: the kernel splits a long datagram into datagrams of this size
_HEAD = Struct("<4sBBH")
# Magic, version and length of each colour.
KINDS = {"W": (COMMAND_MAGIC, VERSION, FRAME_BYTES), "T": (TELEMETRY_MAGIC, TELEMETRY_VERSION, TELEMETRY_BYTES)}


class Flood:
    """Sends junk to one port, in bursts of `BURST`."""

    def __init__(self, port: int, colour: str, source: socket.socket) -> None:
        self._socket = source
        self._address = ("127.0.0.1", port)
        magic, version, self._size = KINDS[colour]
        frames = [_HEAD.pack(magic, version, 1, KEY_ID) + os.urandom(self._size - _HEAD.size) for _ in range(BURST)]
        self._frames, self._together = frames, b"".join(frames)
        self._splits = _splits(source)
        self.sent = 0

    def burst(self) -> None:
        """Send the next datagrams; dropped ones are not counted."""
        try:
            if self._splits:
                control = [(socket.IPPROTO_UDP, UDP_SEGMENT, self._size.to_bytes(2, sys.byteorder))]
                self._socket.sendmsg([self._together], control, 0, self._address)
                self.sent += BURST
                return
            for frame in self._frames:
                self._socket.sendto(frame, self._address)
                self.sent += 1
        except (BlockingIOError, ConnectionRefusedError):
            return


def _splits(source: socket.socket) -> bool:
    """Return whether the kernel can split a long datagram."""
    try:
        source.getsockopt(socket.IPPROTO_UDP, UDP_SEGMENT)
    except OSError:
        return False
    return sys.platform == "linux"


def main(rate: float, seconds: float, targets: list[str]) -> None:
    """Send for `seconds`, then print the counts."""
    floods = []
    for target in targets:
        port, colour, descriptor = target.split(":")
        floods.append(Flood(int(port), colour, socket.socket(fileno=int(descriptor))))
    clock = MonotonicClock()
    begin = clock.now()
    for burst in range(round(rate * seconds / BURST)):
        clock.sleep_until(begin + burst * BURST / rate)
        for flood in floods:
            flood.burst()
    report = {"sent": [flood.sent for flood in floods], "begin": begin, "end": clock.now()}
    sys.stdout.write(f"{json.dumps(report)}\n")


if __name__ == "__main__":
    main(float(sys.argv[1]), float(sys.argv[2]), sys.argv[3:])
