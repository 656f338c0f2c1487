"""Floods ports with datagrams that look like frames and are none: right length, magic and key number, wrong tag.

Arguments: datagrams per second to each port, seconds, then for each port `PORT:COLOUR:FD`; COLOUR is W for what looks
like a command and T for what looks like telemetry, FD an open socket to send from, so that junk can come from the
chair's own address. Prints how many datagrams went to each port, and from when to when (monotonic s).
"""

import json
import os
import socket
import sys
from struct import Struct

from app.clock import MonotonicClock
from app.hardware.chair.packet import COMMAND_MAGIC, FRAME_BYTES, TELEMETRY_MAGIC, VERSION

KEY_ID = 1
BURST = 50  # datagrams that one system call sends, where the kernel can
UDP_SEGMENT = 103  # Linux, linux/udp.h: one long datagram leaves as many of this size
_HEAD = Struct("<4sBBH")
MAGICS = {"W": COMMAND_MAGIC, "T": TELEMETRY_MAGIC}


class Flood:
    """Sends junk to one port, in bursts of `BURST`."""

    def __init__(self, port: int, magic: bytes, source: socket.socket) -> None:
        self._socket = source
        self._address = ("127.0.0.1", port)
        frames = [_HEAD.pack(magic, VERSION, 1, KEY_ID) + os.urandom(FRAME_BYTES - _HEAD.size) for _ in range(BURST)]
        self._frames, self._together = frames, b"".join(frames)
        self._splits = _splits(source)
        self.sent = 0

    def burst(self) -> None:
        """Send the next datagrams; those for which there is no room are not counted."""
        try:
            if self._splits:
                control = [(socket.IPPROTO_UDP, UDP_SEGMENT, FRAME_BYTES.to_bytes(2, sys.byteorder))]
                self._socket.sendmsg([self._together], control, 0, self._address)
                self.sent += BURST
                return
            for frame in self._frames:
                self._socket.sendto(frame, self._address)
                self.sent += 1
        except (BlockingIOError, ConnectionRefusedError):
            return


def _splits(source: socket.socket) -> bool:
    """Tell whether the kernel splits a long datagram."""
    try:
        source.getsockopt(socket.IPPROTO_UDP, UDP_SEGMENT)
    except OSError:
        return False
    return sys.platform == "linux"


def main(rate: float, seconds: float, targets: list[str]) -> None:
    """Send for `seconds`, then tell."""
    floods = []
    for target in targets:
        port, colour, descriptor = target.split(":")
        floods.append(Flood(int(port), MAGICS[colour], socket.socket(fileno=int(descriptor))))
    clock = MonotonicClock()
    begin = clock.now()
    for burst in range(round(rate * seconds / BURST)):
        clock.sleep_until(begin + burst * BURST / rate)
        for flood in floods:
            flood.burst()
    told = {"sent": [flood.sent for flood in floods], "begin": begin, "end": clock.now()}
    sys.stdout.write(f"{json.dumps(told)}\n")


if __name__ == "__main__":
    main(float(sys.argv[1]), float(sys.argv[2]), sys.argv[3:])
