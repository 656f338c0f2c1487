"""A Flock of Birds unit on a pseudo terminal: checks the commands byte for byte, and sends records on request."""

import os
import pty
import select
import threading
import tty

from app.hardware.head.flock_of_birds import PHASE


def encode(words: tuple[int, ...], address: int | None = None) -> bytes:
    """Return the record of six words (int16, their two lowest bits lost), as a unit sends it."""
    record = bytearray()
    for word in words:
        bits = word & 0xFFFF
        record += bytes([bits >> 2 & 0x7F, bits >> 9 & 0x7F])
    record[0] |= PHASE
    return bytes(record) if address is None else bytes([*record, address])


class FlockUnit:
    """One unit; each `send` sends a record, once position and angles are streamed."""

    def __init__(self, address=None):
        self.address = address
        self.commands = bytearray()
        self.group = self.streams = self.angles = False
        self._master, slave = pty.openpty()
        tty.setraw(slave)
        self.device = os.ttyname(slave)
        self._slave = slave
        self._told = threading.Condition()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._listen, daemon=True)
        self._thread.start()

    def _listen(self):
        while not self._ended.is_set():
            if not select.select([self._master], [], [], 0.02)[0]:
                continue
            try:
                content = os.read(self._master, 256)
            except OSError:
                return
            with self._told:
                for byte in content:
                    self._take(byte)
                self._told.notify_all()

    def _take(self, byte):
        self.commands.append(byte)
        said = bytes(self.commands)
        if said.endswith(b"P\x23\x01"):
            self.group = True
        elif said.endswith(b"Y"):
            self.angles = self.address is None or said.endswith(bytes([0xF0 + self.address]) + b"Y")
        elif said.endswith(b"@"):
            self.streams = True
        elif said.endswith(b"?"):
            self.streams = False

    def wait_for(self, true):
        """Wait until a condition holds."""
        with self._told:
            assert self._told.wait_for(true, 20), bytes(self.commands)

    def send(self, words, address=None):
        """Send one record: x, y, z, azimuth, elevation, roll as words."""
        self.wait_for(lambda: self.streams and self.angles)
        self.send_bytes(encode(words, (address or self.address) if self.group else None))

    def send_bytes(self, content):
        """Send arbitrary bytes."""
        os.write(self._master, content)

    def unplug(self):
        """Disconnect the line."""
        self._ended.set()
        self._thread.join()
        for end in (self._slave, self._master):
            if end is not None:
                os.close(end)
        self._slave = self._master = None

    def end(self):
        """Release everything."""
        if self._master is not None:
            self.unplug()
