"""What is at the far end of a serial output, in memory: the line, and the board of the analog output.

The board is written from the description of its bytes, not from the code that it tests.
"""

import errno
import hashlib
import hmac
import struct
from binascii import crc_hqx


class MemoryPort:
    """In place of a serial line: what is written reaches the far end at once."""

    def __init__(self, far, device="/dev/far"):
        self.far, self.device = far, device
        self.pulled = self.hung = self.closed = False

    def read(self, t):
        self._check()
        return b"" if self.hung else self.far.sent(t)

    def write(self, frame, t):
        self._check()
        if self.hung:
            raise TimeoutError(errno.ETIMEDOUT, "takes nothing")
        self.far.take(frame, t)
        return True

    def close(self):
        self.closed = True

    def _check(self):
        if self.pulled:
            raise OSError(errno.ENODEV, "is gone")


class Board:
    """The board of the analog output: obeys commands in order, and is silent for 45 ms at most."""

    def __init__(self, secret):
        self.secret = secret
        self.boot, self.state, self.number = 1, 0, 0
        self.started = self.obeyed = self.due = None  # s
        self.deflection = (0, 0)  # per mille
        self.relay_closed = False
        self.dead = False  # does nothing at all
        self.commands = []  # of those that were obeyed: flags, forwards, right

    def reboot(self):
        self.boot += 1
        self.state, self.number, self.started, self.obeyed = 0, 0, None, None
        self.centre()

    def centre(self):
        self.deflection, self.relay_closed = (0, 0), False

    def time(self, t):
        if self.started is None:
            self.started = self.due = t
        return round(1000 * (t - self.started))

    def watch(self, t):
        if self.obeyed is not None and t - self.obeyed > 0.045:
            self.obeyed, self.number, self.state = None, 0, 0 if self.state < 3 else self.state
            self.centre()

    def take(self, frame, t):
        if self.dead:
            return
        self.watch(t)
        assert len(frame) == 38
        body, tag = frame[:22], frame[22:]
        magic, version, flags, forwards, right, number, answered, boot = struct.unpack("<4sBBhhIII", body)
        assert (magic, version) == (b"BMIC", 1)
        fresh = 0 <= self.time(t) - answered <= 100
        if hmac.new(self.secret, body, hashlib.sha256).digest()[:16] != tag or boot != self.boot or not fresh:
            return
        if number <= self.number or self.state >= 3:
            return
        if not flags & 1:
            self.state = 1
            self.centre()
        elif self.state == 0:
            return
        else:
            self.state, self.deflection, self.relay_closed = 2, (forwards, right), True
        self.number, self.obeyed = number, t
        self.commands.append((flags, forwards, right))

    def sent(self, t):
        time = self.time(t)
        self.watch(t)
        if self.dead or t < self.due:
            return b""
        self.due = t + 0.02
        return self.status(time)

    def status(self, time):
        body = struct.pack("<4sBBIII", b"BMIB", 1, self.state, self.number, time, self.boot)
        return body + struct.pack("<H", crc_hqx(body, 0xFFFF))
