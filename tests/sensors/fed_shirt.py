"""Drivers whose device is reached by a library: a fake of it is here, and what its far end sends comes by UDP."""

import socket
import threading

LONGEST = 4096  # bytes
ADDRESS = 6  # bytes, of a Bluetooth sensor


class FedShirt:
    """A driver, and the thread that hands the datagrams of a far end to its library, while it is open.

    Attributes
    ----------
    address : tuple
        Where it listens to its far end.
    """

    def __init__(self, shirt, take):
        """`take` hands a datagram to the library."""
        self._shirt, self._take = shirt, take

    def __getattr__(self, name):
        return getattr(self._shirt, name)

    def open(self):
        self._shirt.open()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self.address = self._socket.getsockname()
        self._thread = threading.Thread(target=self._hand_on, name="library", daemon=True)
        self._thread.start()

    def close(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
            out.sendto(b"", self.address)
        self._thread.join()
        self._socket.close()
        self._shirt.close()

    def _hand_on(self):
        while datagram := self._socket.recv(LONGEST):
            self._take(datagram)


def take_notification(bleak, datagram):
    """Let a sensor of the fake `bleak` send: a datagram is its address (6 bytes) and the content."""
    address = datagram[:ADDRESS].hex(":").upper()
    sensor = next(sensor for sensor in bleak.sensors if sensor.address == address)
    if sensor.is_asked:
        sensor.send(datagram[ADDRESS:])
