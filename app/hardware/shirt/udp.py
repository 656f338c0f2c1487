"""A shirt that sends its frames as datagrams."""

import math
import select
import socket
import struct

from app.clock import Clock
from app.hardware.base import HardwareError
from app.hardware.configs import UdpConfig
from app.hardware.shirt.packet import LONGEST, decode, refusal
from app.hardware.shirt.sequence import Sequence
from app.messages import SensorFrame

BUFFER = 2 * LONGEST  # bytes: a longer datagram shows by its size
KERNEL_BUFFER = 1 << 20  # bytes: a second at 1 kHz, should the loop be held up
SILENCE = 2.0  # s without a frame after which another sender may be the shirt
ALIVE = 0.5  # s without a frame after which the words say so
_TIME = struct.Struct("@ll")  # struct timeval


class UdpShirt:
    """Listens on one address; from the first good frame on, only to the sender of that frame.

    Two senders at once would be mixed into one body, so a second one is not heard until the first has been silent for
    `SILENCE` seconds.
    """

    def __init__(self, config: UdpConfig, clock: Clock) -> None:
        self.layout = config.layout
        self.sample_rate = config.sample_rate
        self.address: tuple[str, int] = (config.host, config.port)  # with the true port once open
        self.junk = 0  # datagrams that were no frame of this shirt
        self._clock = clock
        self._channels = len(config.layout.channels)
        self._sequence = Sequence()
        self._socket: socket.socket | None = None
        self._buffer = bytearray(BUFFER)
        self._timeout = -1.0  # s, which the kernel was told
        self._wait = -1.0  # s, which was asked for last
        self._sender: tuple[str, int] | None = None
        self._candidate: tuple[str, int] = ("", 0)
        self._heard = -math.inf  # monotonic s
        self._refusal = ""

    @property
    def lost(self) -> int:
        """Frames missing in the shirt's own count since it was opened."""
        return self._sequence.lost

    def open(self) -> None:
        """Listen.

        Raises
        ------
        HardwareError
            When the address is not this machine's, or its port is taken.
        """
        self.close()
        self._sequence = Sequence()
        self.junk = 0
        self._refusal = ""
        self._heard = -math.inf
        self._socket = self._bound()
        self.address = (self.address[0], self._socket.getsockname()[1])

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame, waiting for it at most `timeout` (s); junk is counted and passed over."""
        now = self._clock.now()
        deadline = now + timeout
        wait = timeout
        while True:
            size = self._receive(wait)
            now = self._clock.now()
            if size < 0:
                if self._sender is not None and now - self._heard > SILENCE:
                    self._listen_to_all()
                return None
            packet = decode(self._buffer, size, self._channels)
            if packet is None:
                self.junk += 1
                self._refusal = refusal(self._buffer, size, self._channels)
            else:
                seq, microseconds, values = packet
                self._heard = now
                if self._sender is None:
                    self._listen_to_one()
                if self._sequence.takes(seq):
                    return SensorFrame(seq, microseconds * 1e-6, now, values)
            wait = deadline - now
            if wait <= 0.0:
                return None

    def pending(self) -> bool:
        """Return whether a datagram is there already."""
        if self._socket is None:
            return False
        try:
            self._socket.recv_into(self._buffer, 1, socket.MSG_PEEK | socket.MSG_DONTWAIT)
        except OSError:
            return False
        return True

    def words(self) -> str:
        """Return the shirt's state in words."""
        why = f" ({self._refusal})" if self._refusal else ""
        if self._socket is None:
            return f"The shirt is not listened for{why}."
        host, port = self.address
        if self._clock.now() - self._heard > ALIVE:
            return f"No frames from a shirt on {host}:{port}{why}."
        sender = "" if self._sender is None else f" from {self._sender[0]}:{self._sender[1]}"
        words = f"Shirt on {host}:{port}{sender}, {self._channels} channels"
        if self._sequence.lost:
            words += f", {self._sequence.lost} frames lost"
        if self.junk:
            words += f", {self.junk} datagrams refused{why}"
        return f"{words}."

    def close(self) -> None:
        """Give the port back."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None
        self._sender = None
        self._timeout = -1.0

    def _receive(self, wait: float) -> int:
        """Return the size of the next datagram in the buffer, -1 when none came within `wait` (s)."""
        if self._socket is None:
            self._clock.sleep_until(self._clock.now() + wait)
            return -1
        flags = 0
        if wait <= 0.0:
            flags = socket.MSG_DONTWAIT
        elif wait == self._wait:
            self._tell_kernel(wait)
        elif wait != self._timeout:
            # The kernel counts its own timeout in ticks of up to 10 ms: too coarse for one that differs each time.
            self._wait = wait
            flags = socket.MSG_DONTWAIT
            if not select.select([self._socket], [], [], wait)[0]:
                return -1
        try:
            if self._sender is not None:
                return self._socket.recv_into(self._buffer, 0, flags)
            size, self._candidate = self._socket.recvfrom_into(self._buffer, 0, flags)
        except (BlockingIOError, ConnectionError):
            return -1
        return size

    def _tell_kernel(self, wait: float) -> None:
        """Wait by the kernel's own timeout: one call for each frame, where a timeout of Python's would be two."""
        if self._socket is not None and wait != self._timeout:
            seconds, fraction = divmod(max(wait, 1e-6), 1.0)
            self._socket.setsockopt(
                socket.SOL_SOCKET, socket.SO_RCVTIMEO, _TIME.pack(int(seconds), int(fraction * 1e6))
            )
            self._timeout = wait

    def _listen_to_one(self) -> None:
        if self._socket is not None:
            self._socket.connect(self._candidate)
            self._sender = self._candidate[:2]

    def _listen_to_all(self) -> None:
        """Hear any sender again: only a new socket on the same port can."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None
            self._sender = None
            self._timeout = -1.0
            try:
                self._socket = self._bound()
            except HardwareError as error:
                self._refusal = str(error)

    def _bound(self) -> socket.socket:
        host, port = self.address
        try:
            family, kind, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_DGRAM)[0]
        except OSError as error:
            raise HardwareError(
                f"the shirt cannot be listened for on {host}: this is no address, correct it"
            ) from error
        listening = socket.socket(family, kind)
        try:
            listening.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, KERNEL_BUFFER)
            listening.bind(address)
        except OSError as error:
            listening.close()
            raise HardwareError(
                f"the shirt cannot be listened for on {host}:{port} ({error.strerror}): "
                f"use an address of this machine and a port that is free"
            ) from error
        return listening
