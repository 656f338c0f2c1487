"""A topic of ROS 2 over DDS, published without ROS. Only `ros2.py`, `luci.py` and this file import cyclonedds.

ROS 2 calls a topic `rt/` and its name on the wire, and a type `PACKAGE::msg::dds_::NAME_`. The network is set by
CycloneDDS's own variable, CYCLONEDDS_URI, the domain by ROS_DOMAIN_ID.
"""

import errno
import math
import os
from contextlib import suppress
from typing import Any

from cyclonedds.core import DDSException, Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.topic import Topic

from app.hardware.chair.outputs import OutputRefused

EVERY = 0.04  # s between samples: with steps of 10 ms, 50 ms never pass without one
LOOK_EVERY = 0.1  # s between two looks whether anybody listens
CLOSING_LIMIT = 200_000_000  # ns that closing waits at most for the receipt of the last sample
LARGEST_DOMAIN = 232  # DDS has no ports above it

# ROS 2 subscribers ask for reliable samples by default; only the newest sample counts, and writing never waits.
QOS = Qos(
    Policy.Reliability.Reliable(max_blocking_time=0),
    Policy.History.KeepLast(1),
    Policy.Durability.Volatile,
    Policy.DataRepresentation(use_cdrv0_representation=True),
)


class PublishedTopic:
    """A topic that is published at every change and at least every 50 ms.

    Attributes
    ----------
    name : str
        As ROS 2 calls the topic.
    participant : DomainParticipant
    """

    def __init__(self, name: str, kind: Any) -> None:
        """Join the ROS 2 domain of ROS_DOMAIN_ID; raise OutputRefused when DDS cannot start."""
        self.name = name
        domain = os.environ.get("ROS_DOMAIN_ID", "").strip() or "0"
        if not (domain.isdecimal() and int(domain) <= LARGEST_DOMAIN):
            raise OutputRefused(f"ROS_DOMAIN_ID is '{domain}': give it a number from 0 to {LARGEST_DOMAIN}")
        try:
            self.participant = DomainParticipant(int(domain))
            topic: Any = Topic(self.participant, wire_name(name), kind)
            self._writer: Any = DataWriter(self.participant, topic, qos=QOS)
        except DDSException as error:
            raise OutputRefused(
                f"DDS does not start in the ROS 2 domain {domain} ({error.msg}): look at CYCLONEDDS_URI and the network"
            ) from error
        self._last: object = None  # the value that was published last; None: none
        self._due = self._look_due = -math.inf  # s
        self._is_heard = False

    def require_listener(self, t: float) -> None:
        """Raise OSError when nobody listened to the topic at the last look, which is at most 0.1 s before `t` (s)."""
        if t >= self._look_due:
            self._look_due = t + LOOK_EVERY
            self._is_heard = self.listeners() > 0
        if not self._is_heard:
            raise OSError(errno.ENOTCONN, f"nobody listens to {self.name}")

    def listeners(self) -> int:
        """Return how many programs listen to the topic now."""
        with suppress(DDSException):
            return len(self._writer.get_matched_subscriptions())
        return 0

    def publish(self, value: object, sample: Any, t: float) -> None:
        """Publish the `sample` of a `value` that has changed or is due again at `t` (s).

        Raises
        ------
        OSError
            When DDS does not accept it.
        """
        if value == self._last and t < self._due:
            return
        try:
            self._writer.write(sample)
        except DDSException as error:
            self._last = None
            raise OSError(errno.EIO, f"DDS does not take {self.name} ({error.msg})") from error
        self._last, self._due = value, t + EVERY

    def close(self, sample: Any) -> None:
        """Publish a last `sample` where anything was published, and leave the domain."""
        if self._last is None:
            return
        # cyclonedds 11.0.1 raises AttributeError when the wait for the acknowledgement times out.
        with suppress(DDSException, AttributeError):
            self._writer.write(sample)
            self._writer.wait_for_acks(CLOSING_LIMIT)


def wire_name(name: str) -> str:
    """Return what DDS calls a topic of ROS 2."""
    return f"rt/{name.removeprefix('/')}"
