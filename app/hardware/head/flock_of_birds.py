"""Ascension's Flock of Birds on a serial line, the tracker of the paper.

Its position and angles record is six words of two bytes, of which only the first byte has bit 7 set. Source: Ascension
Technology, Flock of Birds installation and operation guide, RS-232 commands and data formats.
"""

import math
import struct
from contextlib import suppress

import serial

from app.clock import Clock
from app.hardware.base import HardwareError
from app.hardware.configs import FlockOfBirdsConfig
from app.messages import ALIVE, HeadPose
from app.texts import Text

AUTO_CONFIGURE, GROUP_MODE = b"P\x32", b"P\x23\x01"
TO_UNIT = 0xF0  # plus an address: the next command goes to that unit
ANGLES, STREAM, STOP_STREAM = b"Y", b"@", b"?"
PAUSE = 0.35  # s; the manual asks for 0.3 before and after auto-configuring
WRITE_LIMIT = 0.5  # s

WORDS = 6  # x, y, z, then azimuth, elevation, roll
RECORD = 2 * WORDS  # bytes; in a group one more, the unit's address
PHASE = 0x80  # set in the first byte of a record, and in no other
INCH = 0.0254  # m
POSITION = 36.0 * INCH / 32768  # m of one step
ANGLE = math.pi / 32768  # rad of one step


class Records:
    """Splits a stream of bytes into records, from any byte on: a record begins at a byte with bit 7 set."""

    def __init__(self, size: int) -> None:
        self._size = size
        self._record = bytearray()

    def feed(self, content: bytes) -> list[bytes]:
        """Return the complete records that end in `content`."""
        whole = []
        for byte in content:
            if byte & PHASE:
                self._record = bytearray([byte])
            elif self._record:
                self._record.append(byte)
            if len(self._record) == self._size:
                whole.append(bytes(self._record))
                self._record.clear()
        return whole


def decode(record: bytes, t: float) -> HeadPose:
    """Return the pose of a record (of 12 bytes or more) that came at `t` (s).

    The unit's axes are ahead, right, down; its angles are azimuth (right positive), elevation (up), roll (right).
    """
    x, y, z, azimuth, elevation, roll = (_word(record[2 * i], record[2 * i + 1]) for i in range(WORDS))
    return HeadPose(t, -azimuth * ANGLE, elevation * ANGLE, roll * ANGLE, x * POSITION, -y * POSITION, -z * POSITION)


def _word(low: int, high: int) -> int:
    """Return a word from its bytes: 7 bits each, the highest ones of 16."""
    value: int = struct.unpack("<h", struct.pack("<H", (low & 0x7F) << 2 | (high & 0x7F) << 9))[0]
    return value


class FlockOfBirds:
    """One unit, alone or in a group."""

    def __init__(self, config: FlockOfBirdsConfig, clock: Clock) -> None:
        self._config = config
        self._clock = clock
        self._port: serial.Serial | None = None
        self._pose: HeadPose | None = None
        self._loss = ""
        self._new_records()

    def open(self) -> None:
        """Configure the unit and start its stream; in a group this takes a second.

        Raises
        ------
        HardwareError
            When the line cannot be opened or does not accept the commands.
        """
        self.close()
        self._loss = ""
        self._new_records()
        device, address = self._config.device, self._config.address
        try:
            self._port = serial.Serial(device, self._config.baud, timeout=0, write_timeout=WRITE_LIMIT)
            self._port.write(STOP_STREAM)
            if address is not None:
                self._configure_group(self._port, address)
            self._port.read(self._port.in_waiting)  # drop earlier bytes
            to_unit = b"" if address is None else bytes([TO_UNIT + address])
            self._port.write(to_unit + ANGLES)
            self._port.write(STREAM)
        except (OSError, ValueError) as error:  # a SerialException is an OSError
            self.close()
            raise HardwareError(Text("headdev-flock-failed", device=device, why=error)) from error

    def newest(self) -> HeadPose | None:
        """Take in the bytes that have come and return the newest pose, None before the first."""
        if self._port is None:
            return self._pose
        try:
            content = self._port.read(self._port.in_waiting)
        except OSError as error:
            self._loss = str(error) or "unknown"
            self._close_port()
            return self._pose
        now = self._clock.now()
        for record in self._records.feed(content):
            if self._config.address is None or record[RECORD] == self._config.address:
                self._pose = decode(record, now)
        return self._pose

    def description(self) -> Text:
        """Return the tracker's state in words."""
        device = self._config.device
        if self._loss:
            return Text("headdev-flock-lost", device=device, why=self._loss)
        if self._port is None:
            return Text("headdev-flock-closed", device=device)
        if self._pose is None or self._clock.now() - self._pose.t > ALIVE:
            return Text("headdev-flock-silent", device=device)
        return Text("headdev-flock", device=device)

    def close(self) -> None:
        """Stop the stream and close the line; closing twice does no harm."""
        if self._port is not None:
            with suppress(OSError):
                self._port.write(STOP_STREAM)
        self._close_port()
        self._pose = None

    def _configure_group(self, port: serial.Serial, address: int) -> None:
        for command in (AUTO_CONFIGURE + bytes([address]), GROUP_MODE):
            self._pause()
            port.write(command)
        self._pause()

    def _pause(self) -> None:
        self._clock.sleep_until(self._clock.now() + PAUSE)

    def _new_records(self) -> None:
        self._records = Records(RECORD if self._config.address is None else RECORD + 1)

    def _close_port(self) -> None:
        if self._port is not None:
            with suppress(OSError):
                self._port.close()
        self._port = None
