"""Output to a ROS 2 chair: `geometry_msgs/Twist` on /cmd_vel. The only importer of cyclonedds; needs no ROS.

ROS 2 calls this topic `rt/cmd_vel` and the type `geometry_msgs::msg::dds_::Twist_` on the wire; a sample is 52 bytes,
`00 01 00 00` (plain CDR, little-endian) and six float64: linear x, y, z, angular x, y, z. The network is
set by CycloneDDS's own variable, CYCLONEDDS_URI.
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
EVERY = 0.04  # s between samples: with steps of 10 ms, 50 ms never pass without one
CLOSING_LIMIT = 200_000_000  # ns that closing waits at most for the receipt of the zeros
LARGEST_DOMAIN = 232  # DDS has no ports above it

Vector3: Any = make_idl_struct(
    "Vector3", "geometry_msgs::msg::dds_::Vector3_", {"x": float64, "y": float64, "z": float64}
)
RosTwist: Any = make_idl_struct("RosTwist", "geometry_msgs::msg::dds_::Twist_", {"linear": Vector3, "angular": Vector3})

# ROS 2 subscribers ask for reliable samples by default; only the newest sample counts, and writing never waits.
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
        """Join the ROS 2 domain of ROS_DOMAIN_ID; raise OutputRefused when DDS cannot start."""
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
        """Publish `twist` when it has changed or is due again; raise OSError when DDS does not accept it."""
        if twist == self._last and t < self._due:
            return
        try:
            self._writer.write(sample(twist))
        except DDSException as error:
            self._last = None
            raise OSError(errno.EIO, f"DDS does not take {TOPIC} ({error.msg})") from error
        self._last, self._due = twist, t + EVERY

    def close(self) -> None:
        """Publish zeros, and leave the domain."""
        # cyclonedds 11.0.1 raises AttributeError when the wait for the acknowledgement times out.
        with suppress(DDSException, AttributeError):
            self._writer.write(sample(STANDSTILL))
            self._writer.wait_for_acks(CLOSING_LIMIT)


def sample(twist: Twist) -> Any:
    """Return the ROS 2 message of a twist."""
    return RosTwist(linear=Vector3(x=twist.v, y=0.0, z=0.0), angular=Vector3(x=0.0, y=0.0, z=twist.omega))
