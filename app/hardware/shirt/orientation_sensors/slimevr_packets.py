"""The datagrams of SlimeVR's trackers, big-endian, as SlimeVR-Tracker-ESP and owoTrack send them; no socket.

A tracker sends u32 kind, u64 packet number, content. Kinds that are not named here say nothing about movements.
"""

import math
from collections.abc import Callable, Mapping
from struct import Struct
from typing import Final, NamedTuple

from app.hardware.shirt.orientation_sensors.orientation import Rotations, unit_quaternion

LONGEST: Final = 512  # bytes; the longest known one has fewer than 200
HANDSHAKE, ROTATION_OF_FIRST, ACCELERATION, BATTERY, SENSOR, ROTATION_OF_SECOND = 3, 1, 4, 12, 15, 16
ROTATION, FLEX = 17, 26
OTHER_KINDS: Final = frozenset({0, 2, 10, 11, 13, 14, 18, 19, 20, 21, 22, 60, 61})
"""Heartbeat, turn rate, ping, serial line, tap, error, compass, radio, temperature, buttons, features."""
NORMAL: Final = 1  # kind of a rotation; the other one is a correction by a compass

HEAD: Final = Struct(">IQ")
HANDSHAKE_REPLY: Final = b"\x03Hey OVR =D 5"
HEARTBEAT: Final = HEAD.pack(1, 0)

_BUILD: Final = Struct(">7IB")  # board, sensor, processor, three of 0, protocol; length of the firmware's name
_QUATERNION: Final = Struct(">4f")
_ROTATION: Final = Struct(">BB4fB")  # sensor, kind, x, y, z, w, accuracy
_ACCELERATION: Final = Struct(">3f")  # behind it the sensor's number; owoTrack and early firmware have one sensor
_FLEX: Final = Struct(">Bf")
_BATTERY: Final = Struct(">2f")
_SHARE: Final = Struct(">f")
_SENSOR: Final = Struct(">BB")
_ACKNOWLEDGEMENT: Final = Struct(">IBB")
_MAC_BYTES: Final = 6


class TrackerHandshake(NamedTuple):
    """A tracker looks for a server."""

    mac: str  # its address: A1:B2:C3:D4:E5:F6


class TrackerSensor(NamedTuple):
    """A tracker reports a sensor until that is acknowledged."""

    sensor: int
    state: int  # 0 absent, 1 works, 2 is broken


class TrackerRotation(NamedTuple):
    """The orientation of a sensor."""

    sensor: int
    orientation: Rotations  # (4,) x, y, z, w


class TrackerAcceleration(NamedTuple):
    """A sensor has measured: standard firmware sends its acceleration behind an orientation, some sends it alone, too.

    Source: SlimeVR-Tracker-ESP, issue 267 and pull request 269; issue 546 asks for acceleration alone.
    """

    sensor: int


class TrackerFlex(NamedTuple):
    """A sample of a strain sensor."""

    sensor: int
    value: float  # resistance, in the sensor's own unit


class TrackerBattery(NamedTuple):
    """The charge of a tracker."""

    share: float  # 0 to 1


TrackerContent = (
    TrackerHandshake | TrackerSensor | TrackerRotation | TrackerAcceleration | TrackerFlex | TrackerBattery | None
)
"""None: nothing that is needed, though the tracker lives."""


class TrackerPacket(NamedTuple):
    """A datagram of a tracker."""

    number: int  # counts up from 0 since the tracker was started; a handshake always has 0
    content: TrackerContent


def read_packet(datagram: bytes) -> TrackerPacket | None:
    """Return what is in a datagram, None when it is not one of a tracker."""
    if not HEAD.size <= len(datagram) <= LONGEST:
        return None
    kind, number = HEAD.unpack_from(datagram)
    content = datagram[HEAD.size :]
    if kind in OTHER_KINDS:
        return TrackerPacket(number, None)
    read = _READERS.get(kind)
    if read is None:
        return None
    size, reader = read
    if len(content) < size:
        return None
    try:
        return TrackerPacket(number, reader(content))
    except ValueError:
        return None


def sensor_acknowledgement(sensor: TrackerSensor) -> bytes:
    """Return the answer to a tracker that has reported a sensor."""
    return _ACKNOWLEDGEMENT.pack(SENSOR, sensor.sensor, sensor.state)


def _handshake(content: bytes) -> TrackerHandshake:
    length = _BUILD.unpack_from(content)[-1]
    address = content[_BUILD.size + length :][:_MAC_BYTES]
    if len(address) < _MAC_BYTES or not any(address):
        raise ValueError
    return TrackerHandshake(address.hex(":").upper())


def _rotation(content: bytes) -> TrackerRotation | None:
    sensor, kind, *quaternion, _ = _ROTATION.unpack_from(content)
    return TrackerRotation(sensor, _orientation(*quaternion)) if kind == NORMAL else None


def _rotation_of_first(content: bytes) -> TrackerRotation:
    return TrackerRotation(0, _orientation(*_QUATERNION.unpack_from(content)))


def _rotation_of_second(content: bytes) -> TrackerRotation:
    return TrackerRotation(1, _orientation(*_QUATERNION.unpack_from(content)))


def _orientation(x: float, y: float, z: float, w: float) -> Rotations:
    orientation = unit_quaternion(x, y, z, w)
    if orientation is None:
        raise ValueError
    return orientation


def _acceleration(content: bytes) -> TrackerAcceleration:
    if not all(map(math.isfinite, _ACCELERATION.unpack_from(content))):
        raise ValueError
    return TrackerAcceleration(content[_ACCELERATION.size] if len(content) > _ACCELERATION.size else 0)


def _flex(content: bytes) -> TrackerFlex:
    sensor, value = _FLEX.unpack_from(content)
    if not math.isfinite(value):
        raise ValueError
    return TrackerFlex(sensor, value)


def _battery(content: bytes) -> TrackerBattery:
    """Volts and share; owoTrack sends the share alone."""
    share = (_BATTERY if len(content) >= _BATTERY.size else _SHARE).unpack_from(content)[-1]
    if not 0.0 <= share <= 1.0:
        raise ValueError
    return TrackerBattery(share)


def _sensor(content: bytes) -> TrackerSensor:
    return TrackerSensor(*_SENSOR.unpack_from(content))


_READERS: Final[Mapping[int, tuple[int, Callable[[bytes], TrackerContent]]]] = {
    HANDSHAKE: (_BUILD.size + _MAC_BYTES, _handshake),
    ROTATION_OF_FIRST: (_QUATERNION.size, _rotation_of_first),
    ROTATION_OF_SECOND: (_QUATERNION.size, _rotation_of_second),
    ROTATION: (_ROTATION.size, _rotation),
    ACCELERATION: (_ACCELERATION.size, _acceleration),
    FLEX: (_FLEX.size, _flex),
    BATTERY: (_SHARE.size, _battery),
    SENSOR: (_SENSOR.size, _sensor),
}
"""Least length of the content of each kind, and what reads it."""
