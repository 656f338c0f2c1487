"""FreePIE's UDP: flags and twelve numbers a datagram, of which three are angles.

Source: opentrack's input "FreePIE UDP receiver", which uses the angles with opentrack's own signs; so does this file.
"""

import math
import struct

from app.clock import Clock
from app.hardware.configs import FreepieConfig
from app.hardware.head.udp_head import UdpHead
from app.messages import HeadPose

RECORD = struct.Struct("<BB12f")  # device, flags, twelve numbers
RAW, ORIENTATION = 1, 2  # flags: the groups of numbers that are present, raw ones first
ANGLES_AT = {ORIENTATION: 0, RAW | ORIENTATION: 9}  # where yaw (right positive), pitch (up) and roll (left) stand, rad
FURTHEST = math.tau  # rad: a larger angle is not that of a head


def decode(datagram: bytes, t: float) -> HeadPose | None:
    """Return the pose in 50 bytes that came at `t` (s); None without angles, or with an impossible one."""
    _, flags, *numbers = RECORD.unpack(datagram)
    place = ANGLES_AT.get(flags)
    if place is None:
        return None
    yaw, pitch, roll = numbers[place : place + 3]
    if not all(abs(angle) <= FURTHEST for angle in (yaw, pitch, roll)):
        return None
    return HeadPose(t, -yaw, pitch, -roll)


class Freepie(UdpHead):
    """Listens for FreePIE, or for a phone app with its protocol."""

    def __init__(self, config: FreepieConfig, clock: Clock) -> None:
        super().__init__("FreePIE", config.host, config.port, RECORD.size, decode, clock)
