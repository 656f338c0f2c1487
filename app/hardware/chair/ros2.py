"""Output to a ROS 2 chair, robot or simulator: `geometry_msgs/Twist` or `TwistStamped`. Needs no ROS.

A Twist is 52 bytes, `00 01 00 00` (plain CDR, little-endian) and six float64: linear x, y, z, angular x, y, z. A
TwistStamped has before the six a time, which is 0 here, and the frame. ros2_control's controllers take the time 0 for
the time at which the message came, so no clock of two machines has to agree.
"""

import re
from typing import Any

from cyclonedds.idl import make_idl_struct
from cyclonedds.idl.types import float64, int32, uint32

from app.geometry import STANDSTILL, Twist
from app.hardware.chair.dds import PublishedTopic
from app.hardware.chair.outputs import FASTEST_TWIST, OutputRefused
from app.hardware.chair.readings import NO_READINGS, NO_TABLE, ChairReadings

PLAIN, STAMPED = "Twist", "TwistStamped"
TOPIC, FRAME = "/cmd_vel", "base_link"
TOPIC_NAME = re.compile(r"(/[A-Za-z_][A-Za-z0-9_]*)+")  # an absolute name of ROS 2
FRAME_NAME = re.compile(r"[A-Za-z0-9_./-]+")
LONGEST_NAME = 200

Vector3: Any = make_idl_struct(
    "Vector3", "geometry_msgs::msg::dds_::Vector3_", {"x": float64, "y": float64, "z": float64}
)
RosTwist: Any = make_idl_struct("RosTwist", "geometry_msgs::msg::dds_::Twist_", {"linear": Vector3, "angular": Vector3})
RosTime: Any = make_idl_struct("RosTime", "builtin_interfaces::msg::dds_::Time_", {"sec": int32, "nanosec": uint32})
RosHeader: Any = make_idl_struct("RosHeader", "std_msgs::msg::dds_::Header_", {"stamp": RosTime, "frame_id": str})
RosTwistStamped: Any = make_idl_struct(
    "RosTwistStamped", "geometry_msgs::msg::dds_::TwistStamped_", {"header": RosHeader, "twist": RosTwist}
)


class Ros2Twist:
    """Publishes at every change and at least every 50 ms, zeros while the chair is disarmed.

    For silence what listens has its own limit: 0.5 s with ros2_control's diff_drive_controller (`cmd_vel_timeout`),
    none at all with many drivers. A listener that was killed counts as one for up to 10 s, after which DDS forgets it.
    """

    is_real = True
    most = FASTEST_TWIST
    table = NO_TABLE

    def __init__(self, topic: str = TOPIC, message: str = PLAIN, frame: str | None = None) -> None:
        """Join the ROS 2 domain of ROS_DOMAIN_ID; raise OutputRefused for a name that is none, or without DDS."""
        if not TOPIC_NAME.fullmatch(topic) or len(topic) > LONGEST_NAME:
            raise OutputRefused(f"--topic '{topic}' is no topic of ROS 2: give one such as {TOPIC}")
        if frame is not None and message != STAMPED:
            raise OutputRefused(f"--frame is of {STAMPED}: leave it out, or add --message {STAMPED}")
        self._frame = FRAME if frame is None else frame
        if not FRAME_NAME.fullmatch(self._frame) or len(self._frame) > LONGEST_NAME:
            raise OutputRefused(f"--frame '{frame}' is no frame of ROS 2: give one such as {FRAME}")
        self._message = message
        self._topic = PublishedTopic(topic, RosTwistStamped if message == STAMPED else RosTwist)

    def poll(self, t: float) -> ChairReadings:
        """Return no readings; OSError when nobody listens."""
        self._topic.require_listener(t)
        return NO_READINGS

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:  # noqa: ARG002
        """Publish `twist` when it has changed or is due again; OSError when DDS does not accept it."""
        self._topic.publish(twist, self._sample(twist), t)

    def description(self) -> str:
        """Return who listens."""
        return (
            f"The topic {self._topic.name} of ROS 2 ({self._message}): {self._topic.listeners()} listening. Zeros go "
            "to it while nothing is armed. What listens must stop by itself when nothing comes any more."
        )

    def close(self) -> None:
        """Publish zeros, and leave the domain."""
        self._topic.close(self._sample(STANDSTILL))

    def _sample(self, twist: Twist) -> Any:
        return stamped_sample(twist, self._frame) if self._message == STAMPED else sample(twist)


def sample(twist: Twist) -> Any:
    """Return the ROS 2 message of a twist."""
    return RosTwist(linear=Vector3(x=twist.v, y=0.0, z=0.0), angular=Vector3(x=0.0, y=0.0, z=twist.omega))


def stamped_sample(twist: Twist, frame: str) -> Any:
    """Return the ROS 2 message of a twist with a frame and the time 0."""
    return RosTwistStamped(header=RosHeader(stamp=RosTime(sec=0, nanosec=0), frame_id=frame), twist=sample(twist))
