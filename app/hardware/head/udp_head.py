"""A head tracker that sends its poses as datagrams: all that is there is read at once, and the last good one kept."""

import math
import socket
from collections.abc import Callable

from app.clock import Clock
from app.hardware.base import HardwareError
from app.messages import HeadPose

SILENCE = 2.0  # s without a pose after which another sender may be the tracker
ALIVE = 0.5  # s without a pose after which the words say so
MOST = 64  # datagrams in one look: the loop lives on in a flood
KERNEL_BUFFER = 1 << 16  # bytes

Decode = Callable[[bytes, float], HeadPose | None]
"""A datagram and when it came (monotonic s): its pose, None when it is none."""


class UdpHead:
    """Listens on one address; from the first good pose on, only to its sender, until that has been silent for 2 s."""

    def __init__(self, name: str, host: str, port: int, size: int, decode: Decode, clock: Clock) -> None:
        """`size` is that of its datagrams, in bytes; `name` is what people call such a tracker."""
        self.address: tuple[str, int] = (host, port)  # with the true port once open
        self.junk = 0  # datagrams that were no pose
        self._name = name
        self._size = size
        self._decode = decode
        self._clock = clock
        self._socket: socket.socket | None = None
        self._sender: object = None
        self._pose: HeadPose | None = None

    def open(self) -> None:
        """Listen; HardwareError when the address is not this machine's, or its port is taken."""
        self.close()
        host, port = self.address
        listening: socket.socket | None = None
        try:
            family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
            listening = socket.socket(family, kind)
            listening.setblocking(False)
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, KERNEL_BUFFER)
            listening.bind(address)
        except OSError as error:
            if listening is not None:
                listening.close()
            raise HardwareError(
                f"the head tracker {self._name} cannot be listened for on {host}:{port} "
                f"({error.strerror or 'no such address'}): use an address of this machine and a port that is free"
            ) from error
        self._socket = listening
        self.address = (host, listening.getsockname()[1])
        self.junk = 0

    def newest(self) -> HeadPose | None:
        """Take in what has come and return the newest pose, None before the first."""
        if self._socket is None:
            return self._pose
        now = self._clock.now()
        for _ in range(MOST):
            try:
                datagram, sender = self._socket.recvfrom(self._size + 1)  # the one more shows what is too long
            except OSError:
                break
            if self._pose is not None and now - self._pose.t > SILENCE:
                self._sender = None
            pose = self._decode(datagram, now) if len(datagram) == self._size else None
            if pose is None or not all(map(math.isfinite, pose)):
                self.junk += 1
            elif self._sender in (None, sender):
                self._sender, self._pose = sender, pose
        return self._pose

    def words(self) -> str:
        """Return the tracker's state in words."""
        if self._socket is None:
            return f"The head tracker {self._name} is not listened for."
        host, port = self.address
        refused = f", {self.junk} datagrams refused" if self.junk else ""
        if self._pose is None or self._clock.now() - self._pose.t > ALIVE:
            return f"No poses from {self._name} on {host}:{port}{refused}."
        return f"Head tracker {self._name} on {host}:{port}{refused}."

    def close(self) -> None:
        """Give the port back."""
        if self._socket is not None:
            self._socket.close()
        self._socket = self._sender = self._pose = None
