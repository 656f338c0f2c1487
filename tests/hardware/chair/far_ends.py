"""What is at the far end of a serial output, in memory: a WHILL, and the board of the analog output.

Both are written from the descriptions of the bytes, not from the code that they test. The WHILL is the worst one that
can be: it holds its last speed for ever.
"""

import errno
import hashlib
import hmac
import struct
from binascii import crc_hqx

STEP_SPEED = 0.004 / 3.6  # m/s


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


class WhillChair:
    """A WHILL that drives exactly as it is commanded, its wheels `tread` m apart."""

    def __init__(self, tread=0.5):
        self.tread = tread
        self.front = self.side = 0  # steps of 0.004 km/h
        self.own_joystick_on = True
        self.joystick, self.battery, self.power, self.error = (0, 0), 80, 1, 0
        self.commands = []  # (t, payload)
        self._interval = self._due = None

    @property
    def v(self):
        return self.front * STEP_SPEED

    @property
    def omega(self):
        return -self.side * STEP_SPEED / self.tread

    def reboot(self):
        """Start anew: nothing is sent before somebody asks."""
        self._interval = None

    def take(self, frame, t):
        check = 0
        for byte in frame:
            check ^= byte
        assert (frame[0], frame[1], check) == (0xAF, len(frame) - 2, 0)
        payload = frame[2:-1]
        self.commands.append((t, payload))
        if payload[0] == 0:
            assert payload[1] == 1
            self._interval, self._due = int.from_bytes(payload[2:4], "big") / 1000, t
        elif payload[0] == 3:
            self.own_joystick_on = payload[1] == 1
            assert payload[2:] == b"\0\0"
            self.front = self.side = 0
        elif payload[0] == 8:
            self.own_joystick_on = payload[1] == 1
            self.front, self.side = struct.unpack(">hh", payload[2:])
            assert -500 <= self.front <= 1500
            assert -750 <= self.side <= 750
        else:
            raise AssertionError(payload)

    def sent(self, t):
        if self._interval is None or t < self._due:
            return b""
        self._due = t + self._interval
        return self.state()

    def state(self):
        """Return the bytes of data set 1."""
        right, left = self.front - self.side / 2, self.front + self.side / 2
        body = b"\x01" + bytes(12) + struct.pack(">bbB", *self.joystick, self.battery) + bytes(6)
        body += struct.pack(">hh", -round(right), round(left)) + bytes([self.power, 2, self.error, 7])
        frame = bytes([0xAF, len(body) + 1]) + body
        check = 0
        for byte in frame:
            check ^= byte
        return frame + bytes([check])


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
