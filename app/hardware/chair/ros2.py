"""A chair that listens to ROS 2: `geometry_msgs/Twist` on /cmd_vel. The only home of cyclonedds; ROS is not needed.

ROS 2 calls this topic `rt/cmd_vel` and the type `geometry_msgs::msg::dds_::Twist_` on the wire; a sample is 52 bytes,
`00 01 00 00` (plain CDR, little-endian) and six float64: linear x, y, z, angular x, y, z. Which network it uses is
said by CycloneDDS's own variable, CYCLONEDDS_URI.
"""

import errno
import os
from contextlib import suppress
from typing import Any

from cyclonedds.core import DDSException, Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.idl import make_idl_struct
from cyclonedds.idl.types import float64
from cyclonedds.pub import DataWriter
from cyclonedds.topic import Topic

from app.geometry import STANDSTILL, Twist
from app.hardware.chair.outputs import OutputRefused

TOPIC = "rt/cmd_vel"
EVERY = 0.04  # s: looked at every 10 ms, so that 50 ms never pass without a sample
LAST_WORD = 200_000_000  # ns that closing waits, at most, until the zeros were received
LARGEST_DOMAIN = 232  # above it DDS has no ports

Vector3: Any = make_idl_struct(
    "Vector3", "geometry_msgs::msg::dds_::Vector3_", {"x": float64, "y": float64, "z": float64}
)
RosTwist: Any = make_idl_struct("RosTwist", "geometry_msgs::msg::dds_::Twist_", {"linear": Vector3, "angular": Vector3})

# Who listens in ROS 2 asks for reliable samples by default; only the newest one counts, and nothing is waited for.
QOS = Qos(
    Policy.Reliability.Reliable(max_blocking_time=0),
    Policy.History.KeepLast(1),
    Policy.Durability.Volatile,
    Policy.DataRepresentation(use_cdrv0_representation=True),
)


class Ros2Twist:
    """Publishes at every change and at least every 50 ms, zeros while the chair is disarmed."""

    is_real = True

    def __init__(self) -> None:
        """Join the ROS 2 domain of ROS_DOMAIN_ID; raise OutputRefused when that cannot be had."""
        domain = os.environ.get("ROS_DOMAIN_ID", "").strip() or "0"
        if not (domain.isdecimal() and int(domain) <= LARGEST_DOMAIN):
            raise OutputRefused(f"ROS_DOMAIN_ID is '{domain}': give it a number from 0 to {LARGEST_DOMAIN}")
        try:
            self._participant = DomainParticipant(int(domain))
            self._writer: Any = DataWriter(self._participant, Topic(self._participant, TOPIC, RosTwist), qos=QOS)
        except DDSException as error:
            raise OutputRefused(
                f"DDS does not start in the ROS 2 domain {domain} ({error.msg}): look at CYCLONEDDS_URI and the network"
            ) from error
        self._last: Twist | None = None
        self._due = 0.0

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:  # noqa: ARG002
        """Publish `twist` when it is another one, or was not said for long; raise OSError when DDS does not take it."""
        if twist == self._last and t < self._due:
            return
        try:
            self._writer.write(sample(twist))
        except DDSException as error:
            self._last = None
            raise OSError(errno.EIO, f"DDS does not take {TOPIC} ({error.msg})") from error
        self._last, self._due = twist, t + EVERY

    def close(self) -> None:
        """Publish zeros, and leave."""
        # AttributeError: how cyclonedds 11.0.1 says that the time for the acknowledgement is over.
        with suppress(DDSException, AttributeError):
            self._writer.write(sample(STANDSTILL))
            self._writer.wait_for_acks(LAST_WORD)


def sample(twist: Twist) -> Any:
    """Return what ROS 2 calls this twist."""
    return RosTwist(linear=Vector3(x=twist.v, y=0.0, z=0.0), angular=Vector3(x=0.0, y=0.0, z=twist.omega))
