"""What listens at the far end of the outputs over DDS, in the domain of ROS_DOMAIN_ID."""

import os

from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

from app.hardware.chair.chair_document import ASSUMED_SPEED, ASSUMED_TURN_RATE, FULL
from app.hardware.chair.dds import QOS
from app.hardware.chair.luci import LuciJoystick
from app.hardware.chair.ros2 import RosTwist

MOST_MESSAGES = 100  # between two looks


class _Listener:
    """A program that listens to a topic and keeps its newest message."""

    options = ()

    def __init__(self, topic_name, kind):
        self._participant = DomainParticipant(int(os.environ["ROS_DOMAIN_ID"]))
        wants = Qos(Policy.Reliability.Reliable(max_blocking_time=0), Policy.History.KeepLast(MOST_MESSAGES))
        self._reader = DataReader(self._participant, Topic(self._participant, topic_name, kind), qos=wants)
        self._kind, self._newest = kind, None

    def _look(self):
        messages = [each for each in self._reader.take(MOST_MESSAGES) if isinstance(each, self._kind)]
        self._newest = messages[-1] if messages else self._newest
        return self._newest

    def close(self):
        """Do nothing: the domain is left with the last reference."""


class RosEnd(_Listener):
    """A robot that listens to /cmd_vel."""

    faults = ()

    def __init__(self, _secret):
        super().__init__("rt/cmd_vel", RosTwist)

    @property
    def speeds(self):
        newest = self._look()
        return (0.0, 0.0) if newest is None else (newest.linear.x, newest.angular.z)


class LuciEnd(_Listener):
    """LUCI's node, and a chair without a chair document."""

    faults = ("hand",)

    def __init__(self, _secret):
        super().__init__("rt/luci/remote_joystick", LuciJoystick)
        own = Topic(self._participant, "rt/luci/joystick_position", LuciJoystick)
        self._writer = DataWriter(self._participant, own, qos=QOS)

    @property
    def speeds(self):
        newest = self._look()
        if newest is None:
            return 0.0, 0.0
        return ASSUMED_SPEED * newest.forward_back / FULL, -ASSUMED_TURN_RATE * newest.left_right / FULL

    def set(self, _fault, is_there):
        position = -40 if is_there else 0
        self._writer.write(LuciJoystick(forward_back=position, left_right=0, joystick_zone=8, input_source=4))
