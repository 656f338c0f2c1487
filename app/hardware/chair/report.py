"""Reports the pose of the virtual chair to another program, one datagram a tick; a report, never a command."""

import socket
from contextlib import suppress
from struct import Struct

from app.hardware.base import HardwareError
from app.messages import Tick
from app.texts import Text

MAGIC, VERSION = b"BMIP", 1

REPORT = Struct("<4sBBHIQffffff")
"""docs/protocols.md, section 7: magic, version, state, 0, frame seq, monotonic ns, x, y, theta, v, omega, 0."""


def encode_report(tick: Tick) -> bytes:
    """Return the datagram of a tick: `t` in ns, pose in m and rad, speeds in m/s and rad/s."""
    return REPORT.pack(
        MAGIC,
        VERSION,
        tick.state,
        0,
        tick.frame_seq,
        int(tick.t * 1e9),
        tick.x,
        tick.y,
        tick.theta,
        tick.v,
        tick.omega,
        0.0,
    )


class ChairReport:
    """Sends reports to one address; a report that cannot be sent is dropped."""

    def __init__(self, host: str, port: int) -> None:
        """Open a socket for `host`, or raise HardwareError."""
        try:
            family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
            self._socket = socket.socket(family, kind, protocol)
        except OSError as error:
            why = error.strerror or "no-address"
            raise HardwareError(Text("chairdev-no-report", place=f"{host}:{port}", why=why)) from error
        self._socket.setblocking(False)
        self._address = address

    def send(self, tick: Tick) -> None:
        """Send a tick; never waits."""
        with suppress(OSError):  # nobody listens, or no room: the next report is newer
            self._socket.sendto(encode_report(tick), self._address)

    def close(self) -> None:
        """Close the socket."""
        self._socket.close()
