"""An emulated WHILL: for a rehearsal on a desk, and for tests. Standard library only.

Written from the description of the bytes (`app.hardware.chair.whill` names the source), not from the code that sends
them. It is the worst chair that can be: it holds its last speed for ever, because the maker does not say that a WHILL
stops by itself when commands end.
"""

import os
import pty
import select
import struct
import threading
from contextlib import suppress

from app.clock import monotonic

STEP_SPEED = 0.004 / 3.6  # m/s
MOST_BYTES = 4096
PAUSE = 0.005  # s between two answers


class EmulatedWhill:
    """A WHILL in memory that drives exactly as it is commanded.

    Attributes
    ----------
    front, side : int
        What it was commanded last, in steps of 0.004 km/h.
    commands : list of (float, bytes)
        When each payload came (s), and its bytes.
    """

    def __init__(self, tread: float = 0.5) -> None:
        """`tread` is m between its wheels."""
        self.tread = tread
        self.front = self.side = 0
        self.own_joystick_on = True
        self.joystick, self.battery, self.power, self.error = (0, 0), 80, 1, 0
        self.commands: list[tuple[float, bytes]] = []
        self._interval: float | None = None  # s between two states; None: nobody has asked for them
        self._due = 0.0  # s

    @property
    def v(self) -> float:
        """Its speed, m/s."""
        return self.front * STEP_SPEED

    @property
    def omega(self) -> float:
        """Its turn rate, rad/s."""
        return -self.side * STEP_SPEED / self.tread

    def reboot(self) -> None:
        """Start anew: nothing is sent before somebody asks."""
        self._interval = None

    def take(self, frame: bytes, t: float) -> None:
        """Obey a frame that came at `t` (s); raise ValueError for one that the maker's description does not have."""
        payload = frame[2:-1]
        if (frame[0], frame[1], _check(frame)) != (0xAF, len(frame) - 2, 0):
            raise ValueError(f"no frame: {frame.hex()}")
        self.commands.append((t, payload))
        if payload[:2] == b"\0\x01":
            self._interval, self._due = int.from_bytes(payload[2:4], "big") / 1000, t
        elif payload[0] == 3 and payload[2:] == b"\0\0":
            self.own_joystick_on = payload[1] == 1
            self.front = self.side = 0
        elif payload[0] == 8:
            front, side = struct.unpack(">hh", payload[2:])
            if not (-500 <= front <= 1500 and -750 <= side <= 750):
                raise ValueError(f"too fast: {front}, {side}")
            self.own_joystick_on = payload[1] == 1
            self.front, self.side = front, side
        else:
            raise ValueError(f"no command: {payload.hex()}")

    def sent(self, t: float) -> bytes:
        """Return what it sends at `t` (s)."""
        if self._interval is None or t < self._due:
            return b""
        self._due = t + self._interval
        return self.state()

    def state(self) -> bytes:
        """Return the bytes of data set 1."""
        right, left = self.front - self.side / 2, self.front + self.side / 2
        body = b"\x01" + bytes(12) + struct.pack(">bbB", *self.joystick, self.battery) + bytes(6)
        body += struct.pack(">hh", -round(right), round(left)) + bytes([self.power, 2, self.error, 7])
        frame = bytes([0xAF, len(body) + 1]) + body
        return frame + bytes([_check(frame)])


class EmulatedWhillLine(EmulatedWhill):
    """An emulated WHILL at the end of a pseudo-terminal, in a thread, until it is closed.

    Attributes
    ----------
    device : str
        The serial line to open.
    unplugged : bool
        Whether nothing passes the cable.
    """

    def __init__(self) -> None:
        super().__init__()
        self.unplugged = False
        self._line, self._far = pty.openpty()
        os.set_blocking(self._line, False)
        self.device = os.ttyname(self._far)
        self._ending = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """End the thread, and close the line."""
        self._ending.set()
        self._thread.join()
        os.close(self._line)
        os.close(self._far)

    def _run(self) -> None:
        received = b""
        while not self._ending.is_set():
            with suppress(OSError):
                if select.select([self._line], [], [], PAUSE)[0]:
                    received += os.read(self._line, MOST_BYTES)
            if self.unplugged:
                received = b""
                continue
            while len(received) > 1 and len(received) >= (size := received[1] + 2):
                self.take(received[:size], monotonic())
                received = received[size:]
            with suppress(OSError):
                os.write(self._line, self.sent(monotonic()))


def _check(content: bytes) -> int:
    check = 0
    for byte in content:
        check ^= byte
    return check
