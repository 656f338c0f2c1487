"""The bytes of WitMotion's Bluetooth sensors (WT901BLE and its like): what they send, what sets them up. No radio.

Source: WitMotion, WT901BLECL datasheet v20-0707, section 6; WT901BLE5.0 communication protocol.
"""

from struct import Struct
from typing import Final, NamedTuple

import numpy as np

from app.hardware.shirt.orientation_sensors.orientation import Rotations, exponential, product

NAME_BEGINS: Final = "WT"  # of the names that these sensors announce
NOTIFIED: Final = "0000ffe4-0000-1000-8000-00805f9a34fb"
"""The characteristic by which a sensor sends."""
WRITTEN: Final = "0000ffe9-0000-1000-8000-00805f9a34fb"
"""The characteristic by which it is set up."""

MOTION: Final = b"\x55\x61"
REGISTERS: Final = b"\x55\x71"
HEADS: Final = (MOTION, REGISTERS)
SIZE: Final = 20  # bytes of either
ANGLES: Final = Struct("<14x3h")
"""Behind acceleration and turn rate: roll about x, pitch about y, yaw about z, in steps of 180/32768 degrees."""
REGISTER: Final = Struct("<2xHH")
"""The number of the first register in an answer, and its content."""
STEP_DEG: Final = 180.0 / 32768.0
STEEPEST_DEG: Final = 90.1  # the pitch of Z-Y-X angles is at most 90 degrees
VOLTAGE: Final = 0x64  # the register of the battery, in 0.01 V
LOW_VOLTS: Final = 3.7  # of a lithium cell: nearly empty

RATES: Final = {10: 0x06, 20: 0x07, 50: 0x08, 100: 0x09}  # Hz, with the content of the register of the rate
UNLOCK: Final = b"\xff\xaa\x69\x88\xb5"
ASK_VOLTAGE: Final = bytes((0xFF, 0xAA, 0x27, VOLTAGE, 0x00))


class SensorMotion(NamedTuple):
    """What a sensor has measured."""

    content: bytes  # acceleration, turn rate and angles as they were sent
    angles_deg: tuple[float, float, float]  # roll, pitch, yaw


class SensorVoltage(NamedTuple):
    """The voltage of a sensor's battery."""

    volts: float


class SensorDecoder:
    """Decodes the notifications of one connection, each of which holds one frame, several, or a part of one.

    Frames carry no count, no time and no checksum. A notification that begins like a frame ends an incomplete one.

    Attributes
    ----------
    junk : int
        Notifications that are none of such a sensor.
    """

    def __init__(self) -> None:
        self.junk = 0
        self._rest = b""

    def feed(self, content: bytes) -> list[SensorMotion | SensorVoltage]:
        """Return what a notification completes."""
        piece = content if content[:2] in HEADS else self._rest + content
        found, count = list[SensorMotion | SensorVoltage](), 0
        while len(piece) >= SIZE and piece[:2] in HEADS:
            decoded = _decoded(piece[:SIZE])
            found += [] if decoded is None else [decoded]
            piece, count = piece[SIZE:], count + 1
        self._rest = piece if piece[:2] in HEADS else b""  # newer sensors send more behind the angles
        self.junk += not count and not self._rest
        return found

    def begin_anew(self) -> None:
        """Expect the notifications of another connection."""
        self._rest = b""


def set_up_commands(sample_rate: float) -> tuple[bytes, ...]:
    """Return what lets a sensor send at least `sample_rate` times a second, or as often as it can, until it is off."""
    rate = next((rate for rate in RATES if rate >= sample_rate), max(RATES))
    return UNLOCK, bytes((0xFF, 0xAA, 0x03, RATES[rate], 0x00))


def sensor_orientation(roll_deg: float, pitch_deg: float, yaw_deg: float) -> Rotations:
    """Return the orientation (4,) of a sensor: it turns by yaw about z, then by pitch about y, then by roll about x.

    These are intrinsic Z-Y'-X'' angles of a sensor whose z points upwards (datasheet, section 6.1.1, note 1).
    """
    turns = exponential(np.radians(np.array(((0.0, 0.0, yaw_deg), (0.0, pitch_deg, 0.0), (roll_deg, 0.0, 0.0)))))
    return product(product(turns[0], turns[1]), turns[2])


def _decoded(frame: bytes) -> SensorMotion | SensorVoltage | None:
    """Return what a frame (SIZE bytes) holds; None when that is impossible, or of no use."""
    if frame[:2] == MOTION:
        roll, pitch, yaw = (STEP_DEG * step for step in ANGLES.unpack(frame))
        return SensorMotion(frame[2:], (roll, pitch, yaw)) if abs(pitch) <= STEEPEST_DEG else None
    register, content = REGISTER.unpack_from(frame)
    return SensorVoltage(content / 100.0) if register == VOLTAGE else None
