"""opentrack's output "UDP over network": six numbers a datagram.

Source of the signs: opentrack's own trackers and outputs. Its SteamVR tracker takes OpenVR's axes (right, up, back) as
-x, y, z, and its outputs for SimConnect and FlightGear reverse that. An axis that is inverted in opentrack's options is
inverted here too.
"""

import math
import struct

from app.clock import Clock
from app.hardware.configs import OpentrackConfig
from app.hardware.head.udp_head import UdpHead
from app.messages import HeadPose

RECORD = struct.Struct("<6d")  # x, y, z in cm (left, up, back); yaw (right positive), pitch (up), roll (left), degrees
FURTHEST = 360.0  # degrees: a larger angle is not that of a head
CM = 0.01  # m


def decode(datagram: bytes, t: float) -> HeadPose | None:
    """Return the pose in 48 bytes that came at `t` (s); None when a number is not finite or an angle is impossible."""
    x, y, z, yaw, pitch, roll = RECORD.unpack(datagram)
    if not all(map(math.isfinite, (x, y, z))) or not all(abs(angle) <= FURTHEST for angle in (yaw, pitch, roll)):
        return None
    angles = (math.radians(-yaw), math.radians(pitch), math.radians(-roll))
    return HeadPose(t, *angles, -z * CM, x * CM, y * CM)


class Opentrack(UdpHead):
    """Listens for opentrack."""

    def __init__(self, config: OpentrackConfig, clock: Clock) -> None:
        super().__init__("opentrack", config.host, config.port, RECORD.size, decode, clock)
