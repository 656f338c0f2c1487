"""Output to a chair with LUCI, through LUCI's node of ROS 2: `luci_messages/LuciJoystick` on /luci/remote_joystick.

The message is four int32: forward_back and left_right (percent, forwards and right positive), joystick_zone (the sector
of the joystick) and input_source. Source: the maker's luci-ros2-msgs and luci-ros2-grpc. LUCI takes only messages whose
input source is the one that was set by its service, which who sets up the chair calls, not this program:

- `ros2 service call /luci/set_shared_remote_input std_srvs/srv/Empty` (input source 5) leaves LUCI's own collision
  avoidance on, and still tells what the chair's own joystick does, on /luci/joystick_position
- the other one, set_auto_remote_input (1), switches the chair's own joystick off: it is not used here
"""

import errno
import math
from pathlib import Path
from typing import Any

from cyclonedds.core import DDSException, Policy, Qos
from cyclonedds.idl import make_idl_struct
from cyclonedds.idl.types import int32
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

from app.geometry import Twist
from app.hardware.chair.chair_document import joystick_table
from app.hardware.chair.dds import PublishedTopic, wire_name
from app.hardware.chair.readings import ChairReadings

COMMAND_TOPIC, OWN_TOPIC = "/luci/remote_joystick", "/luci/joystick_position"
SERVICE = "ros2 service call /luci/set_shared_remote_input std_srvs/srv/Empty"
SHARED_REMOTE = 5  # the input source
ZONES = (0, 2, 4, 6, 7, 5, 3, 1)  # front, then to the right round to front left; the joystick zones of luci_messages
ORIGIN = 8  # the joystick zone of the centre
TOUCHED = 10  # percent from which the chair's own joystick counts as moved
MOST_SAMPLES = 10  # of the chair's own joystick between two steps

LuciJoystick: Any = make_idl_struct(
    "LuciJoystick",
    "luci_messages::msg::dds_::LuciJoystick_",
    {"forward_back": int32, "left_right": int32, "joystick_zone": int32, "input_source": int32},
)
OWN_QOS = Qos(Policy.Reliability.BestEffort, Policy.History.KeepLast(MOST_SAMPLES), Policy.Durability.Volatile)


class LuciRemote:
    """Publishes the joystick at every change and at least every 50 ms, its centre while the chair is disarmed.

    By the maker's page the chair brakes when fewer than 10 messages come in a second. Whoever moves the chair's own
    joystick stops the chair; how often LUCI tells of that joystick is not known.
    """

    is_real = True

    def __init__(self, chair_document: Path | None = None) -> None:
        """Join the ROS 2 domain of ROS_DOMAIN_ID; raise OutputRefused for a wrong document, or without DDS."""
        self._table = joystick_table(chair_document)
        self.most, self.table = self._table.most, self._table.report
        self._topic = PublishedTopic(COMMAND_TOPIC, LuciJoystick)
        participant = self._topic.participant
        own: Any = Topic(participant, wire_name(OWN_TOPIC), LuciJoystick)
        self._own: Any = DataReader(participant, own, qos=OWN_QOS)
        self._is_touched = False
        self._has_told = False  # whether LUCI has told of the chair's own joystick

    def poll(self, t: float) -> ChairReadings:
        """Return whether somebody moves the chair's own joystick; OSError when LUCI's node does not listen."""
        try:
            samples = self._own.take(MOST_SAMPLES)
        except DDSException as error:
            raise OSError(errno.EIO, f"DDS does not read {OWN_TOPIC} ({error.msg})") from error
        told = [each for each in samples if isinstance(each, LuciJoystick)]  # others say that a writer has gone
        if told:
            self._has_told = True
            self._is_touched = max(abs(told[-1].forward_back), abs(told[-1].left_right)) >= TOUCHED
        self._topic.require_listener(t)
        return ChairReadings(own_joystick=self._is_touched)

    def drive(self, t: float, state: str, twist: Twist, reason: str) -> None:  # noqa: ARG002
        """Publish the joystick of `twist` when it has changed or is due again; OSError when DDS does not accept it."""
        self.deflect(t, state == "armed", *self._table.deflection(twist))

    def deflect(self, t: float, is_driven: bool, ahead: float, right: float) -> None:  # noqa: ARG002
        """Publish a deflection in percent when it has changed or is due again."""
        self._topic.publish((ahead, right), joystick_of(ahead, right), t)

    def description(self) -> str:
        """Return what was found of LUCI, and what is to be set there."""
        own = "at rest" if not self._is_touched else "moved"
        return (
            f"LUCI's node of ROS 2: {self._topic.listeners()} listening to {COMMAND_TOPIC}; the chair's own joystick "
            f"is {own if self._has_told else 'not reported'}. LUCI obeys after `{SERVICE}`, which you call yourself: "
            f"its collision avoidance and the chair's own joystick stay on. {self._table.note}"
        )

    def close(self) -> None:
        """Publish the centre, and leave the domain."""
        self._topic.close(joystick_of(0.0, 0.0))


def joystick_of(ahead: float, right: float) -> Any:
    """Return LUCI's message of a deflection in percent."""
    forward_back, left_right = round(ahead), round(right)
    zone = ORIGIN
    if forward_back or left_right:
        zone = ZONES[round(math.atan2(left_right, forward_back) / (math.pi / 4)) % len(ZONES)]
    return LuciJoystick(
        forward_back=forward_back, left_right=left_right, joystick_zone=zone, input_source=SHARED_REMOTE
    )
