"""A head tracker that sends its poses as datagrams: each reading takes all of them in and keeps the last good pose."""

import math
import socket
from collections.abc import Callable

from app.clock import Clock
from app.hardware.base import HardwareError
from app.messages import ALIVE, HeadPose
from app.texts import Text

HEAD_SENDER_SILENCE = 2.0  # s without a pose until another sender is accepted
MOST = 64  # datagrams of one reading, so that a flood does not hold up the loop
KERNEL_BUFFER = 1 << 16  # bytes

Decode = Callable[[bytes, float], HeadPose | None]
"""From a datagram and its time of arrival (monotonic s) to a pose, None for any other datagram."""


class UdpHead:
    """Listens on one address; accepts only the sender of the first good pose, until that has been silent for 2 s."""

    def __init__(self, name: str, host: str, port: int, size: int, decode: Decode, clock: Clock) -> None:
        """`size` is the length of a datagram in bytes; `name` names the tracker in sentences."""
        self.address: tuple[str, int] = (host, port)  # with the true port once open
        self.junk = 0  # datagrams that are no pose
        self._name = name
        self._size = size
        self._decode = decode
        self._clock = clock
        self._socket: socket.socket | None = None
        self._sender: object = None
        self._pose: HeadPose | None = None

    def open(self) -> None:
        """Open the socket; HardwareError when the address is not of this machine or its port is in use."""
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
            why = error.strerror or "no-address"
            raise HardwareError(
                Text("headdev-udp-failed", tracker=self._name, place=f"{host}:{port}", why=why)
            ) from error
        self._socket = listening
        self.address = (host, listening.getsockname()[1])
        self.junk = 0

    def newest(self) -> HeadPose | None:
        """Take in the datagrams that have come and return the newest pose, None before the first."""
        if self._socket is None:
            return self._pose
        now = self._clock.now()
        for _ in range(MOST):
            try:
                datagram, sender = self._socket.recvfrom(self._size + 1)  # one byte more shows what is too long
            except OSError:
                break
            if self._pose is not None and now - self._pose.t > HEAD_SENDER_SILENCE:
                self._sender = None
            pose = self._decode(datagram, now) if len(datagram) == self._size else None
            if pose is None or not all(map(math.isfinite, pose)):
                self.junk += 1
            elif self._sender in (None, sender):
                self._sender, self._pose = sender, pose
        return self._pose

    def description(self) -> Text:
        """Return the tracker's state in words."""
        if self._socket is None:
            return Text("headdev-udp-closed", tracker=self._name)
        host, port = self.address
        place = f"{host}:{port}"
        if self._pose is None or self._clock.now() - self._pose.t > ALIVE:
            return Text("headdev-udp-silent", tracker=self._name, place=place, refused=self.junk)
        return Text("headdev-udp", tracker=self._name, place=place, refused=self.junk)

    def close(self) -> None:
        """Close the socket; closing twice does no harm."""
        if self._socket is not None:
            self._socket.close()
        self._socket = self._sender = self._pose = None
