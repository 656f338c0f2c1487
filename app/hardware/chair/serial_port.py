"""A serial line that never waits, for the outputs that drive a chair over one. Standard library only."""

import errno
import fcntl
import os
import struct
import termios
from contextlib import suppress

from app.hardware.chair.outputs import OutputRefused

SPEEDS = {38_400: termios.B38400, 115_200: termios.B115200}
HUNG = 0.1  # s after which a line that has not sent a frame hangs; the slowest sends one in 4 ms
REOPEN_EVERY = 1.0  # s between two tries to open a line that was lost
MOST_BYTES = 4096  # of one reading: the kernel keeps no more of a line


class SerialPort:
    """A raw line of 8 data bits, no parity and one stop bit, which no other program opens meanwhile.

    At most one frame waits in the line: a newer one is left out until it is sent, so that a line that hung and goes on
    delivers no old commands. A line that was pulled out is opened again when it is back; opening may take a moment, and
    then the receiver has stopped already.
    """

    def __init__(self, device: str, baud: int) -> None:
        """Open the line; raise OutputRefused, in one sentence, when that is not possible."""
        self.device = device
        self._speed = SPEEDS[baud]
        self._handle: int | None = None
        self._rest = b""  # of a frame that was written in part
        self._free_t: float | None = None  # s, when the line took a whole frame last; None: it has not been asked to
        self._reopen_due = 0.0  # s
        try:
            self._handle = _opened(device, self._speed)
        except OSError as error:
            why = error.strerror or error
            raise OutputRefused(f"the serial line {device} cannot be opened ({why}): {_remedy(error)}") from error

    def read(self, t: float) -> bytes:
        """Return what has come up to `t` (s), empty when nothing has. OSError: the line is gone."""
        handle = self._current(t)
        try:
            content = os.read(handle, MOST_BYTES)
        except BlockingIOError:
            return b""
        except OSError:
            self._lose(t)
            raise
        if not content:  # a line that was pulled out ends
            self._lose(t)
            raise self._gone()
        return content

    def write(self, frame: bytes, t: float) -> bool:
        """Write a frame at `t` (s); return False when one before it still waits.

        Raises
        ------
        OSError
            When a frame has waited for over `HUNG` seconds, or the line is gone.
        """
        if self._handle is None:
            raise self._gone()
        if self._free_t is None:
            self._free_t = t
        try:
            self._rest = self._rest[self._put(self._handle, self._rest) :]
            if not self._rest and not _queued(self._handle) and (count := self._put(self._handle, frame)):
                self._rest = frame[count:]
                self._free_t = t
                return True
        except OSError:
            self._lose(t)
            raise
        if t - self._free_t > HUNG:
            raise TimeoutError(errno.ETIMEDOUT, f"{self.device} takes nothing")
        return False

    def close(self) -> None:
        """Close the line; closing twice does no harm."""
        if self._handle is not None:
            handle, self._handle = self._handle, None
            with suppress(OSError):
                os.close(handle)

    def _current(self, t: float) -> int:
        """Return the open line; open a lost one again when that is due."""
        if self._handle is None:
            if t < self._reopen_due:
                raise self._gone()
            self._reopen_due = t + REOPEN_EVERY
            self._handle = _opened(self.device, self._speed)
            self._rest, self._free_t = b"", None
        return self._handle

    def _lose(self, t: float) -> None:
        self.close()
        self._reopen_due = t + REOPEN_EVERY

    def _gone(self) -> OSError:
        return OSError(errno.ENODEV, f"{self.device} is gone")

    @staticmethod
    def _put(handle: int, content: bytes) -> int:
        """Write what the line takes now, and return how many bytes that were."""
        try:
            return os.write(handle, content) if content else 0
        except BlockingIOError:
            return 0


def _opened(device: str, speed: int) -> int:
    """Return the handle of a raw line without anything that came before; raise OSError when it is none."""
    handle = os.open(device, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        attributes = termios.tcgetattr(handle)
        control = attributes[6]
        control[termios.VMIN], control[termios.VTIME] = 1, 0
        flags = termios.CS8 | termios.CREAD | termios.CLOCAL
        termios.tcsetattr(handle, termios.TCSANOW, [0, 0, flags, 0, speed, speed, control])
        termios.tcflush(handle, termios.TCIOFLUSH)
    except termios.error as error:
        os.close(handle)
        raise OSError(*error.args) from error
    except OSError:
        os.close(handle)
        raise
    return handle


def _queued(handle: int) -> int:
    """Return how many bytes the line has not sent yet; 0 where its driver does not say."""
    count: int = struct.unpack("i", fcntl.ioctl(handle, termios.TIOCOUTQ, bytes(4)))[0]
    return count


def _remedy(error: OSError) -> str:
    if error.errno in (errno.EACCES, errno.EPERM):
        return "let this account use serial lines, on Debian by the group dialout"
    if error.errno in (errno.EAGAIN, errno.EBUSY):
        return "another program uses it, end that"
    return "plug it in, or see under /dev/serial/by-id/ what it is called"
