"""The chair's receiver as a process that publishes to ROS 2, listened to from another process."""

import signal
import time

import pytest
from hardware.chair.ros_network import BETWEEN_PROCESSES
from processes.strange_sender import PATIENCE, Receiver, StrangeSender

core = pytest.importorskip("cyclonedds.core", reason="not every machine has this library: it is the extra ros2")
domain, sub, topic = (pytest.importorskip(f"cyclonedds.{name}") for name in ("domain", "sub", "topic"))
ros2 = pytest.importorskip("app.hardware.chair.ros2")

DOMAIN = 79


def test_ros_hears_every_ramp_and_zeros_at_the_end(tmp_path, monkeypatch):
    monkeypatch.setenv("CYCLONEDDS_URI", BETWEEN_PROCESSES)
    monkeypatch.setenv("ROS_DOMAIN_ID", str(DOMAIN))
    participant = domain.DomainParticipant(DOMAIN)
    wants = core.Qos(core.Policy.Reliability.Reliable(max_blocking_time=0), core.Policy.History.KeepLast(10_000))
    reader = sub.DataReader(participant, topic.Topic(participant, "rt/cmd_vel", ros2.RosTwist), qos=wants)
    heard = []

    def wait_for(condition):
        until = time.monotonic() + PATIENCE
        while time.monotonic() < until:
            heard.extend((told.linear.x, told.angular.z) for told in reader.take(10_000))
            if heard and condition(heard[-1]):
                return
            time.sleep(0.02)
        raise AssertionError(f"ROS was not told so: {heard[-3:]}")

    receiver = Receiver(tmp_path, output="ros2", interpreter=())
    sender = StrangeSender(receiver.port)
    try:
        wait_for(lambda told: told == (0.0, 0.0))
        for _ in range(10):  # a busy machine may stop the chair
            sender.arm()
            sender.drive(0.5, 0.2)
            sender.wait_for(lambda told: told[8] == 0.5 or told[2] == 0)
            if sender.telemetry[-1][2] == 2:
                break
        wait_for(lambda told: told == (0.5, pytest.approx(0.2)))
        assert receiver.end(signal.SIGTERM) == 0, receiver.words
        wait_for(lambda told: told == (0.0, 0.0))
        assert len({v for v, _ in heard}) > 10, "ramps are told as they are driven"
        assert max(v for v, _ in heard) == 0.5
    finally:
        sender.close()
        receiver.close()
